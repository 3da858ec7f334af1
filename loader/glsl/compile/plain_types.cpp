#include <orris/glsl/compile/plain_types.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

namespace orris {
namespace {

// glslang: TType::getCompleteString puts these before the type.
constexpr std::array<std::string_view, 26> kPlainQualifiers = {
    "temp",     "global",   "const",     "in",       "out",      "inout",         "uniform",
    "buffer",   "shared",   "highp",     "mediump",  "lowp",     "smooth",        "flat",
    "centroid", "sample",   "patch",     "invariant", "precise", "noperspective", "coherent",
    "volatile", "restrict", "readonly",  "writeonly", "varying"};

// One word, whatever blanks it holds: "layout( location=0)".
std::vector<std::string_view> wordsOf(std::string_view text) {
  std::vector<std::string_view> words;
  int depth = 0;
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= text.size(); ++i) {
    const char c = i < text.size() ? text[i] : ' ';
    depth += c == '(' ? 1 : c == ')' ? -1 : 0;
    if (depth > 0 || c != ' ') continue;
    if (i > begin) words.push_back(text.substr(begin, i - begin));
    begin = i + 1;
  }
  return words;
}

/// The letter before "vec" and "mat" of a type of components.
std::optional<std::string_view> prefixOf(std::string_view component) {
  using Pair = std::pair<std::string_view, std::string_view>;
  constexpr std::array<Pair, 5> kPrefixes = {
      {{"float", ""}, {"int", "i"}, {"uint", "u"}, {"bool", "b"}, {"double", "d"}}};
  const auto found = std::ranges::find(kPrefixes, component, &Pair::first);
  return found == kPrefixes.end() ? std::nullopt : std::optional(found->second);
}

/// "3-component vector of float", "4X4 matrix of float", "2-element array of T", or one word.
std::optional<std::string> typeOf(std::span<const std::string_view> words) {
  if (words.size() == 1) return std::string(words[0]);
  if (words.size() < 4 || words[2] != "of") return std::nullopt;
  const std::string_view count = words[0].substr(0, words[0].find('-'));
  if (words[1] == "array") {
    const auto element = typeOf(words.subspan(3));
    return element ? std::optional(fmt::format("{}[{}]", *element, count)) : std::nullopt;
  }
  const auto prefix = prefixOf(words[3]);
  if (words.size() != 4 || !prefix) return std::nullopt;
  if (words[1] == "vector") return fmt::format("{}vec{}", *prefix, count);
  if (words[1] != "matrix" || count.size() != 3) return std::nullopt;
  if (count[0] == count[2]) return fmt::format("{}mat{}", *prefix, count[0]);
  return fmt::format("{}mat{}x{}", *prefix, count[0], count[2]);
}

std::optional<std::string> plainType(std::string_view quoted) {
  std::vector<std::string_view> words = wordsOf(quoted);
  const bool speltOut = quoted.starts_with(' ') || words.size() > 1;
  std::erase_if(words, [](std::string_view word) {
    return word.starts_with("layout(") || std::ranges::find(kPlainQualifiers, word) != kPlainQualifiers.end();
  });
  return speltOut ? typeOf(words) : std::nullopt;
}

}  // namespace

std::string withPlainTypes(std::string_view message) {
  constexpr std::string_view kAssign = "'assign' : ";
  if (message.starts_with(kAssign))
    return withPlainTypes(fmt::format("'=' : {}", message.substr(kAssign.size())));
  std::string result;
  while (true) {
    const std::size_t open = message.find('\''), close = message.find('\'', open + 1);
    if (open == message.npos || close == message.npos) break;
    const std::string_view quoted = message.substr(open + 1, close - open - 1);
    result += fmt::format("{}'{}'", message.substr(0, open),
                          plainType(quoted).value_or(std::string(quoted)));
    message.remove_prefix(close + 1);
  }
  return result.append(message);
}

}  // namespace orris
