#include <orris/check/hints/language_hints.h>

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include <orris/check/compile/stage_files.h>
#include <orris/check/pack/pack_texts.h>
#include <orris/pack/files/text.h>

namespace orris {
namespace {

bool speaksOf(const Diagnostic& d, std::string_view text) {
  return d.message.find(text) != std::string::npos;
}

/// An operator of scalars, and what vectors (or floats) have for it.
struct Operator {
  std::string_view quoted;   ///< as the compiler's message begins
  std::string_view operand;  ///< part of the name of the operands' type
  std::string_view hint;
};

constexpr Operator kOperators[] = {
    {"'||'", "bvec",
     "|| joins two single bools: write any(a) || any(b), or all() where each component counts"},
    {"'&&'", "bvec",
     "&& joins two single bools: write all(a) && all(b), or any() where one component suffices"},
    {"'!'", "vector of bool", "! turns a single bool round: write not(v)"},
    {"'<'", "vec",
     "< compares scalars: write lessThan(a, b) for vectors, in all() or any() for a single bool"},
    {"'>'", "vec",
     "> compares scalars: write greaterThan(a, b) for vectors, in all() or any() for a single "
     "bool"},
    {"'<='", "vec",
     "<= compares scalars: write lessThanEqual(a, b) for vectors, in all() or any() for a single "
     "bool"},
    {"'>='", "vec",
     ">= compares scalars: write greaterThanEqual(a, b) for vectors, in all() or any() for a "
     "single bool"},
    {"'%'", "float", "% divides integers: write mod(a, b) for floats"},
    {"'%'", " of type 'vec", "% divides integers: write mod(a, b) for floats"},
};

std::string_view operatorHint(const Diagnostic& d) {
  if (!speaksOf(d, "wrong operand type")) return {};
  const auto* const found = std::ranges::find_if(kOperators, [&d](const Operator& o) {
    return d.message.starts_with(o.quoted) && speaksOf(d, o.operand);
  });
  return found == std::end(kOperators) ? std::string_view() : found->hint;
}

/// The word that ends where a diagnostic points, but for blanks.
std::string_view wordBefore(const Diagnostic& d) {
  const std::size_t column = std::size_t(std::max(d.at.column - 1, 0));
  const std::string_view before =
      trim(std::string_view(d.sourceLine).substr(0, std::min(column, d.sourceLine.size())));
  std::size_t begin = before.size();
  while (begin > 0 && isWordCharacter(before[begin - 1])) --begin;
  return before.substr(begin);
}

/// Does the line define `name` as a macro that stands for nothing?
bool definesAsNothing(std::string_view line, std::string_view name) {
  line = trim(line);
  for (const std::string_view part : {std::string_view("#"), std::string_view("define"), name}) {
    if (!line.starts_with(part)) return false;
    line = trim(line.substr(part.size()));
  }
  return line.empty() || line.starts_with("//") || line.starts_with("/*");
}

/// Where a file that the stage reads defines `name` so.
std::optional<SourceLocation> emptyMacro(DefinitionIndex& index, const StageText& stage,
                                         std::string_view name) {
  for (const std::string& file : filesOf(index, stage)) {
    const auto lines = index.files().find(file);
    if (lines == index.files().end()) continue;
    for (std::size_t i = 0; i < lines->second.size(); ++i)
      if (definesAsNothing(lines->second[i], name)) return SourceLocation{file, int(i) + 1, 1};
  }
  return std::nullopt;
}

void explainMacro(DefinitionIndex& index, const std::vector<const StageText*>& stages,
                  Diagnostic& d) {
  const std::string name(wordBefore(d));
  if (name.empty()) return;
  for (const StageText* stage : stages) {
    // A macro's name is not in the text any more.
    if (occursAsWord(stage->text.text, name)) continue;
    const auto at = emptyMacro(index, *stage, name);
    if (!at) continue;
    d.hint = fmt::format(
        "'{}' is a macro that stands for nothing here: choose another name for one of them", name);
    d.related.push_back({*at, fmt::format("'{}' is defined here", name)});
    return;
  }
}

}  // namespace

void explainLanguage(DefinitionIndex& index, const std::vector<const StageText*>& stages,
                     Diagnostics& found) {
  for (Diagnostic& d : found) {
    if (d.severity != Severity::Error || !d.hint.empty()) continue;
    d.hint = operatorHint(d);
    if (!speaksOf(d, "syntax error")) continue;
    if (speaksOf(d, "expected ')' before '='"))
      d.hint =
          "GLSL has no default values of parameters: write the value in each call, or a second "
          "function with fewer parameters";
    else
      explainMacro(index, stages, d);
  }
}

}  // namespace orris
