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

bool usesAny(std::string_view row, const std::set<std::string, std::less<>>& names) {
  for (std::size_t i = 0; i < row.size();) {
    std::size_t end = i;
    while (end < row.size() && isWordCharacter(row[end])) ++end;
    if (end > i && names.contains(row.substr(i, end - i))) return true;
    i = std::max(end, i + 1);
  }
  return false;
}

}  // namespace

std::vector<LogEntry> ownMistakes(std::vector<LogEntry> entries, std::string_view text) {
  const std::vector<std::string_view> rows = rowsOf(text);
  std::set<int> linesInError;
  std::set<std::string, std::less<>> undeclared;
  std::erase_if(entries, [&](const LogEntry& entry) {
    if (entry.severity != Severity::Error || entry.line <= 0) return false;
    const auto row = static_cast<std::size_t>(entry.line) - 1;
    const std::string name = undeclaredIn(entry.message);
    if (name.empty() && row < rows.size() && usesAny(rows[row], undeclared)) return true;
    if (linesInError.size() >= limits::kStageErrors) return true;
    if (!linesInError.insert(entry.line).second) return true;
    if (!name.empty()) undeclared.insert(name);
    return false;
  });
  return entries;
}

}  // namespace orris
