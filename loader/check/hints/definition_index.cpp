#include <orris/check/hints/definition_index.h>

#include <algorithm>
#include <array>
#include <set>

#include <orris/core/limits.h>
#include <orris/core/files/pack_path.h>
#include <orris/core/files/text_file.h>
#include <orris/glsl/tokens/outline.h>
#include <orris/pack/files/text.h>

namespace orris {
namespace {

constexpr std::size_t kMostDefinitions = 256;

bool endsAsShaderText(std::string_view path) {
  constexpr std::array<std::string_view, 13> kEnds = {".vsh",  ".fsh",  ".gsh",     ".csh", ".tcs",
                                                      ".tes",  ".glsl", ".inc",     ".h",   ".frag",
                                                      ".vert", ".comp", ".settings"};
  return std::any_of(kEnds.begin(), kEnds.end(), [&](auto end) { return path.ends_with(end); });
}

/// The text after a directive "#  word", nullopt for other lines.
std::optional<std::string_view> afterDirective(std::string_view line, std::string_view word) {
  line = trim(line);
  if (!line.starts_with('#')) return std::nullopt;
  line = trim(line.substr(1));
  if (leadingWord(line) != word) return std::nullopt;
  return line.substr(word.size());
}

bool isStatementWord(std::string_view word) {
  constexpr std::array<std::string_view, 8> kWords = {"return", "else",  "case",   "if",
                                                      "for",    "while", "switch", "define"};
  return std::find(kWords.begin(), kWords.end(), word) != kWords.end();
}

/// The last word of `text`, "" when something else stands there.
std::string_view lastWord(std::string_view text) {
  std::size_t begin = text.size();
  while (begin > 0 && isWordCharacter(text[begin - 1])) --begin;
  return text.substr(begin);
}

/// `type` without the array sizes at its end: "vec4[2]" is "vec4". A ']' without its '[' stays.
std::string_view withoutArraySizes(std::string_view type) {
  while (type.ends_with(']')) {
    const std::size_t open = type.rfind('[');
    if (open == std::string_view::npos) break;
    type = trim(type.substr(0, open));
  }
  return type;
}

/// Is `name`, which stands at `at` in `line`, declared or defined there? `inBlock`: within braces.
bool definesAt(std::string_view line, std::size_t at, std::string_view name, bool inBlock) {
  if (const auto rest = afterDirective(line, "define")) return leadingWord(trim(*rest)) == name;
  if (trim(line).starts_with('#')) return false;
  const std::string_view before = trim(line.substr(0, at));
  const std::string_view after = trim(line.substr(at + name.size()));
  const std::string_view word = lastWord(withoutArraySizes(before));
  if (word == "struct") return true;
  if (word.empty() || isStatementWord(word) || (word[0] >= '0' && word[0] <= '9')) return false;
  if (after.starts_with('(')) return before.find_first_of("=(,") == std::string_view::npos;
  const bool declares = after.empty() || after.find_first_of("=;[,") == 0;
  return declares && !after.starts_with("==") && (!inBlock || isQualifier(leadingWord(before)));
}

void findIn(const std::string& file, const FileLines& lines, const std::string& name,
            std::vector<SourceLocation>& found) {
  int depth = 0;
  for (std::size_t i = 0; i < lines.size() && found.size() < kMostDefinitions; ++i) {
    const std::string& line = lines[i];
    const bool inBlock = depth > 0;
    for (const char c : line) depth += c == '{' ? 1 : c == '}' ? -1 : 0;
    if (line.starts_with('}')) depth = 0;
    for (std::size_t at = line.find(name); at != std::string::npos; at = line.find(name, at + 1)) {
      const std::size_t end = at + name.size();
      const bool whole = (at == 0 || !isWordCharacter(line[at - 1])) &&
                         (end >= line.size() || !isWordCharacter(line[end]));
      if (!whole || !definesAt(line, at, name, inBlock)) continue;
      found.push_back({file, static_cast<int>(i) + 1, static_cast<int>(at) + 1});
      break;
    }
  }
}

std::vector<IncludeLine> includeLines(const std::string& file, const FileLines& lines) {
  std::vector<IncludeLine> includes;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto rest = afterDirective(lines[i], "include");
    if (!rest) continue;
    std::string_view path = trim(*rest);
    if (path.size() < 2 || path.front() != '"' || path.back() != '"') continue;
    const auto target = resolvePackPath(file, path.substr(1, path.size() - 2));
    if (target) includes.push_back({static_cast<int>(i) + 1, *target});
  }
  return includes;
}

}  // namespace

void DefinitionIndex::load() {
  std::call_once(once_, [this] { readAll(); });
}

void DefinitionIndex::readAll() {
  files_ = pack_.files;
  std::size_t bytes = 0;
  for (const std::string& path :
       pack_.source ? pack_.source->files() : std::vector<std::string>()) {
    if (files_.contains(path) || !endsAsShaderText(path)) continue;
    const auto text = readText(*pack_.source, path);
    bytes += text ? text->size() : 0;
    if (bytes > limits::kPackTextBytes) break;
    if (text) files_[path] = splitLines(*text);
  }
  for (const auto& [file, lines] : files_) {
    includes_[file] = includeLines(file, lines);
    for (const IncludeLine& include : includes_[file])
      includers_[include.target].push_back({file, include.line, 0});
  }
}

const std::map<std::string, FileLines>& DefinitionIndex::files() {
  load();
  return files_;
}

const std::vector<IncludeLine>& DefinitionIndex::includesOf(const std::string& file) {
  static const std::vector<IncludeLine> kNone;
  load();
  const auto found = includes_.find(file);
  return found == includes_.end() ? kNone : found->second;
}

const std::vector<SourceLocation>& DefinitionIndex::includersOf(const std::string& file) {
  static const std::vector<SourceLocation> kNone;
  load();
  const auto found = includers_.find(file);
  return found == includers_.end() ? kNone : found->second;
}

const std::vector<SourceLocation>& DefinitionIndex::definitionsOf(const std::string& name) {
  load();
  const std::lock_guard lock(mutex_);
  const auto [entry, isNew] = found_.try_emplace(name);
  if (isNew && !name.empty()) {
    for (const auto& [file, lines] : files_) findIn(file, lines, name, entry->second);
  }
  return entry->second;
}

bool DefinitionIndex::reaches(const std::string& file, const std::string& target) {
  std::set<std::string> seen{file};
  std::vector<std::string> open{file};
  while (!open.empty()) {
    const std::string here = open.back();
    open.pop_back();
    if (here == target) return true;
    for (const IncludeLine& include : includesOf(here)) {
      if (seen.insert(include.target).second) open.push_back(include.target);
    }
  }
  return false;
}

}  // namespace orris
