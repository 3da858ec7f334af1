// The processes that check a pack: one rests with all that the last whole check knows; each check runs in a
// fork of it, which takes its place when it has ended well. A check that dies or is given up costs nothing
// but its findings.
#pragma once

#include <string>

#include "app/lsp/check_work.h"

namespace orris {

/// Reads jobs (writeCheckJob()) and writes what their checks say, one JSON object a line with the number of
/// its "job"; {"part": "lost"} for one that dies. A new job ends the one that is in progress. Returns when
/// `jobs` is closed.
void serveChecks(const std::string& path, const ValidateOptions& options, int jobs, int out);

/// false: nobody reads.
bool writeCheckJob(int to, const CheckJob& job);

}  // namespace orris
