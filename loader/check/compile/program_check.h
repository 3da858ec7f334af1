// Checking programs one by one, each distinct text once.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <orris/check/workers/isolated_jobs.h>
#include <orris/core/diagnostic.h>
#include <orris/pack/shader_pack.h>

namespace orris {

class TrialMemo;

/// A set of stages that link together: a program, or one of its compute shaders.
struct ProgramUnit {
  std::string name;  ///< "/world0/composite3", of a compute shader "/world0/composite3_a.csh"
  std::uint64_t hash = 0;
  std::vector<const StageText*> stages;
  std::vector<const StageText*> judged;    ///< what glslang judges: Iris's text, or else `stages`
  const ProgramSource* program = nullptr;  ///< that it is of
  std::string_view mod{};   ///< the mod that would draw with it ("Distant Horizons"), "" for none
  bool incomplete = false;  ///< an #include is missing: reported, and not to be compiled
  bool refused = false;     ///< Iris refuses it, whatever a compiler says: reported
};

/// All units of a pack, in frame order; those of other mods last.
std::vector<ProgramUnit> programUnits(const ShaderPack& pack);
std::vector<ProgramUnit> programUnits(const ProgramSource& program);
/// Does a comment swallow the rest of one of its stages? It is reported, and what it hides is not there.
bool hasUnclosedComment(const ProgramSource& program);

/// Verdicts by hash, so that a text shared by dimensions or profiles is checked once.
using Verdicts = std::map<std::uint64_t, bool>;

/// Those that `verdicts` lacks, equal ones once.
std::vector<ProgramUnit> unitsWithoutVerdict(const ShaderPack& pack, const Verdicts& verdicts);
/// The file that the unit is named after, of the fragment shader if there is one.
std::string entryFile(const ProgramUnit& unit);

/// Validates with glslang those units of `pack` that `verdicts` lacks, in `jobs` processes, and adds
/// their verdicts. Diagnostics come in the order of the units whatever the number of processes. A
/// unit that kills or stalls the compiler is reported (compiler-crash, compiler-timeout), the others
/// are checked all the same. See check/workers/isolated_jobs.h for what the caller must not have. `quiet`,
/// when given, learns the units that nothing at all was reported of: with their verdicts given, another
/// check of equal units reports the same. `trials`, when given, lends and learns what lines that seem to
/// be missing were found to do.
void checkWithGlslang(const ShaderPack& pack, int jobs, Verdicts& verdicts, Diagnostics& diagnostics,
                      std::set<std::uint64_t>* quiet = nullptr, TrialMemo* trials = nullptr);

/// What is reported of a unit or program whose check did not end well. `file` is its entry file.
Diagnostic lostJob(const JobOutcome& outcome, std::string_view tool, const std::string& name,
                   const std::string& file);

/// One note for each place at which a rewrite rule fired first, whatever the number of programs.
Diagnostics ruleNotes(const ShaderPack& pack);

}  // namespace orris
