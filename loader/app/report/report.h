// Diagnostics as a command prints them: text on standard error, JSON on standard output; or kept, for
// validate, which judges them (report_findings.h) and knows more formats (report_format.h).
#pragma once

#include <unistd.h>

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "app/input/common.h"
#include "app/input/exit_status.h"
#include "app/report/text_style.h"
#include "core/diagnostic.h"

namespace orris {

/// Prints to standard error what the flags ask for, each problem once, and empties `diagnostics`
/// into the list that JSON reports. Call after each stage, so that long work shows its messages.
class Report {
 public:
  /// Keep prints nothing.
  enum class Mode { Print, Keep };

  explicit Report(const OutputOptions& output, Mode mode = Mode::Print)
      : output_(output), mode_(mode), style_(styleOf(STDERR_FILENO)) {}

  const OutputOptions& output() const { return output_; }
  void add(Diagnostics& diagnostics);
  /// The pack whose files problems name from now on, as on the command line.
  void setPack(const std::string& path) { folder_ = shadersFolderOf(path); }
  /// Under which of several settings ("profile LOW") problems are met that are added from now on;
  /// "": under all.
  void setContext(std::string context) { context_ = std::move(context); }
  /// For another load of the same files: errors, and what the last load did not meet, are printed when
  /// they come again; warnings and notes that stay are not repeated.
  void beginAgain();
  /// Notes at each problem the first of the contexts it was met under, if not under all `count`.
  void noteContexts(std::size_t count);
  /// kProblems when an error was added, else kClean.
  ExitStatus status() const { return hasErrors(all_) ? kProblems : kClean; }
  const Diagnostics& all() const { return all_; }
  /// The program files through which problem `i` of all() was met: "/world0/composite.fsh".
  const std::set<std::string>& entryFiles(std::size_t i) const { return entryFiles_[i]; }
  /// The problem that problem `i` follows from: another one, that follows from none itself.
  std::optional<std::size_t> cause(std::size_t i) const { return causes_[i]; }
  void setCause(std::size_t i, std::size_t cause) { causes_[i] = cause; }
  void setSeverity(std::size_t i, Severity severity) { all_[i].severity = severity; }
  void relate(std::size_t i, RelatedPlace place) { all_[i].related.push_back(std::move(place)); }
  /// Puts the problems of an earlier run, with what entryFiles() and cause() say of them, into an empty
  /// report. Nothing can be added behind them.
  void restore(Diagnostics all, std::vector<std::set<std::string>> entryFiles,
               std::vector<std::optional<std::size_t>> causes);
  /// Adds one error about the command line, or about the file `path` as a whole.
  void error(const std::string& id, const std::string& message, const std::string& hint = "",
             const std::string& path = "");

 private:
  OutputOptions output_;
  Mode mode_;
  TextStyle style_;
  std::string folder_;  ///< of the pack
  Diagnostics all_;
  std::string context_;
  std::vector<std::set<std::string>> entryFiles_;
  std::vector<std::optional<std::size_t>> causes_;
  std::vector<std::vector<std::string>> contexts_;  ///< of each problem, in order, each once
  std::map<std::string, std::size_t> seen_;         ///< index in all_
  std::set<std::string> met_;                       ///< keys since beginAgain()
};

/// Whether the flags ask to print a problem of this severity.
bool isShown(Severity severity, const OutputOptions& output);

/// Prints lines on standard output. They may quote a stranger's text: printableLines() of them.
void printText(std::string_view text);

/// The closing line of a command: "wrote a.png, b.exr (32 frames)" on standard output, not with --json
/// or --quiet. Empty paths are left out.
void sayWritten(const OutputOptions& output, const std::vector<std::string>& paths,
                const std::string& what = "");

nlohmann::json toJson(const SourceLocation& location);
nlohmann::json toJson(const Diagnostics& diagnostics);
/// JSON in ASCII, indented, with a final line feed: any bytes in its texts are safe to print.
std::string jsonText(const nlohmann::json& value);
/// Prints one JSON value on standard output.
void printJson(const nlohmann::json& result);
/// Prints `result` with the member "diagnostics" of `report` added, if --json was given.
void printJson(nlohmann::json result, const Report& report);

}  // namespace orris
