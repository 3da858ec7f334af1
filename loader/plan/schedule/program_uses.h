// Which host names a program really mentions, found in its final text (no GL needed).
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>

#include <orris/pack/shader_pack.h>

namespace orris {

/// Identifiers that occur at least twice in a stage: a declaration that nothing uses does not count,
/// as a GL driver would not report it active.
using ProgramUses = std::set<std::string, std::less<>>;
ProgramUses usesOf(const ProgramSource& program);

/// A buffer as a sampler or image name means it.
struct BufferName {
  enum class Kind { Color, ShadowColor, Depth, ShadowDepth, Stencil } kind = Kind::Color;
  int index = 0;
  bool image = false;
};
/// "gaux1", "colorimg3", "shadowtex0HW", "shadow"...; nullopt for any other name. `watershadow` says
/// that the program declares it, which turns "shadow" into shadowtex1.
std::optional<BufferName> parseBufferName(std::string_view name, bool watershadow);

}  // namespace orris
