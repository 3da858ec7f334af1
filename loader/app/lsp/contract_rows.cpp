#include "app/lsp/contract_rows.h"

#include <algorithm>

#include <orris/core/characters.h>
#include <orris/pack/files/text.h>

namespace orris {

extern const char* const kContractPage;

namespace {

constexpr std::size_t kColumns = 8;  ///< of a row, with the empty ones at both ends

std::string plain(std::string_view text) {
  std::string result(trim(text));
  std::erase(result, '`');
  return result;
}

bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// "colortex12" -> "colortex0": numbered families stand under their first member, or without a number.
std::string firstOfFamily(std::string_view name, std::string_view number) {
  while (!name.empty() && isDigit(name.back())) name.remove_suffix(1);
  return std::string(name) + std::string(number);
}

bool rowNames(const ContractRow& row, std::string_view name) {
  for (std::size_t at = row.names.find(name); at != std::string::npos; at = row.names.find(name, at + 1)) {
    const std::size_t end = at + name.size();
    const bool starts = at == 0 || !isWordCharacter(row.names[at - 1]);
    const bool ends = end == row.names.size() || !isWordCharacter(row.names[end]);
    if (starts && ends) return true;
  }
  return false;
}

}  // namespace

const std::vector<ContractRow>& contractRows() {
  static const std::vector<ContractRow> kRows = [] {
    std::vector<ContractRow> rows;
    std::string section;
    for (const std::string& line : splitLines(kContractPage)) {
      if (line.starts_with("## ")) section = line.substr(3);
      const auto cells = splitAt(line, '|');
      if (!line.starts_with("| `") || cells.size() < kColumns) continue;
      rows.push_back({section, plain(cells[1]), plain(cells[3]), plain(cells[cells.size() - 2])});
    }
    return rows;
  }();
  return kRows;
}

std::vector<const ContractRow*> contractRowsOf(std::string_view name) {
  std::vector<const ContractRow*> found;
  if (name.empty()) return found;
  for (const std::string& tried : {std::string(name), firstOfFamily(name, "0"), firstOfFamily(name, "")}) {
    if (tried.empty()) continue;
    for (const ContractRow& row : contractRows())
      if (rowNames(row, tried)) found.push_back(&row);
    if (!found.empty()) break;
  }
  return found;
}

}  // namespace orris
