// Diagnostics as a command prints them: text on standard error, JSON on standard output.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <set>

#include "app/common.h"
#include "app/exit_status.h"
#include "core/diagnostic.h"

namespace orris {

/// Prints to standard error what the flags ask for, each problem once, and empties `diagnostics`
/// into the list that JSON reports. Call after each stage, so that long work shows its messages.
class Report {
 public:
  explicit Report(const OutputOptions& output) : output_(output) {}

  const OutputOptions& output() const { return output_; }
  void add(Diagnostics& diagnostics);
  /// kProblems when an error was added, else kClean.
  ExitStatus status() const { return hasErrors(all_) ? kProblems : kClean; }
  const Diagnostics& all() const { return all_; }
  /// Adds one error about the command line, or about the file `path` as a whole.
  void error(const std::string& id, const std::string& message, const std::string& hint = "",
             const std::string& path = "");

 private:
  OutputOptions output_;
  Diagnostics all_;
  std::set<std::string> seen_;
};

nlohmann::json toJson(const SourceLocation& location);
nlohmann::json toJson(const Diagnostics& diagnostics);
/// Prints one JSON value on standard output.
void printJson(const nlohmann::json& result);
/// Prints `result` with the member "diagnostics" of `report` added, if --json was given.
void printJson(nlohmann::json result, const Report& report);

}  // namespace orris
