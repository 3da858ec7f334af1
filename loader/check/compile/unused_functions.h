// Functions that no program calls. Iris parses them, and leaves them out of what the driver gets.
#pragma once

#include <span>

#include <orris/check/compile/program_check.h>
#include <orris/core/diagnostic.h>
#include <orris/pack/shader_pack.h>

namespace orris {

/// A syntax error in one refuses the program in the game, whoever calls it.
void checkUnusedSyntax(const ShaderPack& pack, const StageText& stage, Diagnostics& diagnostics);

/// Warnings of functions that no program of `folders` calls and that compile in none of those that
/// contain them and have no bad verdict: a program that fails has its own errors first.
/// Iris: CompatibilityTransformer.transformEach. `jobs` as in isolated_jobs.h.
void checkUnusedFunctions(std::span<const ShaderPack> folders, int jobs, const Verdicts& verdicts,
                          Diagnostics& diagnostics);

}  // namespace orris
