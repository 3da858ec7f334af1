#include <orris/check/pack/open_comments.h>

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include <orris/check/hints/compile_hints.h>
#include <orris/check/hints/glsl_functions.h>
#include <orris/check/hints/line_trial.h>
#include <orris/check/pack/pack_texts.h>
#include <orris/check/workers/diagnostic_codec.h>
#include <orris/check/workers/isolated_jobs.h>
#include <orris/pack/files/pack_files.h>
#include <orris/pack/files/text.h>

namespace orris {
namespace {

// Packs are untrusted; each trial compiles up to this many programs.
constexpr std::size_t kMostComments = 8, kMostUnits = 2;
constexpr const char* kNested = "comment-nested";
constexpr const char* kUnbalanced = "conditional-unbalanced";

bool startsParagraph(std::string_view line) {
  const std::string_view text = trim(line);
  return text.empty() || text.front() == '#';
}

/// Reads one file character by character, as a compiler parts comments from code.
class CommentScan {
 public:
  explicit CommentScan(const FileLines& lines) : lines_(lines) {}

  std::vector<OpenComment> run() {
    for (number_ = 1; number_ <= int(lines_.size()); ++number_) readLine(lines_[number_ - 1]);
    // The comment goes on in whatever is included next.
    if (inside_ && current_.nestedLine == 0) current_.nestedLine = number_;
    if (inside_) close();
    return std::move(found_);
  }

 private:
  void readLine(std::string_view line) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const std::string_view two = line.substr(i, 2);
      if (!inside_ && two == "//") return;
      if (!inside_ && two == "/*") {
        open(line.substr(0, i), int(i) + 1);
        ++i;
      } else if (inside_ && two == "*/") {
        close();
        ++i;
      } else if (inside_ && two == "/*" && isNested(line, i)) {
        if (current_.nestedLine == 0) {
          current_.nestedLine = number_, current_.nestedColumn = int(i) + 1;
          current_.likelyLost = current_.ofOption || trim(line.substr(0, i)).empty();
        }
      }
    }
  }

  // "/*/" ends a comment, "//*" begins a line of decoration.
  static bool isNested(std::string_view line, std::size_t at) {
    const bool ends = at + 2 < line.size() && line[at + 2] == '/';
    return !ends && (at == 0 || line[at - 1] != '/');
  }

  void open(std::string_view before, int column) {
    inside_ = true;
    current_ = {.line = number_, .column = column};
    current_.ofOption = trim(before).starts_with("#define");
  }

  void close() {
    inside_ = false;
    if (current_.nestedLine <= current_.line) return;
    std::set<int> ends = {current_.line + 1, current_.nestedLine};
    for (int line = current_.line + 1; line < current_.nestedLine; ++line) {
      if (!startsParagraph(lines_[line - 1])) continue;
      ends.insert(line);
      break;
    }
    current_.ends.assign(ends.begin(), ends.end());
    found_.push_back(current_);
  }

  const FileLines& lines_;
  int number_ = 0;
  bool inside_ = false;
  OpenComment current_;
  std::vector<OpenComment> found_;
};

struct CommentInFile {
  std::string file;
  OpenComment comment;
  std::vector<ProgramUnit> samples;  ///< that fail and read the file
};

std::set<std::string> filesRead(const FolderBuild& build, const ProgramUnit& unit) {
  std::set<std::string> files;
  for (const StageText* stage : unit.stages) {
    if (stage->text.sites.empty()) continue;
    for (const auto& file : reachableFiles(build.files().graph, stage->text.sites.front().file))
      files.insert(file);
  }
  return files;
}

/// What the errors of a folder say is not there.
class Lacking {
 public:
  explicit Lacking(const Diagnostics& diagnostics) {
    for (const Diagnostic& d : diagnostics) {
      if (d.severity != Severity::Error && d.id != kUnbalanced) continue;
      const std::string name = unknownName(d.message);
      if (isOfLanguage(d.message, name)) continue;
      anything_ = true;
      if (!name.empty()) names_.insert(name);
      if (d.message.find("Missing entry point") != std::string::npos) names_.insert("main");
      braces_ = braces_ || d.id == "brace-unbalanced";
    }
  }

  /// May the lines of the comment hold it? A directive may be anything's.
  bool isIn(const OpenComment& comment, const FileLines& lines) const {
    bool found = false;
    if (!anything_) return found;
    for (int number = comment.line; number < comment.nestedLine && !found; ++number) {
      const std::string& line = lines[std::size_t(number) - 1];
      found = braces_ && line.find_first_of("{}") != std::string::npos;
      if (number > comment.line && trim(line).starts_with('#') && trim(line).size() > 1)
        found = true;
      forEachWord(line, [&](std::string_view word) { found = found || names_.contains(word); });
    }
    return found;
  }

 private:
  /// A built-in function called with other types, or a constant that is none: no line is missing.
  static bool isOfLanguage(const std::string& message, const std::string& name) {
    return std::ranges::binary_search(builtInFunctions(), name) ||
           message.find("initializers must be constant") != std::string::npos;
  }

  std::set<std::string, std::less<>> names_;
  bool anything_ = false, braces_ = false;
};

