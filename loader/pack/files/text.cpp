#include <orris/pack/files/text.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numeric>

namespace orris {
namespace {

bool isBlankOrControl(char c) { return static_cast<unsigned char>(c) <= ' '; }

template <typename Number>
std::optional<Number> parseWhole(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// The words of a name in small letters: "rain_strength" and "rainStrength" have two.
std::vector<std::string> wordsOfName(std::string_view name) {
  std::vector<std::string> words(1);
  for (size_t i = 0; i < name.size(); ++i) {
    const auto isUpper = [&](size_t at) { return name[at] >= 'A' && name[at] <= 'Z'; };
    const bool begins = i > 0 && isUpper(i) && !isUpper(i - 1);
    if ((begins || name[i] == '_') && !words.back().empty()) words.emplace_back();
    if (name[i] != '_') words.back() += lowerCase(name.substr(i, 1));
  }
  return words;
}

/// Another word, and no slip of the finger: "wind" for "rain", "get" for "set".
bool isOtherWord(std::string_view word, std::string_view other) {
  if (word.starts_with(other) || other.starts_with(word)) return false;
  const size_t distance = editDistance(word, other), longer = std::max(word.size(), other.size());
  if (longer > 3) return distance > longer / 3;
  const bool exchanged =
      word.size() > 1 && std::is_permutation(word.begin(), word.end(), other.begin(), other.end());
  return word.size() == other.size() ? !exchanged : distance > 1;
}

/// The least edit distance that two texts of these characters can have, as an exchange keeps the characters: a bound that
/// takes a step for each character, where the distance takes one for each pair.
size_t leastDistance(std::string_view a, std::string_view b) {
  std::array<int, 256> more{};
  for (const char c : a) ++more[static_cast<unsigned char>(c)];
  for (const char c : b) --more[static_cast<unsigned char>(c)];
  size_t inserted = 0, removed = 0;
  for (const int count : more) {
    inserted += static_cast<size_t>(std::max(-count, 0));
    removed += static_cast<size_t>(std::max(count, 0));
  }
  return std::max(inserted, removed);
}

/// Is `candidate` another name of the same pattern, as windStrength beside rainStrength and 1.0
/// beside 10, so that nobody can have meant it?
bool isSibling(std::string_view name, std::string_view candidate) {
  const auto number = parseFloat(name), other = parseFloat(candidate);
  if (number && other) return *number != *other;
  const auto words = wordsOfName(name), others = wordsOfName(candidate);
  if (words.size() < 2 || words.size() != others.size()) return false;
  for (size_t i = 0; i < words.size(); ++i) {
    // "vertexPosition" for "vaPosition": a prefix of two letters says where a name comes from.
    const bool prefix = i == 0 && std::min(words[i].size(), others[i].size()) <= 2;
    if (!prefix && isOtherWord(words[i], others[i])) return true;
  }
  return false;
}

}  // namespace

std::string_view trim(std::string_view text) {
  while (!text.empty() && isBlankOrControl(text.front())) text.remove_prefix(1);
  while (!text.empty() && isBlankOrControl(text.back())) text.remove_suffix(1);
  return text;
}

std::vector<std::string> splitBlanks(std::string_view text) {
  std::vector<std::string> words;
  for (size_t at = 0; at < text.size();) {
    if (isBlankOrControl(text[at])) {
      ++at;
      continue;
    }
    const size_t begin = at;
    while (at < text.size() && !isBlankOrControl(text[at])) ++at;
    words.emplace_back(text.substr(begin, at - begin));
  }
  return words;
}

std::vector<std::string> splitSingleBlanks(std::string_view text) {
  std::vector<std::string> words;
  for (const std::string_view word : splitAt(text, ' ')) words.emplace_back(word);
  while (words.size() > 1 && words.back().empty()) words.pop_back();
  return words;
}

std::vector<std::string_view> splitAt(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (size_t begin = 0;;) {
    const size_t end = text.find(separator, begin);
    parts.push_back(text.substr(begin, end - begin));
    if (end == std::string_view::npos) return parts;
    begin = end + 1;
  }
}

std::vector<std::string> splitLines(std::string_view text) {
  std::vector<std::string> lines;
  for (size_t begin = 0; begin < text.size();) {
    size_t end = text.find_first_of("\r\n", begin);
    if (end == std::string_view::npos) end = text.size();
    std::string& line = lines.emplace_back(text.substr(begin, end - begin));
    std::erase(line, '\0');
    begin = end + (text.substr(end, 2) == "\r\n" ? 2 : 1);
  }
  return lines;
}

std::string_view leadingWord(std::string_view text) {
  const auto end = std::find_if_not(text.begin(), text.end(), isWordCharacter);
  return text.substr(0, static_cast<size_t>(end - text.begin()));
}

std::optional<long long> parseInteger(std::string_view text) { return parseWhole<long long>(text); }

std::optional<float> parseFloat(std::string_view text) {
  constexpr std::string_view kSuffixes = "fFdD";
  if (text.size() > 1 && kSuffixes.find(text.back()) != std::string_view::npos)
    text.remove_suffix(1);
  const auto value = parseWhole<float>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<bool> parseBoolean(std::string_view text) {
  if (text == "true" || text == "1") return true;
  if (text == "false" || text == "0") return false;
  return std::nullopt;
}

std::string withNamespace(std::string_view name) {
  return (name.find(':') == std::string_view::npos ? "minecraft:" : "") + std::string(name);
}

std::string joinNames(const std::vector<std::string>& names) {
  std::string joined;
  for (const std::string& name : names) joined += (joined.empty() ? "" : ", ") + name;
  return joined;
}

std::string lowerCase(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
  return result;
}

std::string upperCase(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c;
  return result;
}

size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<size_t> last(b.size() + 1), before(b.size() + 1), row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (size_t i = 1; i <= a.size(); ++i) {
    last.swap(before);
    before.swap(row);
    row[0] = i;
    for (size_t j = 1; j <= b.size(); ++j) {
      const size_t replaced = before[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({replaced, before[j] + 1, row[j - 1] + 1});
      const bool exchanged = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (exchanged) row[j] = std::min(row[j], last[j - 2] + 1);
    }
  }
  return row.back();
}

std::string nearestName(std::string_view name, const std::vector<std::string>& names) {
  // Names come from untrusted files: there may be very many, and very long ones.
  constexpr size_t kLongest = 128, kMost = 4096, kShort = 5;
  if (name.empty() || name.size() > kLongest || names.size() > kMost) return "";
  const std::string lower = lowerCase(name);
  std::string nearest;
  size_t best = name.size() / 3 + 1;
  for (const std::string& candidate : names) {
    // Each letter more or less is a change.
    const size_t longer = std::max(candidate.size(), name.size());
    const size_t shorter = std::min(candidate.size(), name.size());
    if (candidate.size() > kLongest || longer - shorter > best) continue;
    const std::string lowerCandidate = lowerCase(candidate);
    if (leastDistance(lower, lowerCandidate) > best) continue;
    const size_t distance = editDistance(lower, lowerCandidate);
    // In a short name two changed letters are a half: swapped ones at best, seldom the first; of a
    // name of two letters nothing but one more.
    const bool likely = lower.size() == 2 ? lowerCandidate.starts_with(lower)
                                          : lowerCandidate.starts_with(lower.front());
    const bool atLimit = nearest.empty() && distance == best && lower.size() > 1 &&
                         (lower.size() > kShort || likely);
    if ((distance < best || atLimit) && !isSibling(name, candidate)) {
      best = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

std::string suggest(std::string_view name, const std::vector<std::string>& names) {
  const std::string nearest = nearestName(name, names);
  return nearest.empty() ? "" : "did you mean " + nearest + "?";
}

}  // namespace orris
