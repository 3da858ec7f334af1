#include <orris/validate/unrepaired_consequences.h>

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include <orris/check/hints/compile_hints.h>
#include <orris/check/pack/pack_texts.h>
#include <orris/core/limits.h>
#include <orris/pack/files/include_graph.h>
#include <orris/pack/files/text.h>
#include <orris/pack/options/option_line.h>

namespace orris {
namespace {

// Of the stages of one program.
constexpr std::array<std::string_view, 5> kProgramEndings = {".vsh", ".tcs", ".tes", ".gsh",
                                                             ".fsh"};

// A fullscreen program and a compute shader may share their name.
constexpr std::string_view kComputeEnding = ".csh";

// The repaired pack is not drawn.
constexpr std::array<std::string_view, 2> kOfDrawing = {"draw-timeout", "gl-error"};

// What a stage lacks when a file of it is missing: what is wrong with its own lines is a mistake of its own.
constexpr std::array<std::string_view, 4> kOfLackingNames = {"varying-", "output-", "target-unread",
                                                             "target-unwritten"};

constexpr std::array<std::string_view, 3> kOfTargets = {"output-", "target-unread",
                                                         "target-unwritten"};

// Errors after which a file, and what it includes, is not read.
constexpr std::array<std::string_view, 4> kUnread = {"include-missing", "include-escape",
                                                     "include-syntax", "include-cycle"};

constexpr std::array<std::string_view, 6> kEndingsOfNoCode = {".png",  ".dat",        ".bin",
                                                              ".lang", ".properties", ".raw"};

// Fewer may each have lost its own.
constexpr std::size_t kLeastWithoutVersion = 3;

// "i" and "uv" of two functions are two names.
constexpr std::size_t kLongestLocal = 3;

// A macro's call without its ")" takes the rest of the text for arguments, braces and all.
constexpr std::array<std::string_view, 4> kOfSwallowed = {"brace-unbalanced", "glsl-", "varying-",
                                                          "output-"};

/// A mistake in a file, and how the ids begin of what the programs that read it are found to do by it.
struct Lack {
  std::string_view cause;
  std::span<const std::string_view> ids;
};
constexpr std::array<Lack, 2> kLacks = {
    {{"include-missing", kOfLackingNames}, {"render-target-syntax", kOfTargets}}};
constexpr std::array<Lack, 1> kSwallows = {{{"macro-unterminated", kOfSwallowed}}};

void foldLack(Folds& folds, std::size_t cause, const Lack& lack) {
  for (std::size_t i = 0; i < folds.all().size(); ++i) {
    const Diagnostic& d = folds.all()[i];
    const bool listed = std::ranges::any_of(
        lack.ids, [&](std::string_view id) { return d.id.starts_with(id); });
    if (listed && d.severity != Severity::Note && folds.isOpen(i) &&
        folds.isOfProgramsWith(folds.all()[cause].at.file, i))
      folds.fold(i, cause);
  }
}

void foldLacks(Folds& folds, std::span<const Lack> lacks) {
  for (std::size_t cause = 0; cause < folds.all().size(); ++cause) {
    for (const Lack& lack : lacks) {
      if (folds.all()[cause].id == lack.cause && folds.isOpen(cause)) foldLack(folds, cause, lack);
    }
  }
}

/// The names that lines of the pack's files define, of those that no program reads, too.
/// Of `const float sunPathRotation = ...`, which is an option as a #define is; "" for another line.
std::string_view constName(std::string_view line) {
  if (!trim(line).starts_with("const")) return "";
  std::string_view third;
  int count = 0;
  forEachWord(line, [&](std::string_view word) {
    if (++count == 3) third = word;
  });
  return third;
}

std::set<std::string, std::less<>> definedNames(const FileSource& files) {
  std::set<std::string, std::less<>> names;
  for (const std::string& path : files.files()) {
    const std::string_view ending = std::string_view(path).substr(std::min(path.rfind('.'), path.size()));
    if (std::ranges::find(kEndingsOfNoCode, ending) != kEndingsOfNoCode.end()) continue;
    for (const std::string& line : splitLines(files.read(path).value_or(""))) {
      for (const std::string_view name : {definedName(line), constName(line)})
        if (!name.empty() && names.size() < limits::kOptions) names.emplace(name);
    }
  }
  return names;
}

/// Options of files that a wrong #include keeps from being read are no options.
void foldUnreadOptions(Folds& folds, const FileSource& files) {
  const auto unread = [&](std::size_t i) {
    const Diagnostic& d = folds.all()[i];
    return d.severity == Severity::Error && folds.isOpen(i) &&
           std::ranges::find(kUnread, d.id) != kUnread.end();
  };
  std::size_t cause = 0;
  while (cause < folds.all().size() && !unread(cause)) ++cause;
  if (cause == folds.all().size()) return;
  const auto defined = definedNames(files);
  constexpr std::string_view kNoOption = "the pack has no option ";
  for (std::size_t i = 0; i < folds.all().size(); ++i) {
    const std::string_view message = folds.all()[i].message;
    if (message.starts_with(kNoOption) && folds.isOpen(i) &&
        defined.contains(leadingWord(message.substr(kNoOption.size()))))
      folds.fold(i, cause);
  }
}

/// A custom uniform that is dropped takes those along that use it.
void foldUniforms(Folds& folds) {
  const auto droppedBy = [&](std::size_t i, std::string_view before, std::string_view behind) {
    const std::string_view message = folds.all()[i].message;
    const std::size_t begin = message.find(before), end = message.find(behind, begin);
    if (folds.all()[i].id != "uniform-dropped" || begin == message.npos || end == message.npos)
      return std::string_view();
    return message.substr(begin + before.size(), end - begin - before.size());
  };
  std::map<std::string_view, std::size_t> dropped;
  for (std::size_t i = 0; i < folds.all().size(); ++i) {
    const std::string_view name = droppedBy(i, "custom uniform ", " is dropped");
    if (!name.empty() && folds.isOpen(i)) dropped.emplace(name, i);
  }
  for (const auto& [name, i] : dropped) {
    std::size_t cause = i;
    for (std::size_t step = 0; step < dropped.size(); ++step) {
      const auto next = dropped.find(droppedBy(cause, "it uses ", ", which is dropped"));
      if (next == dropped.end()) break;
      cause = next->second;
    }
    if (cause != i) folds.fold(i, cause);
  }
}

bool names(std::string_view line, std::string_view name) {
  bool found = false;
  forEachWord(line, [&](std::string_view word) { found = found || word == name; });
  return found;
}

/// Lines that use a uniform as what it is do not compile where it is declared as something else.
void foldWrongTypes(Folds& folds) {
  for (std::size_t cause = 0; cause < folds.all().size(); ++cause) {
    const Diagnostic& wrong = folds.all()[cause];
    const std::size_t end = wrong.message.find('\'', 1);
    if (wrong.id != "uniform-type" || end == wrong.message.npos || !folds.isOpen(cause)) continue;
    const std::string name = wrong.message.substr(1, end - 1);
    for (std::size_t i = 0; i < folds.all().size(); ++i) {
      const Diagnostic& d = folds.all()[i];
      if (d.id == "glsl-compile" && names(d.sourceLine, name) && folds.isOpen(i) &&
          folds.isOfProgramsWith(wrong.at.file, i))
        folds.fold(i, cause);
    }
  }
}

/// Programs that read one file and have no #version have lost it in that file, as a rule.
void foldVersions(Folds& folds) {
  std::optional<std::size_t> first;
  std::vector<std::size_t> others;
  for (std::size_t i = 0; i < folds.all().size(); ++i) {
    if (folds.all()[i].id != "version-missing" || !folds.isOpen(i)) continue;
    if (!first) {
      first = i;
      continue;
    }
    const std::set<std::string>& files = folds.filesOf(folds.all()[*first].at.file);
    if (std::ranges::any_of(folds.filesOf(folds.all()[i].at.file),
                            [&](const std::string& file) { return files.contains(file); }))
      others.push_back(i);
  }
  if (others.size() < kLeastWithoutVersion) return;
  for (const std::size_t i : others) folds.fold(i, *first);
  const std::string shared = folds.firstIncludeOf(folds.all()[*first].at.file);
  const bool all = std::ranges::all_of(others, [&](std::size_t i) {
    return folds.firstIncludeOf(folds.all()[i].at.file) == shared;
  });
  if (all && !shared.empty())
    folds.relate(*first, {{shared, 1, 1}, "the first file that all of these programs include"});
}

/// Errors about one unknown name are one mistake, the first of them.
void foldNames(Folds& folds) {
  std::map<std::string, std::size_t> first;
  for (std::size_t i = 0; i < folds.all().size(); ++i) {
    const Diagnostic& d = folds.all()[i];
    const std::string name = unknownName(d.message);
    if (name.size() < kLongestLocal || d.severity != Severity::Error || !folds.isOpen(i)) continue;
    const auto [known, isNew] = first.try_emplace(name, i);
    if (!isNew) folds.fold(i, known->second);
  }
}

/// One advice for several lines of a file is given once: `varying` in a stage that has none, or the type of one attribute.
void foldAdvice(Folds& folds) {
  std::map<std::pair<std::string, std::string>, std::size_t> first;
  for (std::size_t i = 0; i < folds.all().size(); ++i) {
    const Diagnostic& d = folds.all()[i];
    if (d.id != "glsl-compile" || d.hint.empty() || !folds.isOpen(i)) continue;
    const auto [known, isNew] = first.try_emplace({d.at.file, d.hint}, i);
    if (!isNew) folds.fold(i, known->second);
  }
}

}  // namespace

bool Folds::isOpen(std::size_t i) const {
  return !problems_.cause(i) && !verdict_.ofMatrix.contains(i) &&
         std::ranges::find(kOfDrawing, problems_.all()[i].id) == kOfDrawing.end();
}

void Folds::fold(std::size_t i, std::size_t cause) {
  problems_.setCause(i, cause);
  if (problems_.all()[i].severity == Severity::Error) problems_.setSeverity(cause, Severity::Error);
}

const std::set<std::string>& Folds::filesOf(const std::string& entry) {
  const auto [known, isNew] = files_.try_emplace(entry);
  if (isNew && verdict_.files->contains(entry)) {
    Diagnostics ignored;  // reported when the pack was read
    for (const auto& file : readIncludeGraph(*verdict_.files, {entry}, ignored).files)
      known->second.insert(file.first);
  }
  return known->second;
}

std::string Folds::firstIncludeOf(const std::string& entry) const {
  if (!verdict_.files->contains(entry)) return "";
  Diagnostics ignored;  // reported when the pack was read
  const auto graph = readIncludeGraph(*verdict_.files, {entry}, ignored);
  const auto includes = graph.includes.find(entry);
  return includes == graph.includes.end() || includes->second.empty()
             ? ""
             : includes->second.begin()->second;
}

bool Folds::isOfProgramsWith(const std::string& file, std::size_t i) {
  const std::set<std::string>& entries = problems_.entryFiles(i);
  return !entries.empty() && std::ranges::all_of(entries, [&](const std::string& entry) {
    if (entry.ends_with(kComputeEnding)) return filesOf(entry).contains(file);
    const std::string program = entry.substr(0, entry.rfind('.'));
    return std::ranges::any_of(kProgramEndings, [&](std::string_view ending) {
      return filesOf(program + std::string(ending)).contains(file);
    });
  });
}

void foldTwins(Folds& folds) {
  std::map<std::tuple<std::string, int, std::string>, std::size_t> first;
  for (const Severity severity : {Severity::Error, Severity::Warning}) {
    for (std::size_t i = 0; i < folds.all().size(); ++i) {
      const Diagnostic& d = folds.all()[i];
      if (d.severity != severity || !folds.isOpen(i)) continue;
      const bool comment = d.id.starts_with("comment-");
      const auto [known, isNew] =
          first.try_emplace({d.at.file, d.at.line, comment ? "" : d.message}, i);
      const bool milder = folds.all()[known->second].severity != severity;
      if (!isNew && (comment || milder)) folds.fold(i, known->second);
    }
  }
  foldLacks(folds, kSwallows);
}

void foldByNames(Folds& folds, const FileSource& files) {
  foldLacks(folds, kLacks);
  foldUnreadOptions(folds, files);
  foldUniforms(folds);
  foldWrongTypes(folds);
  foldVersions(folds);
  foldNames(folds);
  foldAdvice(folds);
}

}  // namespace orris
