#include "app/report/consequences.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <tuple>

#include "check/hints/compile_hints.h"
#include "core/characters.h"
#include "pack/files/include_graph.h"
#include "pack/files/text.h"

namespace orris {
namespace {

struct RepairStage {
  std::array<std::string_view, 2> ids;
  bool misread = true;  ///< the compiler misreads the rest of a program, whatever it says of it
};

// A comment may swallow an #endif, and that a brace: what comes first is repaired first.
constexpr std::array<RepairStage, 4> kStages = {
    {{{"comment-nested", "comment-unclosed"}},
     {{"conditional-unbalanced"}},
     {{"brace-unbalanced"}},
     {{"include-probably-missing", "name-misspelt"}, false}}};

// The repaired pack is not drawn.
constexpr std::array<std::string_view, 2> kOfDrawing = {"draw-timeout", "gl-error"};

// "i" and "uv" of two functions are two names.
constexpr std::size_t kLongestLocal = 3;

/// The files of a pack, some of them edited.
class EditedFiles : public FileSource {
 public:
  EditedFiles(std::shared_ptr<const FileSource> files, std::map<std::string, std::string> edited)
      : files_(std::move(files)), edited_(std::move(edited)) {}
  std::optional<std::string> read(std::string_view path) const override {
    const auto edited = edited_.find(std::string(path));
    return edited == edited_.end() ? files_->read(path) : edited->second;
  }
  const std::vector<std::string>& files() const override { return files_->files(); }

 private:
  std::shared_ptr<const FileSource> files_;
  std::map<std::string, std::string> edited_;
};

/// Edits of lines, all numbers those of the author's files.
class Edits {
 public:
  void add(const LineEdit& edit) { files_[edit.file].insert({edit.line, edit}); }

  std::shared_ptr<const FileSource> apply(const std::shared_ptr<const FileSource>& files) const {
    std::map<std::string, std::string> edited;
    for (const auto& [file, edits] : files_) {
      std::vector<std::string> lines = splitLines(files->read(file).value_or(""));
      // From the end, so that numbers stay what they are.
      for (auto edit = edits.rbegin(); edit != edits.rend(); ++edit) applyTo(lines, edit->second);
      std::string& text = edited[file];
      for (const std::string& line : lines) text += line + '\n';
    }
    return std::make_shared<EditedFiles>(files, std::move(edited));
  }

  /// The author's number of a line of an edited file.
  int authorLine(const SourceLocation& at) const {
    const auto edits = files_.find(at.file);
    if (edits == files_.end()) return at.line;
    int line = at.line;
    for (const auto& [before, edit] : edits->second) {
      if (!edit.replaces && line > before) --line;
    }
    return line;
  }

 private:
  static void applyTo(std::vector<std::string>& lines, const LineEdit& edit) {
    const auto size = std::ssize(lines);
    const auto at = std::clamp<std::ptrdiff_t>(edit.line - 1, 0, size);
    if (edit.replaces && at < size)
      lines[std::size_t(at)] = edit.text;
    else
      lines.insert(lines.begin() + at, edit.text);
  }

  std::map<std::string, std::map<int, LineEdit>> files_;
};

// Messages name lines, which move.
using FindingKey = std::tuple<std::string, std::string, int, std::string>;

FindingKey positionKey(const Diagnostic& d, const Edits& edits) {
  std::string message = d.message;
  std::erase_if(message, isDigit);
  return {d.id, d.at.file, edits.authorLine(d.at), std::move(message)};
}

class ConsequenceSearch {
 public:
  ConsequenceSearch(const PackVerdict& verdict, const ValidateOptions& options,
                    const Checker& checker, CheckAgain check, Report& report)
      : verdict_(verdict), options_(options), checker_(checker), check_(check), report_(report) {}

  void run() {
    for (const RepairStage& stage : kStages) {
      const std::vector<std::size_t> causes = causesOf(stage.ids);
      if (causes.empty()) continue;
      for (const std::size_t cause : causes) edits_.add(*report_.all()[cause].repair);
      settle(causes, stage.misread);
    }
    foldVaryings();
    foldNames();
  }

 private:
  bool isOpen(std::size_t i) const {
    return !report_.cause(i) && !verdict_.ofMatrix.contains(i) &&
           std::ranges::find(kOfDrawing, report_.all()[i].id) == kOfDrawing.end();
  }

  std::vector<std::size_t> causesOf(const std::array<std::string_view, 2>& ids) const {
    std::vector<std::size_t> causes;
    for (std::size_t i = 0; i < report_.all().size(); ++i) {
      const Diagnostic& d = report_.all()[i];
      const bool listed = std::ranges::find(ids, d.id) != ids.end();
      if (listed && d.repair && d.severity != Severity::Note && isOpen(i)) causes.push_back(i);
    }
    return causes;
  }

