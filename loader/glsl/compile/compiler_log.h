// Info logs of GLSL compilers: glslang and the GL drivers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <orris/glsl/compile/validate.h>

namespace orris {

/// One message of a log. `line` and `column` are those of the compiled text, 0 when not given.
struct LogEntry {
  Severity severity = Severity::Error;
  int line = 0;
  int column = 0;
  std::string message;
  std::vector<std::string> notes;  ///< lines that continue the message, such as candidates
};

/// Splits a log; summaries ("2 compilation errors") and headings are left out. A line that names no
/// severity takes `fallback`.
std::vector<LogEntry> parseCompilerLog(std::string_view log, Severity fallback);

/// The entry at the author's place: file, line, column, chain of includes, source line, macro. An
/// entry without a place, or in text made by the host, is put at the stage's entry file.
Diagnostic locateLogEntry(const LogEntry& entry, std::string id, const StageText& stage,
                          const SourceLines& lines);

}  // namespace orris
