// One #include for many programs: what they all lack most likely belongs into a file that all of them
// read; and the other places where it would do.
#pragma once

#include <vector>

#include <orris/check/compile/program_check.h>
#include <orris/check/hints/trial_memo.h>

namespace orris {

/// Where programs lack an include of something at different places, looks for one line that repairs
/// them all; if there is one, only that is reported. At each place so are the next likely ones that
/// repair as well, as warnings. `found` are the diagnostics of each unit. Compiles, so it works in
/// a process of its own, unless `jobs` is 0 (isolated_jobs.h); nothing changes when that is lost.
void mergeMissingIncludes(const ShaderPack& pack, const std::vector<ProgramUnit>& units, int jobs,
                          TrialMemo& trials, std::vector<Diagnostics>& found);

}  // namespace orris
