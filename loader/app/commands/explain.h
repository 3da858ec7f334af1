// orris validate --explain-log: a log of the game, translated back to the pack's lines.
#pragma once

#include "app/validate/validate_flags.h"
#include <orris/report/pack_verdict.h>
#include <orris/report/problem_list.h>

namespace orris {

/// Adds the explained messages to `problems`, and what was opened to the verdict; its status says what
/// could not be read.
PackVerdict explainGameLog(const std::string& packPath, const ValidateFlags& flags,
                           ProblemList& problems);

}  // namespace orris
