// traceUntil() in a terminal: a progress line, and Ctrl-C ends the work as a limit does.
#pragma once

#include <functional>

#include "app/output/report.h"
#include <orris/trace/film/trace_until.h>

namespace orris {

/// Calls `work` with hooks that show its progress and obey the first Ctrl-C; a second one ends the program as
/// always.
void withTraceHooks(Report& report, const std::function<void(const TraceHooks& hooks)>& work);

}  // namespace orris