  void settle(const std::vector<std::size_t>& causes, bool misread) {
    Report after(options_.output, Report::Mode::Keep);
    check_(edits_.apply(verdict_.files), options_, checker_, after);
    std::map<FindingKey, int> left;
    for (const Diagnostic& d : after.all()) ++left[positionKey(d, edits_)];
    std::set<FindingKey> known;
    for (const Diagnostic& d : report_.all()) known.insert(positionKey(d, {}));
    const bool fits = !misread || std::ranges::none_of(after.all(), [&](const Diagnostic& d) {
      return d.severity == Severity::Error && !known.contains(positionKey(d, edits_));
    });
    for (std::size_t i = 0; i < report_.all().size(); ++i) {
      if (!isOpen(i) || std::ranges::find(causes, i) != causes.end()) continue;
      const bool gone = --left[positionKey(report_.all()[i], {})] < 0;
      const auto cause = gone   ? nearestCause(causes, i)
                         : fits ? std::nullopt
                                : causeRead(causes, i);
      if (cause) fold(i, *cause);
    }
  }

  /// What a stage that several programs share does not declare, none of their next stages gets.
  void foldVaryings() {
    std::map<std::string, std::size_t> causes;
    for (std::size_t i = 0; i < report_.all().size(); ++i) {
      const Diagnostic& d = report_.all()[i];
      const std::string name = unknownName(d.message);
      if (!name.empty() && !d.related.empty() && d.severity == Severity::Error && isOpen(i))
        causes.try_emplace("'" + name + "' ", i);
    }
    for (std::size_t i = 0; i < report_.all().size(); ++i) {
      const Diagnostic& d = report_.all()[i];
      if (d.id != "varying-missing" || !isOpen(i)) continue;
      for (const auto& [name, cause] : causes) {
        if (d.message.starts_with(name)) fold(i, cause);
      }
    }
  }

  /// Errors about one unknown name are one mistake, the first of them.
  void foldNames() {
    std::map<std::string, std::size_t> first;
    for (std::size_t i = 0; i < report_.all().size(); ++i) {
      const Diagnostic& d = report_.all()[i];
      const std::string name = unknownName(d.message);
      if (name.size() < kLongestLocal || d.severity != Severity::Error || !isOpen(i)) continue;
      const auto [known, isNew] = first.try_emplace(name, i);
      if (!isNew) fold(i, known->second);
    }
  }

  void fold(std::size_t i, std::size_t cause) {
    report_.setCause(i, cause);
    if (report_.all()[i].severity == Severity::Error) report_.setSeverity(cause, Severity::Error);
  }

  /// Of a file that the finding was met through, else the first.
  std::optional<std::size_t> nearestCause(const std::vector<std::size_t>& causes, std::size_t i) {
    const Diagnostic& d = report_.all()[i];
    for (const std::size_t cause : causes) {
      const std::string& file = report_.all()[cause].at.file;
      const bool included =
          std::ranges::find(d.includedFrom, file, &SourceLocation::file) != d.includedFrom.end();
      if (d.at.file == file || included) return cause;
    }
    const auto read = causeRead(causes, i);
    return read ? read : causes.front();
  }

  /// Of an error: the cause whose file a program of it reads.
  std::optional<std::size_t> causeRead(const std::vector<std::size_t>& causes, std::size_t i) {
    if (report_.all()[i].severity != Severity::Error) return std::nullopt;
    for (const std::size_t cause : causes) {
      for (const std::string& entry : report_.entryFiles(i)) {
        if (filesOf(entry).contains(report_.all()[cause].at.file)) return cause;
      }
    }
    return std::nullopt;
  }

  /// All files that the file reads, itself among them.
  const std::set<std::string>& filesOf(const std::string& entry) {
    const auto [known, isNew] = files_.try_emplace(entry);
    if (isNew && verdict_.files->contains(entry)) {
      Diagnostics ignored;  // reported when the pack was read
      for (const auto& file : readIncludeGraph(*verdict_.files, {entry}, ignored).files)
        known->second.insert(file.first);
    }
    return known->second;
  }

  const PackVerdict& verdict_;
  const ValidateOptions& options_;
  const Checker& checker_;
  CheckAgain check_;
  Report& report_;
  Edits edits_;
  std::map<std::string, std::set<std::string>> files_;
};

}  // namespace

void findConsequences(const PackVerdict& verdict, const ValidateOptions& options,
                      const Checker& checker, CheckAgain check, Report& report) {
  ConsequenceSearch(verdict, options, checker, check, report).run();
}

}  // namespace orris
