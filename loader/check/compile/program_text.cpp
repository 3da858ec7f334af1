#include <orris/check/compile/program_text.h>

#include <algorithm>

#include <orris/check/interface/stage_interface.h>
#include <orris/pack/files/text.h>

namespace orris {
namespace {

constexpr size_t kMostArguments = 16, kLongestCall = 4000;

void addWords(const StageText& stage, std::string_view word, std::vector<WordPlace>& places) {
  const std::string& text = stage.text.text;
  for (size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    const size_t end = at + word.size();
    const bool whole = (at == 0 || !isWordCharacter(text[at - 1])) &&
                       (end == text.size() || !isWordCharacter(text[end]));
    if (whole) places.push_back({&stage, at});
  }
}

/// "imageLoad" when the word is the first argument of a call of that name.
std::string_view calledFunction(const WordPlace& place) {
  const std::string_view before =
      trim(std::string_view(place.stage->text.text).substr(0, place.offset));
  if (!before.ends_with('(')) return {};
  const std::string_view name = trim(before.substr(0, before.size() - 1));
  size_t begin = name.size();
  while (begin > 0 && isWordCharacter(name[begin - 1])) --begin;
  return name.substr(begin);
}

std::pair<int, int> lineAndColumn(const WordPlace& place) {
  const std::string_view before = std::string_view(place.stage->text.text).substr(0, place.offset);
  const auto line = std::count(before.begin(), before.end(), '\n') + 1;
  const size_t lineStart = before.rfind('\n') + 1;  // npos + 1 is 0
  return {static_cast<int>(line), static_cast<int>(before.size() - lineStart + 1)};
}

}  // namespace

std::vector<WordPlace> findWord(const StageText& stage, std::string_view word) {
  std::vector<WordPlace> places;
  addWords(stage, word, places);
  return places;
}

std::vector<WordPlace> findWord(const ProgramSource& program, bool computes,
                                std::string_view word) {
  std::vector<WordPlace> places;
  if (computes) {
    for (const ComputeSource& compute : program.computes) addWords(compute.text, word, places);
  } else {
    for (const StageText& stage : program.stages) addWords(stage, word, places);
  }
  return places;
}

bool isDeclaration(const WordPlace& place) {
  const std::string_view text = place.stage->text.text;
  const size_t before = text.substr(0, place.offset).find_last_of(";{}");
  const std::string_view statement =
      text.substr(before == std::string_view::npos ? 0 : before + 1,
                  place.offset - (before == std::string_view::npos ? 0 : before + 1));
  for (size_t at = statement.find("uniform"); at != std::string_view::npos;
       at = statement.find("uniform", at + 1)) {
    if ((at == 0 || !isWordCharacter(statement[at - 1])) &&
        !isWordCharacter(statement[std::min(at + 7, statement.size() - 1)]))
      return true;
  }
  return false;
}

ImageAccess imageAccess(const ProgramSource& program, bool computes, std::string_view image) {
  ImageAccess access;
  for (const WordPlace& place : findWord(program, computes, image)) {
    if (isDeclaration(place)) continue;
    const std::string_view call = calledFunction(place);
    const bool atomic = call.starts_with("imageAtomic");
    const bool size = call == "imageSize" || call == "imageSamples";
    const bool known = atomic || size || call == "imageLoad" || call == "imageStore";
    access.loads |= atomic || call == "imageLoad" || !known;
    access.stores |= atomic || call == "imageStore" || !known;
  }
  return access;
}

std::optional<Call> callAt(std::string_view text, size_t nameEnd) {
  size_t at = text.find_first_not_of(" \t\n", nameEnd);
  if (at == std::string_view::npos || text[at] != '(') return std::nullopt;
  Call call;
  int depth = 0;
  size_t begin = at + 1;
  const size_t limit = std::min(text.size(), at + kLongestCall);
  for (; at < limit; ++at) {
    const char c = text[at];
    if (c == '(' || c == '[') ++depth;
    if (c == ')' || c == ']') --depth;
    const bool closed = depth == 0;
    if (!closed && !(c == ',' && depth == 1)) continue;
    if (call.arguments.size() == kMostArguments) return std::nullopt;
    call.arguments.push_back(trim(text.substr(begin, at - begin)));
    begin = at + 1;
    if (!closed) continue;
    call.end = at + 1;
    return call;
  }
  return std::nullopt;
}

Diagnostic diagnosticAt(const ShaderPack& pack, Severity severity, std::string id,
                        const SourceLocation& at, std::string message, std::string hint) {
  return {.severity = severity,
          .id = std::move(id),
          .at = at,
          .message = std::move(message),
          .sourceLine = pack.sourceLine(at.file, at.line),
          .hint = std::move(hint)};
}

std::vector<WordPlace> findUses(const ProgramSource& program, bool computes,
                                std::string_view name) {
  std::vector<WordPlace> places;
  const StageText* known = nullptr;
  bool reached = false;
  for (const WordPlace& place : findWord(program, computes, name)) {
    if (place.stage != known) {
      const StageInterface stage = readStageInterface(*place.stage);
      const StageGlobal* global = findGlobal(stage, StageGlobal::Storage::Uniform, name);
      known = place.stage;
      reached = global == nullptr || global->used;
    }
    if (reached && !isDeclaration(place)) places.push_back(place);
  }
  return places;
}

SourceLocation locationOf(const WordPlace& place) {
  const auto [line, column] = lineAndColumn(place);
  return place.stage->text.locate(line, column);
}

Diagnostic diagnosticAt(const ShaderPack& pack, Severity severity, std::string id,
                        const WordPlace& place, std::string message, std::string hint) {
  const auto [line, column] = lineAndColumn(place);
  Diagnostic d = diagnosticAt(pack, severity, std::move(id), locationOf(place), std::move(message),
                              std::move(hint));
  d.includedFrom = place.stage->text.includedFrom(line, column);
  return d;
}

}  // namespace orris
