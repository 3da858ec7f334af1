// Names that an #if asks for and that nothing defines: they count as 0, and nobody says so.
#pragma once

#include <span>

#include <orris/core/diagnostic.h>
#include <orris/pack/shader_pack.h>

namespace orris {

/// condition-undefined, once for each name: a warning where it is a slip away from an option or macro,
/// of #ifdef too; else a note. Not names that the pack asks `defined` for, nor those of drivers.
void checkConditionNames(std::span<const ShaderPack> folders, Diagnostics& diagnostics);

}  // namespace orris
