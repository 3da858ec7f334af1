#include <orris/glsl/compile/stage_errors.h>

#include <algorithm>
#include <set>
#include <string>

#include <orris/core/characters.h>
#include <orris/core/limits.h>

namespace orris {
namespace {

std::vector<std::string_view> rowsOf(std::string_view text) {
  std::vector<std::string_view> rows;
  while (true) {
    const std::size_t end = text.find('\n');
    rows.push_back(text.substr(0, end));
    if (end == text.npos) return rows;
    text.remove_prefix(end + 1);
  }
}

/// "'tint' : undeclared identifier" is about tint; "" for other messages.
std::string undeclaredIn(std::string_view message) {
  const std::size_t end = message.find('\'', 1);
  const bool undeclared = message.starts_with('\'') && end != message.npos &&
                          message.substr(end).find("undeclared identifier") != message.npos;
  return undeclared ? std::string(message.substr(1, end - 1)) : "";
}

/// About the letters of one token, such as "08", which glslang does not quote.
bool isLexical(std::string_view message) { return message.starts_with("''"); }

bool mentions(std::string_view row, const std::set<std::string, std::less<>>& names) {
  for (std::size_t i = 0; i < row.size();) {
    std::size_t end = i;
    while (end < row.size() && isWordCharacter(row[end])) ++end;
    if (end > i && names.contains(row.substr(i, end - i))) return true;
    i = std::max(end, i + 1);
  }
  return false;
}

/// The rows of a text by statement: a row that ends in none of ; { } goes on in the next one.
class Statements {
 public:
  explicit Statements(std::string_view text) : rows_(rowsOf(text)) {
    firsts_.reserve(rows_.size());
    bool goesOn = false;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const std::size_t last = rows_[i].find_last_not_of(" \t\r");
      const std::size_t begin = rows_[i].find_first_not_of(" \t");
      const bool directive = begin != rows_[i].npos && rows_[i][begin] == '#';
      firsts_.push_back(goesOn && !directive ? firsts_.back() : i);
      const bool ends = last != rows_[i].npos && std::string_view(";{}").find(rows_[i][last]) != std::string_view::npos;
      goesOn = !directive && !ends;
    }
  }

  /// Index of the first row of the statement that has this row; an unknown row is its own.
  std::size_t of(std::size_t row) const { return row < firsts_.size() ? firsts_[row] : row; }

  bool usesAny(std::size_t statement, const std::set<std::string, std::less<>>& names) const {
    for (std::size_t i = statement; i < rows_.size() && firsts_[i] == statement; ++i) {
      if (mentions(rows_[i], names)) return true;
    }
    return false;
  }

 private:
  std::vector<std::string_view> rows_;
  std::vector<std::size_t> firsts_;
};

}  // namespace

std::vector<LogEntry> ownMistakes(std::vector<LogEntry> entries, std::string_view text) {
  const Statements statements(text);
  std::set<int> linesInError;
  std::set<std::size_t> statementsInError;
  std::set<std::string, std::less<>> undeclared;
  std::erase_if(entries, [&](const LogEntry& entry) {
    if (entry.severity != Severity::Error || entry.line <= 0) return false;
    const std::string name = undeclaredIn(entry.message);
    const std::size_t statement = statements.of(static_cast<std::size_t>(entry.line) - 1);
    // An error makes compilers take a wrong type for what the statement computes with it.
    const bool first = statementsInError.insert(statement).second;
    const bool follows = !first || statements.usesAny(statement, undeclared);
    if (name.empty() && !isLexical(entry.message) && follows) return true;
    if (linesInError.size() >= limits::kStageErrors) return true;
    if (!linesInError.insert(entry.line).second) return true;
    if (!name.empty()) undeclared.insert(name);
    return false;
  });
  return entries;
}

}  // namespace orris
