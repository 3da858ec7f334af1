// Other mods whose programs a pack may carry: they are checked as if the mod were there, and never
// drawn. Contract: programs.csv dh_*, uniforms.csv dh*.
#pragma once

#include <span>
#include <string_view>

#include <orris/core/diagnostic.h>
#include <orris/glsl/rewrite/rewrite.h>
#include <orris/pack/programs/program_id.h>

namespace orris {

/// What a mod adds to the environment of its programs.
struct ModFamily {
  std::string_view name;  ///< for people: "Distant Horizons"
  ProgramGroup group;
  std::string_view macro;           ///< defined while the mod is there
  std::span<const HostName> names;  ///< what its shader code declares for the pack's
  std::string_view value{};         ///< of the macro
};

std::span<const ModFamily> modFamilies();
/// nullptr for the groups of the host itself.
const ModFamily* modFamilyOf(ProgramGroup group);

/// Findings in a program of `mod`: the pack runs without it, so none is more than a warning.
void markAsOfMod(std::string_view mod, Diagnostics& diagnostics);

}  // namespace orris
