// docs/limits.md has a row with the value of every constant of core/limits.h, and no others.
#include <orris/core/limits.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <regex>
#include <string>

namespace {

using Table = std::map<std::string, std::string>;

/// The product of the factors of "std::size_t{32} << 20", "64 * 1024", "10'000".
std::string valueOf(std::string text) {
  text = std::regex_replace(text, std::regex("std::\\w+\\{(\\d+)\\}|'"), "$1");
  std::smatch match;
  long long value = std::stoll(text);
  if (std::regex_search(text, match, std::regex("<< (\\d+)"))) value <<= std::stoi(match[1].str());
  return std::to_string(value);
}

Table rows(const std::string& path, const std::regex& row) {
  Table table;
  std::ifstream file(std::string(ORRIS_SOURCE_DIR) + path);
  std::smatch match;
  for (std::string line; std::getline(file, line);) {
    if (std::regex_search(line, match, row)) table[match[1].str()] = valueOf(match[2].str());
  }
  return table;
}

TEST(limits, the_page_has_the_values_of_the_header) {
  const Table header = rows("/loader/core/limits.h", std::regex("constexpr .* (k\\w+) = ([^;]+);"));
  const Table page = rows("/docs/limits.md", std::regex("^\\| `(k\\w+)` \\| (\\d+) \\| \\w"));
  EXPECT_GT(header.size(), 5u);
  EXPECT_EQ(header, page);
}

}  // namespace
