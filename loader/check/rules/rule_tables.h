// The rows of ruleTable(), a table for each topic.
#pragma once

#include <span>

#include <orris/check/rules/rules.h>

namespace orris {

std::span<const Rule> chartRules();      ///< charts and tuning
std::span<const Rule> frameRules();      ///< what the frame reads and writes
std::span<const Rule> glslRules();       ///< compiling and linking
std::span<const Rule> hostRules();       ///< packs, files and this machine
std::span<const Rule> idRules();         ///< id maps
std::span<const Rule> interfaceRules();  ///< uniforms, samplers, attributes, varyings, outputs
std::span<const Rule> matrixRules();     ///< option combinations and the run itself
std::span<const Rule> optionRules();     ///< options, profiles, screens, languages
std::span<const Rule> propertyRules();   ///< shaders.properties
std::span<const Rule> reportRules();     ///< silencing, baselines, explained logs
std::span<const Rule> targetRules();     ///< render targets and directives in sources
std::span<const Rule> textRules();       ///< includes and preprocessing

}  // namespace orris
