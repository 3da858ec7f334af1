// Checking programs one by one, each distinct text once.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/diagnostic.h"
#include "pack/shader_pack.h"

namespace orris {

/// A set of stages that link together: a program, or one of its compute shaders.
struct ProgramUnit {
  std::string name;  ///< "/world0/composite3", of a compute shader "/world0/composite3_a.csh"
  std::uint64_t hash = 0;
  std::vector<const StageText*> stages;
  std::string_view mod{};  ///< the mod that would draw with it ("Distant Horizons"), "" for none
};

/// All units of a pack, in frame order; those of other mods last.
std::vector<ProgramUnit> programUnits(const ShaderPack& pack);

/// Verdicts by hash, so that a text shared by dimensions or profiles is checked once.
using Verdicts = std::map<std::uint64_t, bool>;

/// Validates with glslang those units of `pack` that `verdicts` lacks, on `jobs` threads, and adds
/// their verdicts. Diagnostics come in the order of the units whatever the number of threads.
void checkWithGlslang(const ShaderPack& pack, int jobs, Verdicts& verdicts,
                      Diagnostics& diagnostics);

/// The same with the GL driver of the current context.
void checkWithDriver(const ShaderPack& pack, Verdicts& verdicts, Diagnostics& diagnostics);

/// One note for each rewrite rule that fired in a program.
Diagnostics ruleNotes(const ShaderPack& pack);

}  // namespace orris
