#include <orris/pack/ids/id_lines.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include <orris/pack/files/text.h>

namespace orris {
namespace {

constexpr std::string_view kBlockKey = "block.";

/// "block.12", "layer.solid": what its author meant to start an entry.
bool startsIdKey(std::string_view line) {
  constexpr std::array<std::string_view, 4> kKeyPrefixes{kBlockKey, "layer.", "item.", "entity."};
  return std::any_of(kKeyPrefixes.begin(), kKeyPrefixes.end(),
                     [&](auto prefix) { return line.starts_with(prefix); });
}

bool endsInContinuation(std::string_view line) {
  const size_t last = line.find_last_not_of('\\');
  return (line.size() - (last == std::string_view::npos ? 0 : last + 1)) % 2 == 1;
}

/// Text of one or several of the author's lines.
struct Piece {
  struct Origin {
    size_t offset, line;
  };
  std::string text;
  std::vector<Origin> origins;

  void append(const Piece& next) {
    for (const Origin& origin : next.origins)
      origins.push_back({text.size() + origin.offset, origin.line});
    text += next.text;
  }
  size_t lineAt(size_t offset) const {
    size_t line = origins.front().line;
    for (const Origin& origin : origins) line = origin.offset <= offset ? origin.line : line;
    return line;
  }
  /// What stands from `offset` on.
  Piece rest(size_t offset) const {
    Piece result{text.substr(offset), {{0, lineAt(offset)}}};
    for (const Origin& origin : origins) {
      if (origin.offset > offset) result.origins.push_back({origin.offset - offset, origin.line});
    }
    return result;
  }
  void cut(size_t offset) {
    text.resize(offset);
    while (origins.size() > 1 && origins.back().offset >= offset) origins.pop_back();
  }
};

class IdLines {
 public:
  IdLines(const std::string& file, std::string_view text, std::string_view original,
          Diagnostics* diagnostics)
      : file_(file),
        active_(splitLines(text)),
        original_(splitLines(original)),
        diagnostics_(diagnostics) {
    original_.resize(std::max(original_.size(), active_.size()));
  }

  std::vector<PropertyEntry> read() {
    std::vector<Piece> pieces;
    for (Piece& piece : joinedOverGaps()) splitAtKeys(std::move(piece), pieces);
    std::vector<PropertyEntry> entries;
    for (size_t i = 0; i < pieces.size(); ++i) addEntry(continued(pieces, i), entries);
    return entries;
  }

 private:
  // Iris takes out the lines that the author left blank; directives, comments and inactive lines
  // become blank ones.
  std::vector<Piece> nonBlank() const {
    std::vector<Piece> lines;
    for (size_t i = 0; i < active_.size(); ++i) {
      const std::string_view line = trim(active_[i]);
      if (!line.empty() || !trim(original_[i]).empty())
        lines.push_back({std::string(line), {{0, i}}});
    }
    return lines;
  }

  /// A backslash before such a blank line joins with what follows all of them.
  std::vector<Piece> joinedOverGaps() {
    const std::vector<Piece> lines = nonBlank();
    std::vector<Piece> joined;
    const auto blank = [&](size_t i) { return i < lines.size() && lines[i].text.empty(); };
    for (size_t i = 0; i < lines.size(); ++i) {
      Piece piece = lines[i];
      while (piece.text.ends_with('\\') && blank(i + 1)) {
        piece.text.back() = ' ';
        while (blank(i + 1)) ++i;
        if (i + 1 == lines.size()) break;
        const Piece& next = lines[++i];
        if (startsIdKey(next.text) && !next.text.starts_with(kBlockKey)) reportSwallowed(next);
        piece.append(next);
      }
      joined.push_back(std::move(piece));
    }
    return joined;
  }

