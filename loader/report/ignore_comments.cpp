#include <orris/report/ignore_comments.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <climits>
#include <optional>

#include <orris/check/rules/rules.h>
#include <orris/core/files/text_file.h>
#include <orris/pack/files/text.h>

namespace orris {
namespace {

constexpr std::string_view kMark = "orris:";

bool isPropertiesFile(std::string_view file) {
  return file.ends_with(".properties") || file.ends_with(".lang");
}

bool holdsPixels(std::string_view file) {
  constexpr std::array<std::string_view, 6> kEndings = {".png", ".jpg",  ".bin",
                                                        ".dat", ".data", ".raw"};
  return std::ranges::any_of(kEndings, [&](auto ending) { return file.ends_with(ending); });
}

// A backslash at the end continues a line, in GLSL as in Java's properties; two of them do not.
bool isContinued(std::string_view line) {
  const std::size_t last = line.find_last_not_of('\\');
  return (line.size() - (last == std::string_view::npos ? 0 : last + 1)) % 2 == 1;
}

/// An ignore comment as it stands in one line.
struct Comment {
  std::vector<std::string> ids;
  int column = 0;
  bool wholeFile = false;
  bool alone = false;  ///< nothing but blanks beside it
};

/// Reads "ignore(a, b)" or "ignore-file(a)"; leaves what follows in `text`.
bool readCall(std::string_view& text, Comment& comment) {
  text = text.substr(std::min(text.find_first_not_of(" \t"), text.size()));
  constexpr std::string_view kIgnore = "ignore", kWhole = "-file";
  if (!text.starts_with(kIgnore)) return false;
  text.remove_prefix(kIgnore.size());
  comment.wholeFile = text.starts_with(kWhole);
  if (comment.wholeFile) text.remove_prefix(kWhole.size());
  const std::size_t close = text.find(')');
  if (!trim(text.substr(0, text.find('('))).empty() || close == std::string_view::npos) {
    return false;
  }
  const std::size_t open = text.find('(');
  for (const std::string_view id : splitAt(text.substr(open + 1, close - open - 1), ',')) {
    comment.ids.emplace_back(trim(id));
  }
  text.remove_prefix(close + 1);
  return true;
}

// The comment must open right before the word: a sentence that mentions it is none.
std::optional<Comment> readComment(std::string_view line, bool properties) {
  const std::size_t word = line.find(kMark);
  if (word == std::string_view::npos) return std::nullopt;
  std::string_view before = line.substr(0, word);
  before = before.substr(0, before.find_last_not_of(" \t") + 1);
  const bool block = before.ends_with("/*");
  const std::size_t opener = properties ? 1 : 2;
  if (properties ? !before.ends_with('#') : !block && !before.ends_with("//")) return std::nullopt;
  before.remove_suffix(opener);

  Comment comment{.column = static_cast<int>(before.size()) + 1};
  std::string_view rest = line.substr(word + kMark.size());
  if (!readCall(rest, comment)) return std::nullopt;
  const std::size_t end = block ? rest.find("*/") : std::string_view::npos;
  const bool codeAfter = end != std::string_view::npos && !trim(rest.substr(end + 2)).empty();
  comment.alone = trim(before).empty() && !codeAfter;
  // Java's properties know comments at the start of a line only.
  if (properties && !comment.alone) return std::nullopt;
  return comment;
}

/// Lines of one file, with the comments among them.
class MarkReader {
 public:
  MarkReader(const std::string& file, std::string_view text)
      : file_(file), lines_(splitLines(text)) {
    const bool properties = isPropertiesFile(file);
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      const bool insideValue =
          properties && i > 0 && isContinued(lines_[i - 1]) && !comments_[i - 1];
      comments_.push_back(insideValue ? std::nullopt : readComment(lines_[i], properties));
    }
  }

  std::vector<IgnoreMark> read() const {
    std::vector<IgnoreMark> marks;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      if (!comments_[i]) continue;
      const Comment& comment = *comments_[i];
      IgnoreMark mark{.at = {file_, static_cast<int>(i) + 1, comment.column},
                      .sourceLine = lines_[i]};
      const std::size_t first = comment.alone ? nextCode(i) : i;
      mark.first = comment.wholeFile ? 0 : static_cast<int>(first) + 1;
      mark.last = comment.wholeFile ? INT_MAX : static_cast<int>(lastOfLogicalLine(first)) + 1;
      for (const std::string& id : comment.ids) {
        mark.id = id;
        marks.push_back(mark);
      }
    }
    return marks;
  }

 private:
  /// The line that a comment alone on line `i` is about: blank lines and further ignore comments
  /// may stand between.
  std::size_t nextCode(std::size_t i) const {
    for (++i; i < lines_.size(); ++i) {
      if (!trim(lines_[i]).empty() && !(comments_[i] && comments_[i]->alone)) break;
    }
    return i;
  }

  std::size_t lastOfLogicalLine(std::size_t i) const {
    while (i + 1 < lines_.size() && isContinued(lines_[i])) ++i;
    return i;
  }

  const std::string& file_;
  std::vector<std::string> lines_;
  std::vector<std::optional<Comment>> comments_;
};

std::vector<std::string> ruleNames() {
  std::vector<std::string> names;
  for (const Rule& rule : ruleTable()) names.emplace_back(rule.id);
  return names;
}

Diagnostic problemOf(const IgnoreMark& mark) {
  Diagnostic d{.at = mark.at, .sourceLine = mark.sourceLine};
  if (findRule(mark.id) == nullptr) {
    d.severity = Severity::Warning;
    d.id = "ignore-unknown";
    d.message = fmt::format("there is no check \"{}\"", mark.id);
    d.hint = suggest(mark.id, ruleNames());
  } else {
    d.severity = Severity::Note;
    d.id = "ignore-unused";
    d.message = fmt::format("this comment silences no {}", mark.id);
    d.hint = "take it out, or put it on the line of the problem or alone above it";
  }
  return d;
}

}  // namespace

std::vector<IgnoreMark> readIgnoreMarks(const std::string& file, std::string_view text) {
  if (text.find(kMark) == std::string_view::npos) return {};
  return MarkReader(file, text).read();
}

IgnoreComments::IgnoreComments(const FileSource& files) {
  for (const std::string& file : files.files()) {
    if (holdsPixels(file)) continue;
    const auto text = readText(files, file);
    if (!text) continue;
    std::vector<IgnoreMark> marks = readIgnoreMarks(file, *text);
    if (!marks.empty()) marks_.emplace(file, std::move(marks));
  }
}

bool IgnoreComments::silences(const Diagnostic& diagnostic) {
  const auto found = marks_.find(diagnostic.at.file);
  if (found == marks_.end()) return false;
  bool silenced = false;
  for (IgnoreMark& mark : found->second) {
    if (mark.id != diagnostic.id || diagnostic.at.line < mark.first ||
        diagnostic.at.line > mark.last) {
      continue;
    }
    mark.used = silenced = true;
  }
  return silenced;
}

Diagnostics IgnoreComments::problems() const {
  Diagnostics problems;
  for (const auto& entry : marks_) {
    for (const IgnoreMark& mark : entry.second) {
      if (!mark.used) problems.push_back(problemOf(mark));
    }
  }
  return problems;
}

}  // namespace orris
