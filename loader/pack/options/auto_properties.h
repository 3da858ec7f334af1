// The `auto.<option>.<value>` keys of shaders.properties.
#pragma once

#include <string>
#include <vector>

#include <orris/core/diagnostic.h>
#include <orris/glsl/preprocess/preprocessor.h>
#include <orris/pack/options/auto_option.h>
#include <orris/pack/options/options.h>
#include <orris/pack/properties/shader_properties.h>

namespace orris {

/// Does the pack list the feature AUTO_OPTIONS? Without it the keys mean nothing.
bool asksForAuto(const ShaderProperties& properties);

/// Candidates in the order of the file. Names are compared without case, since the macro of an
/// option would take the place of its name. A line with a mistake is left out and warned about (`auto-option`).
std::vector<AutoCandidate> parseAutoOptions(const std::string& file, const std::string& text,
                                            const MacroDefinitions& macros,
                                            const OptionSet& options, Diagnostics& diagnostics);

}  // namespace orris
