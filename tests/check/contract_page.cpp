#include "check/contract_page.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <utility>

namespace orris {
namespace {

std::string trimmed(std::string text) {
  const auto notBlank = [](char c) { return c != ' ' && c != '`'; };
  text.erase(text.begin(), std::find_if(text.begin(), text.end(), notBlank));
  text.erase(std::find_if(text.rbegin(), text.rend(), notBlank).base(), text.end());
  return text;
}

/// The cells of "| a | b \| c |".
std::vector<std::string> cellsOf(const std::string& line) {
  std::vector<std::string> cells;
  std::string cell;
  for (size_t i = 1; i < line.size(); ++i) {
    if (line[i] == '\\' && i + 1 < line.size() && line[i + 1] == '|') {
      cell += line[++i];
    } else if (line[i] == '|') {
      cells.push_back(trimmed(std::exchange(cell, "")));
    } else {
      cell += line[i];
    }
  }
  return cells;
}

std::string firstCsvField(const std::string& line) {
  if (!line.starts_with('"')) return line.substr(0, line.find(','));
  std::string field;
  for (size_t i = 1; i < line.size(); ++i) {
    if (line[i] == '"' && (i + 1 >= line.size() || line[i + 1] != '"')) break;
    if (line[i] == '"') ++i;
    field += line[i];
  }
  return field;
}

std::filesystem::path tablePath(const std::string& table) {
  return std::filesystem::path(ORRIS_SOURCE_DIR "/docs/contract") / (table + ".csv");
}

}  // namespace

std::vector<ContractRow> readContractPage() {
  std::ifstream file(ORRIS_SOURCE_DIR "/docs/contract.md");
  std::vector<ContractRow> rows;
  std::string section;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("## ")) section = line.substr(3);
    if (!line.starts_with("| `")) continue;
    const std::vector<std::string> cells = cellsOf(line);
    if (cells.size() >= 5)
      rows.push_back({section, cells[0], cells[1], cells[2], cells[3], cells[4]});
  }
  return rows;
}

std::vector<ContractRow> rowsOf(const std::string& section) {
  std::vector<ContractRow> rows = readContractPage();
  std::erase_if(rows, [&](const ContractRow& row) { return row.section != section; });
  return rows;
}

std::set<std::string> wordsOf(const std::string& name) {
  std::string text = std::regex_replace(name, std::regex("<[^>]*>"), "*");
  text = std::regex_replace(text, std::regex("\\([^)]*\\)|\\[[^\\]]*\\]|[,/]"), " ");
  std::istringstream stream(text);
  std::set<std::string> words;
  std::string previous;
  for (std::string word; stream >> word; previous = word) {
    // ".cutout" after "backFace.solid", "_ATI" after "MC_GL_VENDOR_AMD".
    const char first = word.front();
    if ((first == '.' || first == '_') && !previous.empty() && previous.rfind(first) > 0 &&
        previous.rfind(first) != std::string::npos) {
      word = previous.substr(0, previous.rfind(first)) + word;
    }
    const size_t range = word.find("..");
    if (range != std::string::npos && range > 0) {
      words.insert(word.substr(0, range));
      word = word.substr(0, word.find_first_of("0123456789")) + "*";
    }
    words.insert(word);
  }
  return words;
}

std::set<std::string> wordsOfSection(const std::string& section) {
  std::set<std::string> words;
  for (const ContractRow& row : rowsOf(section)) words.merge(wordsOf(row.name));
  return words;
}

bool matchesAny(const std::string& name, const std::set<std::string>& patterns) {
  return std::any_of(patterns.begin(), patterns.end(), [&](const std::string& pattern) {
    const size_t star = pattern.find('*');
    if (star == std::string::npos) return pattern == name;
    const std::string begin = pattern.substr(0, star), end = pattern.substr(pattern.rfind('*') + 1);
    // A lone star stands for nothing in particular.
    return begin.size() + end.size() > 0 && name.size() >= begin.size() + end.size() &&
           name.starts_with(begin) && name.ends_with(end);
  });
}

std::vector<std::string> contractNames(const std::string& table) {
  std::ifstream file(tablePath(table));
  std::vector<std::string> names;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) names.push_back(firstCsvField(line));
  return names;
}


}  // namespace orris