  /// Iris starts a line before each "block." and takes the letter before it away.
  void splitAtKeys(Piece piece, std::vector<Piece>& pieces) {
    for (size_t from = 0;;) {
      const size_t key = piece.text.find(kBlockKey, from);
      if (key == std::string::npos) break;
      from = key + kBlockKey.size();
      const size_t before =
          key == 0 ? std::string::npos : piece.text.find_last_not_of(' ', key - 1);
      if (before == std::string::npos || trim(piece.text.substr(before, 1)).empty()) continue;
      reportLostLetter(piece, before, key);
      Piece rest = piece.rest(key);
      piece.cut(before);
      pieces.push_back(std::move(piece));
      piece = std::move(rest);
      from = kBlockKey.size();
    }
    pieces.push_back(std::move(piece));
  }

  /// The logical line that starts at `index`, which is left on its last piece.
  Piece continued(const std::vector<Piece>& pieces, size_t& index) {
    Piece piece = pieces[index];
    while (endsInContinuation(piece.text)) {
      piece.text.pop_back();
      if (index + 1 == pieces.size()) break;
      const Piece& next = pieces[++index];
      if (startsIdKey(next.text)) reportSwallowed(next);
      piece.append(next);
    }
    return piece;
  }

  void addEntry(const Piece& piece, std::vector<PropertyEntry>& entries) const {
    const auto parsed = parseProperties(file_, piece.text, Continuation::Java);
    if (parsed.empty()) return;
    PropertyEntry entry = parsed.front();
    const size_t first = piece.origins.front().line, last = piece.origins.back().line;
    const size_t column = original_[first].find(piece.text.substr(0, entry.key.size()));
    entry.at = {file_, static_cast<int>(first) + 1,
                static_cast<int>(column == std::string::npos ? 0 : column) + 1};
    entry.lines.clear();
    for (size_t line = first; line <= last; ++line)
      entry.lines.push_back(trim(active_[line]).empty() ? "" : original_[line]);
    entries.push_back(std::move(entry));
  }

  void report(size_t line, size_t column, std::string id, std::string message, std::string hint,
              Effect effect) {
    if (!diagnostics_) return;
    diagnostics_->push_back({.severity = Severity::Warning,
                             .id = std::move(id),
                             .at = {file_, static_cast<int>(line) + 1, static_cast<int>(column)},
                             .message = std::move(message),
                             .sourceLine = original_[line],
                             .hint = std::move(hint),
                             .effect = effect});
  }

  void reportSwallowed(const Piece& piece) {
    const size_t line = piece.origins.front().line;
    const std::string key = piece.text.substr(0, piece.text.find_first_of("= \t:"));
    report(line, original_[line].find_first_not_of(" \t") + 1, "id-swallowed",
           fmt::format("the line before ends in a backslash, so Iris takes this one as more of its "
                       "list: {} is no key",
                       key),
           "take the backslash away", Effect::IgnoresLine);
  }

  void reportLostLetter(const Piece& piece, size_t letter, size_t key) {
    // Of a key whose list is empty nothing is lost.
    if (piece.text[letter] == '=' || piece.text[letter] == ':') return;
    const size_t begin = piece.text.find_last_of(" \t=", letter) + 1;
    const std::string word = piece.text.substr(begin, letter + 1 - begin);
    const size_t line = piece.lineAt(letter);
    const size_t column = original_[line].rfind(word);
    report(line, column == std::string::npos ? 1 : column + word.size(), "id-letter-lost",
           fmt::format("Iris loses the last letter of {}, for {} follows on the same line or after "
                       "a backslash and a comment",
                       word, leadingKey(piece, key)),
           "take the backslash away, and start each key on a line of its own", Effect::Unstated);
  }

  static std::string leadingKey(const Piece& piece, size_t key) {
    return piece.text.substr(key, piece.text.find_first_of("= \t:", key) - key);
  }

  const std::string& file_;
  std::vector<std::string> active_, original_;
  Diagnostics* diagnostics_;
};

}  // namespace

std::vector<PropertyEntry> parseIdLines(const std::string& file, std::string_view text,
                                        std::string_view original, Diagnostics* diagnostics) {
  return IdLines(file, text, original, diagnostics).read();
}

}  // namespace orris
