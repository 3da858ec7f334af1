#include <orris/check/hints/include_hints.h>

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include <orris/check/compile/stage_files.h>
#include <orris/check/interface/glsl_types.h>
#include <orris/check/interface/known_names.h>
#include <orris/check/pack/pack_texts.h>
#include <orris/glsl/tokens/outline.h>
#include <orris/pack/files/text.h>

namespace orris {
namespace {

constexpr const char* kMain = "main";

bool contains(const std::vector<std::string>& files, const std::string& file) {
  return std::find(files.begin(), files.end(), file) != files.end();
}

/// No word of the language.
bool isOwnName(std::string_view word) {
  constexpr std::string_view kWords[] = {"void", "struct", "return", "if",    "else",
                                         "for",  "while",  "true",   "false", "main"};
  return word.size() > 2 && !isQualifier(word) && !isNumeric(word) &&
         opaqueType(word).component == 0 &&
         std::find(std::begin(kWords), std::end(kWords), word) == std::end(kWords);
}

bool isOfContract(const std::string& name) {
  return findKnownName(NameKind::Uniform, name) || findKnownName(NameKind::Sampler, name);
}

}  // namespace

IncludeHints::IncludeHints(DefinitionIndex& index, const StageText& stage, Diagnostics& found)
    : index_(index), stage_(stage), found_(found), files_(filesOf(index, stage)) {}

bool IncludeHints::covers(const Diagnostic& diagnostic) const {
  if (diagnostic.includedFrom.empty()) return contains(files_, diagnostic.at.file);
  return !files_.empty() && files_.front() == diagnostic.includedFrom.back().file;
}

void IncludeHints::locate(const IncludeTrial& trial) {
  const std::vector<std::string> before = filesOf(index_, stage_, firstUse_);
  for (const MissingInclude& missing : findMissingIncludes(index_, before, unknown_, trial))
    addMissing(missing);
}

std::optional<SourceLocation> IncludeHints::definedElsewhere(
    const std::string& name, const std::vector<std::string>& files) {
  const auto& all = index_.definitionsOf(name);
  const bool here = std::ranges::any_of(
      all, [&](const SourceLocation& definition) { return contains(files, definition.file); });
  if (here || all.empty()) return std::nullopt;
  // Entry files are not included by others.
  const auto shared = std::find_if(all.begin(), all.end(), [&](const SourceLocation& definition) {
    return !definition.file.ends_with("sh");
  });
  return shared == all.end() ? all.front() : *shared;
}

// Programs declare contract names for themselves; only a file made for many is worth including.
bool IncludeHints::isShared(const std::string& file) {
  constexpr std::size_t kMany = 3, kMostFiles = 64;
  std::set<std::string> users = {file};
  std::vector<std::string> open = {file};
  while (!open.empty() && users.size() < kMostFiles) {
    const auto& includers = index_.includersOf(open.back());
    open.pop_back();
    for (const SourceLocation& includer : includers) {
      if (users.insert(includer.file).second) open.push_back(includer.file);
    }
  }
  return users.size() > kMany;
}

bool IncludeHints::isInShared(const std::string& name) {
  return std::ranges::any_of(
      index_.definitionsOf(name),
      [this](const SourceLocation& definition) { return isShared(definition.file); });
}

bool IncludeHints::isOfProgram(const std::string& target) {
  const auto programOf = [](std::string_view file) {
    const std::string_view name = file.substr(file.rfind('/') + 1);
    return name.substr(0, name.find_first_of(".0123456789"));
  };
  std::set<std::string_view> programs;
  for (const SourceLocation& includer : index_.includersOf(target))
    programs.insert(programOf(includer.file));
  return programs.size() > 1 || files_.empty() ||
         target.find(programOf(files_.front())) != target.npos;
}

bool IncludeHints::explainName(std::size_t index, const std::string& name) {
  const std::size_t use = lineOf(stage_, found_[index].at);
  const auto definition = definedElsewhere(name, use > 0 ? filesOf(index_, stage_, use) : files_);
  if (!definition) return false;
  const bool uniform = sourceLineOf(index_, *definition).find("uniform") != std::string::npos;
  if (uniform && isOfContract(name) && !isInShared(name)) return false;
  const std::string where = fmt::format("defined at {}:{}, which is not included here",
                                        definition->file, definition->line);
  Diagnostic& error = found_[index];
  error.hint += (error.hint.empty() ? "" : "; ") + where;
  unknown_.push_back({name, error.at, error.includedFrom});
  if (use > 0) firstUse_ = firstUse_ > 0 ? std::min(firstUse_, use) : use;
  return true;
}

void IncludeHints::addMissing(const MissingInclude& missing) {
  const UnknownName& name = unknown_[missing.first];
  // Any file with a main() would do; one of another program is not meant.
  if (name.name == kMain && !isOfProgram(missing.target)) return;
  const std::string problem =
      name.name == kMain
          ? "the stage has no main()"
          : fmt::format("'{}' is unknown at {}:{}", name.name, name.at.file, name.at.line);
  Diagnostic companion{.severity = Severity::Error,
                       .id = "include-probably-missing",
                       .at = missing.at,
                       .message = problem + ": an #include seems to be missing here",
                       .sourceLine = sourceLineOf(index_, missing.at),
                       .hint = fmt::format("#include \"{}\"", missing.target),
                       .repair = LineEdit{missing.at.file, missing.at.line,
                                          fmt::format("#include \"{}\"", missing.target)}};
  if (missing.model.line > 0) {
    companion.notes.push_back(
        fmt::format("as {}:{} does", missing.model.file, missing.model.line));
  }
  addNewPlace(std::move(companion), found_);
}

// A type or macro that is not there reads as a syntax error: some word of the line is the cause, and
// none that the text has before, as a compiler ends at the first syntax error.
void IncludeHints::explainSyntax(std::size_t index) {
  if (!found_[index].hint.empty()) return;
  const std::string line = found_[index].sourceLine;
  std::set<std::string, std::less<>> before;
  forEachWord(textBefore(lineOf(stage_, found_[index].at)),
              [&](std::string_view word) { before.emplace(word); });
  bool done = false;
  forEachWord(line, [&](std::string_view word) {
    if (!done && isOwnName(word) && !before.contains(word))
      done = explainName(index, std::string(word));
  });
}

std::string_view IncludeHints::textBefore(std::size_t line) const {
  std::size_t end = 0;
  for (std::size_t i = 1; i < line && end != std::string::npos; ++i)
    end = stage_.text.text.find('\n', end + 1);
  return std::string_view(stage_.text.text).substr(0, end);
}

// A stage without main lacks the #include that was all of it.
void IncludeHints::explainEntry(std::size_t index) {
  if (files_.empty()) return;
  const auto lines = index_.files().find(files_.front());
  if (lines == index_.files().end() || found_[index].at.line > 0) return;
  const auto& includes = index_.includesOf(files_.front());
  const int last = static_cast<int>(lines->second.size());
  found_[index].at.line = std::max(1, includes.empty() ? last : includes.back().line + 1);
  found_[index].hint = "write void main() here, or #include the file that does";
  if (definedElsewhere(kMain, files_))
    unknown_.push_back({kMain, {files_.front(), last + 1, 0}, {}});
}

std::string sourceLineOf(DefinitionIndex& index, const SourceLocation& at) {
  const auto file = index.files().find(at.file);
  const bool exists = file != index.files().end() && at.line > 0 &&
                      static_cast<std::size_t>(at.line) <= file->second.size();
  return exists ? file->second[static_cast<std::size_t>(at.line) - 1] : "";
}

void addNewPlace(Diagnostic diagnostic, Diagnostics& found) {
  const bool known = std::any_of(found.begin(), found.end(), [&](const Diagnostic& d) {
    return d.id == diagnostic.id && d.at == diagnostic.at;
  });
  if (!known) found.push_back(std::move(diagnostic));
}

}  // namespace orris
