#include <orris/plan/schedule/program_uses.h>

#include <charconv>
#include <unordered_map>

#include <orris/pack/properties/shader_properties.h>

namespace orris {
namespace {

bool isIdentifierChar(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

void addUses(std::string_view text, ProgramUses& uses) {
  std::unordered_map<std::string_view, int> counts;
  for (size_t i = 0; i < text.size();) {
    if (!isIdentifierChar(text[i])) {
      ++i;
      continue;
    }
    size_t end = i;
    while (end < text.size() && isIdentifierChar(text[end])) ++end;
    const std::string_view word = text.substr(i, end - i);
    if (++counts[word] == 2) uses.emplace(word);
    i = end;
  }
}

std::optional<int> numberAfter(std::string_view name, std::string_view prefix) {
  if (!name.starts_with(prefix) || name.size() == prefix.size()) return std::nullopt;
  const std::string_view digits = name.substr(prefix.size());
  int value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size() || value < 0)
    return std::nullopt;
  return value;
}

}  // namespace

ProgramUses usesOf(const ProgramSource& program) {
  ProgramUses uses;
  for (const StageText& stage : program.stages) addUses(stage.text.text, uses);
  for (const ComputeSource& compute : program.computes) addUses(compute.text.text.text, uses);
  return uses;
}

std::optional<BufferName> parseBufferName(std::string_view name, bool watershadow) {
  using Kind = BufferName::Kind;
  static const std::unordered_map<std::string_view, BufferName> kAliases = {
      {"gdepthtex", {Kind::Depth, 0, false}},
      {"watershadow", {Kind::ShadowDepth, 0, false}},
      {"shadowcolor", {Kind::ShadowColor, 0, false}},
      {"shadowtex0HW", {Kind::ShadowDepth, 0, false}},
      {"shadowtex1HW", {Kind::ShadowDepth, 1, false}}};
  if (name == "shadow") return BufferName{Kind::ShadowDepth, watershadow ? 1 : 0, false};
  if (const auto it = kAliases.find(name); it != kAliases.end()) return it->second;
  const std::string canonical = canonicalBuffer(name);
  struct Prefix {
    std::string_view text;
    Kind kind;
    bool image;
    int count;
  };
  static constexpr Prefix kPrefixes[] = {
      {"colortex", Kind::Color, false, kColorTargets},
      {"colorimg", Kind::Color, true, kColorTargets},
      {"shadowcolor", Kind::ShadowColor, false, kShadowColorTargets},
      {"shadowcolorimg", Kind::ShadowColor, true, kShadowColorTargets},
      {"depthtex", Kind::Depth, false, 3},
      {"shadowtex", Kind::ShadowDepth, false, 2},
      {"stenciltex", Kind::Stencil, false, 2}};
  for (const Prefix& prefix : kPrefixes)
    if (const auto index = numberAfter(canonical, prefix.text); index && *index < prefix.count)
      return BufferName{prefix.kind, *index, prefix.image};
  return std::nullopt;
}

}  // namespace orris
