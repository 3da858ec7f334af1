// Feature flags that packs require or ask for. Contract: contract/README "Feature flags".
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <orris/glsl/preprocess/preprocessor.h>
#include <orris/pack/properties/property_keys.h>
#include <orris/pack/shader_pack.h>

namespace orris {

/// Program "shadowvolume" draws the volumes that casters keep the light from; what it counts is
/// readable as the usampler2D stenciltex0.
inline constexpr const char* kShadowVolumes = "STENCIL_SHADOW_VOLUMES";

/// Options whose value is AUTO get the value whose cost the pack's `auto.*` lines put lowest.
inline constexpr const char* kAutoOptions = "AUTO_OPTIONS";

/// Flags of iris.features.* that this host offers as that version of Iris, and of orris.features.*;
/// upper case.
std::vector<std::string> supportedFeatures(const Version& iris = HostVersions().iris);
const std::vector<std::string>& supportedOrrisFeatures();

/// An error for each flag on the entry's line that `supported` lacks.
void requireFeatures(const PropertyContext& context, const std::vector<std::string>& supported);

/// A warning for each optional flag of Iris's in lower case.
void warnOfFlagCase(const PropertyContext& context);

/// Errors for buffer objects and custom images without their flag.
void checkDeclared(const ShaderProperties& properties, Diagnostics& diagnostics);

/// Errors for programs that draw to shadowcolor2 and up without the flag for them.
void checkShadowColors(const ProgramList& programs, const ShaderProperties& properties,
                       Diagnostics& diagnostics);

/// IRIS_FEATURE_* and ORRIS_FEATURE_* as the *.properties files see them (all supported flags), and
/// as shaders see them (those listed as optional).
MacroDefinitions propertyFeatureMacros(const Version& iris);
MacroDefinitions shaderFeatureMacros(const ShaderProperties& properties,
                                     const Version& iris = HostVersions().iris);

}  // namespace orris
