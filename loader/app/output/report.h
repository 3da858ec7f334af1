// Diagnostics as a command prints them: text on standard error, JSON on standard output.
#pragma once

#include <unistd.h>

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "app/input/common.h"
#include <orris/check/rules/rules.h>
#include <orris/report/diagnostic_json.h>
#include <orris/report/problem_list.h>
#include <orris/report/text_style.h>

namespace orris {

/// Prints to standard error what the flags ask for, each problem once, and empties `diagnostics`
/// into the list that JSON reports. Call after each stage, so that long work shows its messages.
class Report {
 public:
  explicit Report(const OutputOptions& output) : output_(output), style_(styleOf(STDERR_FILENO)) {}
  /// Prints nothing: for a process that hands over what it was reported.
  static Report keeping() {
    Report report({});
    report.prints_ = false;
    return report;
  }

  const OutputOptions& output() const { return output_; }
  void add(Diagnostics& diagnostics);
  void add(Diagnostic diagnostic);
  /// The pack whose files problems name from now on, as on the command line.
  void setPack(const std::string& path) { folder_ = shadersFolderOf(path); }
  /// For another load of the same files: ProblemList::beginAgain().
  void beginAgain() { problems_.beginAgain(); }
  /// That of the worst cause of an error (Rule::status); kClean without one.
  ExitStatus status() const { return statusOf(all()); }
  const Diagnostics& all() const { return problems_.all(); }
  /// Adds one error about the command line, or about the file `path` as a whole.
  void error(const std::string& id, const std::string& message, const std::string& hint = "",
             const std::string& path = "");

 private:
  OutputOptions output_;
  TextStyle style_;
  std::string folder_;  ///< of the pack
  ProblemList problems_;
  bool prints_ = true;
};

/// Prints lines on standard output. They may quote a stranger's text: printableLines() of them.
void printText(std::string_view text);

/// The closing line of a command: "wrote a.png, b.exr (32 frames)" on standard output, not with --json
/// or --quiet. Empty paths are left out.
void sayWritten(const OutputOptions& output, const std::vector<std::string>& paths,
                const std::string& what = "");

/// Prints one JSON value on standard output.
void printJson(const nlohmann::json& result);
/// Prints `result` with the member "diagnostics" of `report` added, if --json was given.
void printJson(nlohmann::json result, const Report& report);

}  // namespace orris
