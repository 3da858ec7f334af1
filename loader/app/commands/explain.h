// orris validate --explain-log: a log of the game, translated back to the pack's lines.
#pragma once

#include "app/report/report.h"
#include "app/validate/validate_options.h"
#include "app/validate/validate_run.h"

namespace orris {

/// Adds the explained messages to `report`, and what was opened to the verdict; its status says what
/// could not be read.
PackVerdict explainGameLog(const std::string& packPath, const ValidateOptions& options,
                           Report& report);

}  // namespace orris
