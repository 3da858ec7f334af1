#include <orris/validate/consequences.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <tuple>

#include <orris/check/pack/pack_texts.h>
#include <orris/core/characters.h>
#include <orris/pack/files/text.h>
#include <orris/validate/unrepaired_consequences.h>

namespace orris {
namespace {

struct RepairStage {
  std::array<std::string_view, 2> ids;
  bool misread = true;  ///< the compiler misreads the rest of a program, whatever it says of it
  bool named =
      false;  ///< only where another finding names what was meant: checking again takes time
};

// Each is compared with all other findings.
constexpr std::size_t kMostNamed = 200;

// A comment may swallow an #endif, and that a brace: what comes first is repaired first.
constexpr std::array<RepairStage, 7> kStages = {
    {{{"include-missing", "include-escape"}},
     {{"comment-nested", "comment-unclosed"}},
     {{"directive-unknown"}},
     {{"conditional-unbalanced"}},
     {{"brace-unbalanced"}},
     {{"include-probably-missing", "name-misspelt"}, false},
     {{"directive-misspelt", "property-unknown"}, false, true}}};

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
                    const Checker& checker, CheckAgain check, ProblemList& problems)
      : verdict_(verdict),
        options_(options),
        checker_(checker),
        check_(check),
        problems_(problems),
        folds_(verdict, problems) {}

  void run() {
    foldTwins(folds_);
    for (const RepairStage& stage : kStages) {
      const std::vector<std::size_t> causes = causesOf(stage);
      if (causes.empty()) continue;
      for (const std::size_t cause : causes) edits_.add(*problems_.all()[cause].repair);
      repaired_.insert(causes.begin(), causes.end());
      settle(causes, stage.misread);
    }
    foldByNames(folds_, *verdict_.files);
  }

 private:
  std::vector<std::size_t> causesOf(const RepairStage& stage) const {
    std::vector<std::size_t> causes;
    std::size_t asked = 0;
    for (std::size_t i = 0; i < problems_.all().size(); ++i) {
      const Diagnostic& d = problems_.all()[i];
      const bool listed = std::ranges::find(stage.ids, d.id) != stage.ids.end();
      if (listed && d.repair && d.severity != Severity::Note && folds_.isOpen(i) &&
          (!stage.named || (++asked <= kMostNamed && isNamed(i))))
        causes.push_back(i);
    }
    return causes;
  }

  /// Does another finding have the longest word of the hint, "did you mean screen.LIGHT?"
  bool isNamed(std::size_t cause) const {
    std::string_view meant;
    forEachWord(problems_.all()[cause].hint,
                [&](std::string_view word) { meant = word.size() > meant.size() ? word : meant; });
    for (std::size_t i = 0; i < problems_.all().size(); ++i) {
      const Diagnostic& d = problems_.all()[i];
      const auto names = [&](const std::string& text) { return text.find(meant) != text.npos; };
      if (i != cause && d.severity != Severity::Note && folds_.isOpen(i) &&
          (names(d.message) || names(d.hint) || std::ranges::any_of(d.notes, names)))
        return true;
    }
    return false;
  }

  void settle(const std::vector<std::size_t>& causes, bool misread) {
    ProblemList after;
    check_(edits_.apply(verdict_.files), options_, checker_, after);
    std::map<FindingKey, int> left;
    for (const Diagnostic& d : after.all()) ++left[positionKey(d, edits_)];
    std::set<FindingKey> known;
    for (const Diagnostic& d : problems_.all()) known.insert(positionKey(d, {}));
    const bool fits = !misread || std::ranges::none_of(after.all(), [&](const Diagnostic& d) {
      return d.severity == Severity::Error && !known.contains(positionKey(d, edits_));
    });
    for (std::size_t i = 0; i < problems_.all().size(); ++i) {
      // The edits of earlier stages are made, too: what they repair follows from nothing.
      if (!folds_.isOpen(i) || repaired_.contains(i)) continue;
      const bool gone = --left[positionKey(problems_.all()[i], {})] < 0;
      const auto cause = gone   ? nearestCause(causes, i)
                         : fits ? std::nullopt
                                : causeRead(causes, i);
      if (cause) folds_.fold(i, *cause);
    }
  }

  /// Of a file that the finding was met through, else the first.
  std::optional<std::size_t> nearestCause(const std::vector<std::size_t>& causes, std::size_t i) {
    const Diagnostic& d = problems_.all()[i];
    for (const std::size_t cause : causes) {
      const std::string& file = problems_.all()[cause].at.file;
      const bool included =
          std::ranges::find(d.includedFrom, file, &SourceLocation::file) != d.includedFrom.end();
      if (d.at.file == file || included) return cause;
    }
    const auto read = causeRead(causes, i);
    return read ? read : causes.front();
  }

  /// Of an error: the cause whose file a program of it reads.
  std::optional<std::size_t> causeRead(const std::vector<std::size_t>& causes, std::size_t i) {
    if (problems_.all()[i].severity != Severity::Error) return std::nullopt;
    for (const std::size_t cause : causes) {
      for (const std::string& entry : problems_.entryFiles(i)) {
        if (folds_.filesOf(entry).contains(problems_.all()[cause].at.file)) return cause;
      }
    }
    return std::nullopt;
  }

  const PackVerdict& verdict_;
  const ValidateOptions& options_;
  const Checker& checker_;
  CheckAgain check_;
  ProblemList& problems_;
  Folds folds_;
  Edits edits_;
  std::set<std::size_t> repaired_;  ///< the causes whose repairs are among the edits
};

}  // namespace

void findConsequences(const PackVerdict& verdict, const ValidateOptions& options,
                      const Checker& checker, CheckAgain check, ProblemList& problems) {
  ConsequenceSearch(verdict, options, checker, check, problems).run();
}

}  // namespace orris
