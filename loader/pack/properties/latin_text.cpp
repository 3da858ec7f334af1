#include <orris/pack/properties/latin_text.h>

#include <fmt/format.h>

#include <optional>
#include <utility>
#include <vector>

#include <orris/pack/files/text.h>

namespace orris {
namespace {

constexpr char kNextLine = '\x85';  ///< ends a line, as \n does

/// Java: Character.isUnicodeIdentifierStart of a byte in Latin-1.
bool isLetter(unsigned char c) {
  return c == 0xAA || c == 0xB5 || c == 0xBA || (c >= 0xC0 && c != 0xD7 && c != 0xF7);
}
/// What may go on in a name: Java lets control characters stand there, too.
bool goesOn(unsigned char c) {
  return isWordCharacter(static_cast<char>(c)) || isLetter(c) || (c >= 0x7F && c < 0xA0);
}

/// The first character that is no token, outside of comments to the end of the line and strings.
std::optional<size_t> foreignIn(std::string_view line, size_t from) {
  for (size_t i = from; i < line.size();) {
    const auto c = static_cast<unsigned char>(line[i]);
    if (line.substr(i).starts_with("//")) return std::nullopt;
    const size_t quote = c == '"' ? line.find('"', i + 1) : std::string_view::npos;
    if (quote != std::string_view::npos) {
      i = quote + 1;
    } else if (isWordCharacter(line[i]) || isLetter(c)) {
      while (i < line.size() && goesOn(static_cast<unsigned char>(line[i]))) ++i;
    } else if (c < 0x80) {
      ++i;
    } else {
      return i;
    }
  }
  return std::nullopt;
}

/// In a comment, what follows a byte that ends its line is none.
std::optional<size_t> foreignInComment(std::string_view line) {
  const size_t end = line.find(kNextLine);
  return end == std::string_view::npos ? std::nullopt : foreignIn(line, end + 1);
}

struct ForeignPlace {
  size_t line, column;
};

std::optional<ForeignPlace> firstForeign(const std::vector<std::string>& lines,
                                         const std::vector<std::string>& active) {
  for (size_t i = 0; i < lines.size() && i < active.size(); ++i) {
    const bool isComment = trim(lines[i]).starts_with('#');
    const bool isActive = !trim(active[i]).empty();
    const auto at = isComment  ? foreignInComment(lines[i])
                    : isActive ? foreignIn(lines[i], 0)
                               : std::nullopt;
    if (at) return ForeignPlace{i, *at};
  }
  return std::nullopt;
}

}  // namespace

std::string upToForeignCharacter(const std::string& file, std::string_view original,
                                 std::string preprocessed, Diagnostics& diagnostics) {
  const auto lines = splitLines(original), active = splitLines(preprocessed);
  const auto place = firstForeign(lines, active);
  if (!place) return preprocessed;
  std::string kept;
  for (size_t i = 0; i < place->line; ++i) kept += active[i] + '\n';
  const std::string& last = active[place->line];
  kept += last.substr(0, foreignIn(last, 0).value_or(trim(last).empty() ? 0 : last.size()));
  // Lines stay in step with those of the author.
  kept.append(active.size() - place->line, '\n');
  diagnostics.push_back(
      {.severity = Severity::Warning,
       .id = "properties-character",
       .at = {file, static_cast<int>(place->line) + 1, static_cast<int>(place->column) + 1},
       .message = "Iris stops reading the file here: it takes the bytes of this letter for others, "
                  "which its preprocessor does not know",
       .sourceLine = lines[place->line],
       .hint = "write the file in ASCII letters, the comments too"});
  return kept;
}

}  // namespace orris
