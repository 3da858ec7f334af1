// Trying a line that seems to be missing: the program is made and compiled with it.
#pragma once

#include <optional>

#include <orris/check/compile/program_check.h>
#include <orris/check/hints/missing_include.h>
#include <orris/check/hints/trial_memo.h>
#include <orris/pack/programs/folder_build.h>

namespace orris {

/// The build that made the program, nullptr when the pack was not made from files.
const FolderBuild* buildOf(const ShaderPack& pack, const ProgramSource& program);

/// What is reported of the unit of `pack` with the line, nullopt when it cannot be made anew. To count what is left
/// take the first error of each stage: a syntax error hides all behind it.
std::optional<Diagnostics> diagnosticsWith(const ShaderPack& pack, const ProgramUnit& unit,
                                           const AddedLine& added, CompileErrors wanted);

/// What all that is reported of the unit with the line depends on, as a hash; nullopt when it cannot be
/// made anew or the line changes nothing.
std::optional<std::uint64_t> trialHash(const ShaderPack& pack, const ProgramUnit& unit,
                                       const AddedLine& added);

/// Does the unit, which has `errors`, have fewer with the #include, and none that is new?
bool fixedBy(const ShaderPack& pack, const ProgramUnit& unit, const MissingInclude& added,
             const Diagnostics& errors, TrialMemo& trials);

}  // namespace orris
