// What a user should know of a pack's counters: `warn.<image>.<texel> = text` lines of shaders.properties. Iris passes
// over them.
#pragma once

#include <string>
#include <vector>

#include <orris/core/diagnostic.h>
#include <orris/glsl/preprocess/preprocessor.h>
#include <orris/pack/properties/shader_properties.h>

namespace orris {

/// `warn.light_state.2 = lamps have no room`: reported, after the number, while it is not 0.
struct CounterWarning {
  std::string image;
  int texel = 0;
  std::string text;
  SourceLocation at;
};

/// Does the pack count in this image: whole numbers in one short row?
bool isCounter(const CustomImage& image);

/// In the order of the file. A line that names no counter of `properties` is left out and warned about
/// (`counter-warning`).
std::vector<CounterWarning> parseCounterWarnings(const std::string& file, const std::string& text,
                                                 const MacroDefinitions& macros,
                                                 const ShaderProperties& properties,
                                                 Diagnostics& diagnostics);

}  // namespace orris