std::vector<CommentInFile> commentsOfFailing(const ShaderPack& folder, const Verdicts& verdicts,
                                             const Lacking& lacking) {
  std::map<std::string, std::vector<OpenComment>> scanned;
  std::map<std::pair<std::string, int>, CommentInFile> found;
  for (const ProgramUnit& unit : programUnits(folder)) {
    const auto verdict = verdicts.find(unit.hash);
    const FolderBuild* build = buildOf(folder, *unit.program);
    if (!build || unit.incomplete || verdict == verdicts.end() || verdict->second) continue;
    if (hasUnclosedComment(*unit.program)) continue;  // reported at its place
    for (const std::string& file : filesRead(*build, unit)) {
      const auto [comments, isNew] = scanned.try_emplace(file);
      if (isNew && build->lines(file)) comments->second = findOpenComments(*build->lines(file));
      for (const OpenComment& comment : comments->second) {
        const bool known = found.contains({file, comment.line});
        if (!known &&
            (found.size() >= kMostComments || !lacking.isIn(comment, *build->lines(file))))
          continue;
        CommentInFile& entry = found[{file, comment.line}];
        entry.file = file;
        entry.comment = comment;
        if (entry.samples.size() < kMostUnits) entry.samples.push_back(unit);
      }
    }
  }
  std::vector<CommentInFile> result;
  for (auto& [place, entry] : found) result.push_back(std::move(entry));
  return result;
}

std::ptrdiff_t problemsWith(const ShaderPack& folder, const CommentInFile& in,
                            const AddedLine& added) {
  std::ptrdiff_t problems = 0;
  for (const ProgramUnit& unit : in.samples) {
    const auto left = diagnosticsWith(folder, unit, added, CompileErrors::First);
    problems += std::ranges::count_if(left ? *left : unit.program->diagnostics, [](const auto& d) {
      return d.severity == Severity::Error || d.id == kUnbalanced;
    });
  }
  return problems;
}

Diagnostic describeNested(const std::string& file, const OpenComment& comment) {
  if (comment.nestedColumn == 0) {
    return {.severity = Severity::Warning,
            .id = kNested,
            .at = {file, comment.line, comment.column},
            .message = "this comment does not end in its file"};
  }
  return {.severity = comment.likelyLost ? Severity::Warning : Severity::Note,
          .id = kNested,
          .at = {file, comment.line, comment.column},
          .message = fmt::format("this comment does not end before the \"/*\" in line {}",
                                 comment.nestedLine),
          .related = {{{file, comment.nestedLine, comment.nestedColumn},
                       "\"/*\" within a comment begins none"}}};
}

/// The comment as a mistake if closing it leaves at most half of the problems.
Diagnostics trySwallowing(const ShaderPack& folder, const CommentInFile& in) {
  const std::ptrdiff_t before = problemsWith(folder, in, {in.file, in.comment.line, "", " "});
  std::ptrdiff_t least = before;
  LineEdit best;
  for (const int end : in.comment.ends) {
    const auto left = problemsWith(folder, in, {in.file, end, "", "*/"});
    if (left < least) least = left, best = {in.file, end, "*/"};
    if (left == 0) break;
  }
  if (least * 2 > before || before == 0) return {};
  Diagnostic d = describeNested(in.file, in.comment);
  d.severity = Severity::Error;
  d.message =
      in.comment.nestedColumn > 0
          ? fmt::format("this comment swallows code: it has no \"*/\" before the \"/*\" in line {}",
                        in.comment.nestedLine)
          : "this comment swallows code: it has no \"*/\" in this file";
  d.sourceLine = folder.sourceLine(in.file, in.comment.line);
  d.hint = "write // for a comment of one line, or close it with */";
  d.repair = best;
  // Behind an option the list of its values is to be read, too.
  if (in.comment.ofOption && best.line == in.comment.line + 1) {
    std::string line = d.sourceLine;
    d.repair = LineEdit{in.file, in.comment.line,
                        line.replace(std::size_t(in.comment.column - 1), 2, "//"), true};
  }
  return {d};
}

}  // namespace

std::vector<OpenComment> findOpenComments(const FileLines& lines) {
  return CommentScan(lines).run();
}

bool readsOpenEndedFile(const ShaderPack& folder, const ProgramUnit& unit) {
  const FolderBuild* build = buildOf(folder, *unit.program);
  return build && std::ranges::any_of(filesRead(*build, unit), [&](const std::string& file) {
           const FileLines* lines = build->lines(file);
           return lines && std::ranges::any_of(findOpenComments(*lines), [](const auto& comment) {
                    return comment.nestedColumn == 0;
                  });
         });
}

void reportSwallowedCode(const ShaderPack& folder, const Verdicts& verdicts, int jobs,
                         Diagnostics& diagnostics) {
  const std::vector<CommentInFile> comments =
      commentsOfFailing(folder, verdicts, Lacking(diagnostics));
  std::vector<Diagnostics> found(comments.size());
  const auto work = [&](std::size_t i) {
    return encodeDiagnostics(trySwallowing(folder, comments[i]));
  };
  runIsolated({.count = comments.size(), .workers = jobs, .work = work},
              [&](std::size_t i, const JobOutcome& outcome) {
                if (outcome.kind == JobOutcome::Kind::Done)
                  found[i] = decodeDiagnostics(outcome.result);
                return true;
              });
  for (const Diagnostics& mistakes : found)
    diagnostics.insert(diagnostics.end(), mistakes.begin(), mistakes.end());
}

void checkNestedComments(std::span<const ShaderPack> folders, Diagnostics& diagnostics) {
  for (const auto& [file, lines] : folders.front().files) {
    for (const OpenComment& comment : findOpenComments(lines))
      diagnostics.push_back(describeNested(file, comment));
  }
}

}  // namespace orris
