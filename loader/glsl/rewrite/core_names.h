// What stands in a core-profile context for the names of old GLSL. The uniforms and attributes of the
// replacements are given by the frame (plan/frame/core_profile_uniforms.h, render/scene/vertex_layout.h).
#pragma once

#include <array>
#include <string_view>

#include <orris/glsl/rewrite/rewrite.h>

namespace orris {

struct CoreName {
  std::string_view name;         ///< of old GLSL
  std::string_view replacement;  ///< an expression, or a variable where it can be written
  /// GLSL that must stand before the first use, in this order; "" for none.
  std::array<std::string_view, 3> declarations{};
};

/// nullptr: no such name in that stage.
const CoreName* findCoreName(Stage stage, std::string_view name);

/// An output of the stage before for an input that findCoreName() declares; "" for another declaration.
std::string_view outputForInput(std::string_view declaration);

}  // namespace orris
