#include <orris/glsl/syntax/directive_slip.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace orris {
namespace {

// The likelier before the others: "edif" is rather #endif than #define.
constexpr std::array<std::string_view, 15> kDirectiveNames = {
    "endif",   "else",      "elif",  "ifdef",   "ifndef", "define", "include", "undef",
    "version", "extension", "error", "warning", "pragma", "line",   "if"};

/// Is `word` one letter short of `whole`?
bool lacksOne(std::string_view word, std::string_view whole) {
  if (word.size() + 1 != whole.size()) return false;
  const auto differs = std::ranges::mismatch(word, whole).in1 - word.begin();
  return word.substr(std::size_t(differs)) == whole.substr(std::size_t(differs) + 1);
}

bool isSlipOf(std::string_view word, std::string_view known) {
  return (word.size() == known.size() && std::ranges::is_permutation(word, known)) ||
         lacksOne(word, known) || lacksOne(known, word);
}

}  // namespace

std::string_view directiveMeant(std::string_view word) {
  if (std::ranges::find(kDirectiveNames, word) != kDirectiveNames.end()) return "";
  const auto meant =
      std::ranges::find_if(kDirectiveNames, [&](std::string_view known) { return isSlipOf(word, known); });
  return meant == kDirectiveNames.end() ? "" : *meant;
}

}  // namespace orris
