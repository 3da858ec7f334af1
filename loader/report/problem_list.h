// The problems of a pack, each once, and what is known of them besides the message.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <orris/core/diagnostic.h>

namespace orris {

class ProblemList {
 public:
  /// Takes those that are new, up to the limits of core/message_limits.h, and empties `diagnostics`. A
  /// mistake in a shared file is one problem, however many programs include it.
  void add(Diagnostics& diagnostics);
  /// Adds one error about the request.
  void error(const std::string& id, const std::string& message, const std::string& hint = "");
  /// Under which of several settings ("profile LOW") problems are met that are added from now on;
  /// "": under all.
  void setContext(std::string context) { context_ = std::move(context); }
  /// For another load of the same files: errors, and what the last load did not meet, are new when they
  /// come again, and leave the list: a window is open for days. Warnings and notes that stay are not new.
  void beginAgain();
  /// Notes at each problem the first of the contexts it was met under, if not under all `count`.
  void noteContexts(std::size_t count);
  const Diagnostics& all() const { return all_; }
  /// The program files through which problem `i` of all() was met: "/world0/composite.fsh".
  const std::set<std::string>& entryFiles(std::size_t i) const { return entryFiles_[i]; }
  /// The problem that problem `i` follows from: another one, that follows from none itself.
  std::optional<std::size_t> cause(std::size_t i) const { return causes_[i]; }
  void setCause(std::size_t i, std::size_t cause) { causes_[i] = cause; }
  void setSeverity(std::size_t i, Severity severity) { all_[i].severity = severity; }
  void relate(std::size_t i, RelatedPlace place) { all_[i].related.push_back(std::move(place)); }
  /// Puts the problems of an earlier run, with what entryFiles() and cause() say of them, into an empty
  /// list. Nothing can be added behind them.
  void restore(Diagnostics all, std::vector<std::set<std::string>> entryFiles,
               std::vector<std::optional<std::size_t>> causes);

 private:
  Diagnostics all_;
  std::string context_;
  std::vector<std::set<std::string>> entryFiles_;
  std::vector<std::optional<std::size_t>> causes_;
  std::vector<std::vector<std::string>> contexts_;  ///< of each problem, in order, each once
  std::map<std::string, std::size_t> seen_;         ///< index in all_
  std::set<std::string> met_;                       ///< keys since beginAgain()
};

}  // namespace orris
