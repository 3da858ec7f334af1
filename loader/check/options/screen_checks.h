// Checks of screens, sliders and profiles beyond those that reading them makes.
#pragma once

#include <span>

#include <orris/core/diagnostic.h>
#include <orris/pack/shader_pack.h>

namespace orris {

/// Screens that no other screen links to, and numbers of columns for screens that do not exist.
void checkScreenLinks(std::span<const ShaderPack> folders, Diagnostics& diagnostics);

/// Sliders that name no option, or one that has no list of values.
void checkSliders(std::span<const ShaderPack> folders, Diagnostics& diagnostics);

/// Profiles that are equal, that no screen offers, or that disable unknown programs.
void checkProfiles(std::span<const ShaderPack> folders, Diagnostics& diagnostics);

}  // namespace orris
