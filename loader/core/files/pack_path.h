// Paths inside a pack: absolute, '/'-separated, normalised, never outside the root.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace orris {

/// What ".." does at the root.
enum class AboveRoot {
  Refuse,
  Stay,   ///< nothing. Iris: AbsolutePackPath
  Beside  ///< once, into the folder that holds the root: the path starts with "/../"
};

/// Resolves `path` as written in the file `from` ("/lib/a.glsl"): an absolute path starts at the
/// root, any other at the folder of `from`; "." and ".." are resolved. nullopt when the path is
/// empty, holds a NUL or backslash, or would leave the root (Beside: the folder that holds it).
std::optional<std::string> resolvePackPath(std::string_view from, std::string_view path,
                                           AboveRoot aboveRoot = AboveRoot::Refuse);

/// "/world0/composite.fsh" -> "/world0"; "/a" -> "/".
std::string_view packPathParent(std::string_view path);

}  // namespace orris
