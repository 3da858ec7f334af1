// Functions that no program calls. Iris parses them, and leaves them out of what the driver gets.
#pragma once

#include <span>

#include "core/diagnostic.h"
#include "pack/shader_pack.h"

namespace orris {

/// A syntax error in one refuses the program in the game, whoever calls it.
void checkUnusedSyntax(const ShaderPack& pack, const StageText& stage, Diagnostics& diagnostics);

/// Warnings of functions that no program of `folders` calls and that compile in none of those that
/// contain them. Iris: CompatibilityTransformer.transformEach.
void checkUnusedFunctions(std::span<const ShaderPack> folders, Diagnostics& diagnostics);

}  // namespace orris
