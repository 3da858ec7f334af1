// What a hostile input can add to a list of messages is bounded (core/limits.h): of each kind the first
// are kept, one message "messages-left-out" stands for the rest; texts and quoted lines are cut.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include <orris/core/diagnostic.h>

namespace orris {

/// What a message quotes of `line` (column from 1, 0: none). Of a very long line it is the part that
/// ends at the column, so that the caret, which stands after the last character at most, marks the end.
std::string quotedLine(std::string_view line, int column);

/// Counts messages by kind and bytes.
class MessageBudget {
 public:
  enum class Verdict { Keep, LastOfItsKind, Drop };

  /// Cuts the texts of `diagnostic`. LastOfItsKind: it was replaced by the message that stands for the
  /// rest. The first error is always kept.
  Verdict take(Diagnostic& diagnostic);
  /// Takes a message into account that was kept before.
  void count(const Diagnostic& diagnostic);

 private:
  std::map<std::string, std::size_t> kinds_;  ///< how many of each id
  std::size_t bytes_ = 0;
  bool anyError_ = false;
};

/// Applies a budget to a whole list.
void boundMessages(Diagnostics& diagnostics);

}  // namespace orris
