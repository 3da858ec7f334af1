#include <orris/pack/files/properties_text.h>

#include <algorithm>
#include <charconv>
#include <deque>
#include <map>
#include <optional>

#include <orris/pack/files/text.h>

namespace orris {
namespace {

// A long line may have thousands of words, and as many messages; whoever prints them reads it again.
constexpr size_t kLongestShown = 2048;

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\f'; }

std::string_view skipBlanks(std::string_view text) {
  const auto begin = std::find_if_not(text.begin(), text.end(), isBlank);
  return text.substr(static_cast<size_t>(begin - text.begin()));
}

bool endsInBackslash(std::string_view line) {
  const size_t last = line.find_last_not_of('\\');
  return (line.size() - (last == std::string_view::npos ? 0 : last + 1)) % 2 == 1;
}

/// The lines of a file before and after preprocessing.
struct Lines {
  std::vector<std::string> text, original;
  bool leftBlank(size_t index) const {
    return index >= original.size() || trim(original[index]).empty();
  }
};

/// The index of the line that continues an entry after `index`; nullopt when none does.
std::optional<size_t> nextLine(const Lines& lines, size_t index, Continuation continuation) {
  for (size_t next = index + 1; next < lines.text.size(); ++next) {
    if (continuation == Continuation::Java) return next;
    const std::string_view line = trim(lines.text[next]);
    if (!line.empty()) return next;
    if (!lines.leftBlank(next)) return std::nullopt;
  }
  return std::nullopt;
}

/// Joins the lines of one entry, starting at `index`, which is left on its last line.
std::string joinContinued(const Lines& lines, size_t& index, Continuation continuation) {
  const bool lenient = continuation != Continuation::Java;
  const auto lineAt = [&](size_t i) {
    return lenient ? trim(lines.text[i]) : skipBlanks(lines.text[i]);
  };
  std::string joined(lineAt(index));
  while (endsInBackslash(joined)) {
    joined.pop_back();
    const auto next = nextLine(lines, index, continuation);
    if (!next) break;
    index = *next;
    joined += lineAt(index);
  }
  return joined;
}

void appendUtf8(std::string& out, unsigned code) {
  if (code < 0x80) {
    out += static_cast<char>(code);
  } else if (code < 0x800) {
    out += static_cast<char>(0xC0 | code >> 6);
    out += static_cast<char>(0x80 | (code & 0x3F));
  } else {
    out += static_cast<char>(0xE0 | code >> 12);
    out += static_cast<char>(0x80 | (code >> 6 & 0x3F));
    out += static_cast<char>(0x80 | (code & 0x3F));
  }
}

std::string unescape(std::string_view text) {
  std::string result;
  for (size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\\' || i + 1 == text.size()) {
      result += text[i];
      continue;
    }
    const char c = text[++i];
    unsigned code = 0;
    const std::string_view digits = text.substr(i + 1, 4);
    if (c == 'u' && digits.size() == 4 &&
        std::from_chars(digits.data(), digits.data() + 4, code, 16).ptr == digits.data() + 4) {
      appendUtf8(result, code);
      i += 4;
    } else {
      constexpr std::string_view kLetters = "tnrf", kMeanings = "\t\n\r\f";
      const size_t known = kLetters.find(c);
      result += known == std::string_view::npos ? c : kMeanings[known];
    }
  }
  return result;
}

/// Where `word` stands on its own; npos when it does not.
size_t findWord(std::string_view line, std::string_view word) {
  const auto stands = [&](size_t at) {
    const size_t end = at + word.size();
    return (at == 0 || !isWordCharacter(line[at - 1]) || !isWordCharacter(word.front())) &&
           (end == line.size() || !isWordCharacter(line[end]) || !isWordCharacter(word.back()));
  };
  if (word.empty()) return std::string_view::npos;
  size_t at = line.find(word);
  while (at != std::string_view::npos && !stands(at)) at = line.find(word, at + 1);
  return at;
}

/// Length of the key: up to an unescaped '=', ':' or blank.
size_t keyLength(std::string_view line) {
  for (size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '\\') {
      ++i;
    } else if (line[i] == '=' || line[i] == ':' || isBlank(line[i])) {
      return i;
    }
  }
  return line.size();
}

/// Where a word stands in an entry's lines, both from 0.
struct Place {
  size_t line, column;
};

/// Begin and end of each word from `start` on; a backslash that ends the line is no word.
std::vector<std::pair<size_t, size_t>> wordRanges(std::string_view line, size_t start) {
  constexpr std::string_view kBlanks = " \t\f\r";
  std::vector<std::pair<size_t, size_t>> ranges;
  size_t last = line.find_last_not_of(kBlanks);
  if (last != std::string_view::npos && line[last] == '\\') line = line.substr(0, last);
  for (size_t begin = line.find_first_not_of(kBlanks, start); begin != std::string_view::npos;) {
    const size_t end = std::min(line.find_first_of(kBlanks, begin), line.size());
    ranges.emplace_back(begin, end);
    begin = line.find_first_not_of(kBlanks, end);
  }
  return ranges;
}

/// Begin and end of each name, number or sign from `start` on.
std::vector<std::pair<size_t, size_t>> tokenRanges(std::string_view text, size_t start) {
  std::vector<std::pair<size_t, size_t>> ranges;
  for (size_t begin = start; begin < text.size();) {
    const size_t word = leadingWord(text.substr(begin)).size();
    const size_t end = begin + std::max<size_t>(word, 1);
    if (static_cast<unsigned char>(text[begin]) > ' ' && text[begin] != '\\')
      ranges.emplace_back(begin, end);
    begin = end;
  }
  return ranges;
}

