// What the command line asks of a report: which problems count, and where it goes in which format.
#pragma once

#include <set>
#include <string>
#include <vector>

#include <orris/report/findings.h>

namespace CLI {
class App;
}

namespace orris {

/// One file to write.
struct ReportFile {
  std::string format, path;
};

struct ReportOptions {
  std::string format = "text";  ///< of standard output
  std::string output;  ///< --output: where --format goes, standard output then gets the counts
  std::vector<ReportFile> files;  ///< --report
  JudgeOptions judge;
  std::string baseline, writeBaseline;    ///< files
  std::set<std::string> silencedUnasked;  ///< ids that the folder's own orris.toml judges
};

/// --format, --output, --report, --ignore, --severity, --strict, --source-root, --baseline
/// and --write-baseline.
void addReportFlags(CLI::App& command, ReportOptions& options);
/// Call when all flags are read: makes one of --format, --output and `json` (the flag --json).
void settleReportFlags(ReportOptions& options, bool json);

}  // namespace orris
