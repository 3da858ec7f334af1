// Feature flags that packs require or ask for. Contract: contract/README "Feature flags".
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "glsl/preprocessor.h"
#include "pack/shader_properties.h"

namespace orris {

/// Flags of iris.features.* and of orris.features.* that this host offers, upper case.
const std::vector<std::string>& supportedFeatures();
const std::vector<std::string>& supportedOrrisFeatures();

/// Errors for required flags that the host lacks, and for buffers and images without their flag.
void checkFeatures(const ShaderProperties& properties, const std::string& file,
                   Diagnostics& diagnostics);

/// IRIS_FEATURE_* and ORRIS_FEATURE_* as the *.properties files see them (all supported flags), and
/// as shaders see them (those listed as optional).
MacroDefinitions propertyFeatureMacros();
MacroDefinitions shaderFeatureMacros(const ShaderProperties& properties);

}  // namespace orris