/// Where the value begins on the line of the key.
size_t valueStart(std::string_view line, const PropertyEntry& entry) {
  const size_t key = static_cast<size_t>(std::max(entry.at.column, 1)) - 1;
  if (key >= line.size()) return line.size();
  size_t at = key + keyLength(line.substr(key));
  while (at < line.size() && isBlank(line[at])) ++at;
  return at < line.size() && (line[at] == '=' || line[at] == ':') ? at + 1 : at;
}

std::string shown(std::string_view line) {
  return std::string(line.size() > kLongestShown ? "" : line);
}

}  // namespace

std::vector<PropertyEntry> parseProperties(const std::string& file, std::string_view text,
                                           Continuation continuation, std::string_view original) {
  const Lines lines{splitLines(text), splitLines(original.empty() ? text : original)};
  std::vector<PropertyEntry> entries;
  for (size_t i = 0; i < lines.text.size(); ++i) {
    const std::string_view start = skipBlanks(lines.text[i]);
    if (start.empty() || start.front() == '#' || start.front() == '!') continue;
    PropertyEntry entry;
    const size_t first = i;
    const std::string joined = joinContinued(lines, i, continuation);
    for (size_t line = first; line <= i && line < lines.original.size(); ++line) {
      const bool active = line < lines.text.size() && !trim(lines.text[line]).empty();
      entry.lines.push_back(active ? lines.original[line] : "");
    }
    if (entry.lines.empty()) entry.lines.push_back(lines.text[first]);
    const std::string& written = entry.lines.front();
    entry.at = {file, static_cast<int>(first) + 1,
                static_cast<int>(written.size() - skipBlanks(written).size()) + 1};
    const size_t length = keyLength(joined);
    std::string_view value = skipBlanks(std::string_view(joined).substr(length));
    if (!value.empty() && (value.front() == '=' || value.front() == ':')) value.remove_prefix(1);
    entry.key = unescape(std::string_view(joined).substr(0, length));
    entry.value = unescape(skipBlanks(value));
    entries.push_back(std::move(entry));
  }
  return entries;
}

std::vector<PropertyEntry> lastValues(const std::vector<PropertyEntry>& entries) {
  std::vector<PropertyEntry> result;
  std::map<std::string_view, size_t> index;
  for (const PropertyEntry& entry : entries) {
    const auto [found, isNew] = index.try_emplace(entry.key, result.size());
    if (isNew) {
      result.push_back(entry);
    } else {
      result[found->second] = entry;
    }
  }
  return result;
}

std::vector<PropertyWord> locatedWords(const PropertyEntry& entry) {
  std::map<std::string_view, std::deque<Place>> places;
  for (size_t line = 0; line < entry.lines.size(); ++line) {
    const std::string_view text = entry.lines[line];
    for (const auto& [begin, end] : wordRanges(text, line == 0 ? valueStart(text, entry) : 0)) {
      places[text.substr(begin, end - begin)].push_back({line, begin});
    }
  }
  std::vector<PropertyWord> words;
  for (std::string& text : splitBlanks(entry.value)) {
    PropertyWord word{std::move(text), entry.at, entry.lines.front()};
    if (const auto found = places.find(word.text);
        found != places.end() && !found->second.empty()) {
      const Place place = found->second.front();
      found->second.pop_front();
      word.at.line += static_cast<int>(place.line);
      word.at.column = static_cast<int>(place.column) + 1;
      word.sourceLine = entry.lines[place.line];
      word.written = true;
    }
    words.push_back(std::move(word));
  }
  return words;
}

PropertyWord locatedToken(const PropertyEntry& entry, size_t offset) {
  std::string_view wanted;
  size_t repeats = 0;
  for (const auto& [begin, end] : tokenRanges(entry.value, 0)) {
    if (begin > offset) break;
    wanted = std::string_view(entry.value).substr(begin, end - begin);
  }
  for (const auto& [begin, end] : tokenRanges(entry.value, 0)) {
    const auto token = std::string_view(entry.value).substr(begin, end - begin);
    if (begin + token.size() <= offset && token == wanted) ++repeats;
  }
  PropertyWord word{std::string(wanted), entry.at, entry.lines.front()};
  for (size_t line = 0; line < entry.lines.size(); ++line) {
    const std::string_view text = entry.lines[line];
    for (const auto& [begin, end] : tokenRanges(text, line == 0 ? valueStart(text, entry) : 0)) {
      if (text.substr(begin, end - begin) != wanted || repeats-- > 0) continue;
      word.at.line += static_cast<int>(line);
      word.at.column = static_cast<int>(begin) + 1;
      word.sourceLine = text;
      word.written = true;
      return word;
    }
  }
  return word;
}

Diagnostic wordDiagnostic(Severity severity, std::string id, const PropertyWord& word,
                          std::string message, std::string hint) {
  return {.severity = severity,
          .id = std::move(id),
          .at = word.at,
          .message = std::move(message),
          .sourceLine = shown(word.sourceLine),
          .hint = std::move(hint)};
}

Diagnostic propertyDiagnostic(Severity severity, std::string id, const PropertyEntry& entry,
                              std::string message, std::string hint, std::string_view word) {
  Diagnostic diagnostic{.severity = severity,
                        .id = std::move(id),
                        .at = entry.at,
                        .message = std::move(message),
                        .sourceLine = shown(entry.lines.front()),
                        .hint = std::move(hint)};
  for (size_t i = 0; i < entry.lines.size(); ++i) {
    const size_t column = findWord(entry.lines[i], word);
    if (column == std::string::npos) continue;
    diagnostic.at.line += static_cast<int>(i);
    diagnostic.at.column = static_cast<int>(column) + 1;
    diagnostic.sourceLine = shown(entry.lines[i]);
    break;
  }
  return diagnostic;
}

}  // namespace orris
