// Which of the messages about one stage are mistakes of their own, and not consequences of one before.
#pragma once

#include <string_view>
#include <vector>

#include <orris/glsl/compile/compiler_log.h>

namespace orris {

/// `entries` in the compiler's order, of the compiled text: one error a statement, but every undeclared name and
/// every malformed token; none in a statement that uses a name which an earlier error calls undeclared; at most
/// limits::kStageErrors. What is no error stays.
std::vector<LogEntry> ownMistakes(std::vector<LogEntry> entries, std::string_view text);

}  // namespace orris
