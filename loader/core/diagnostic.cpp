#include <orris/core/diagnostic.h>

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <tuple>

#include <orris/core/printable.h>

namespace orris {
namespace {

struct EffectRow {
  Effect effect;
  const char* name;
  const char* sentence;
};
constexpr EffectRow kEffects[] = {
    {Effect::RefusesPack, "refuses-pack", "Iris refuses the whole pack"},
    {Effect::RefusesProgram, "refuses-program", "Iris refuses the program"},
    {Effect::IgnoresLine, "ignores-line", "Iris ignores this line"},
    {Effect::Unstated, "", ""},
};

const EffectRow& rowOf(Effect effect) {
  return *std::ranges::find(kEffects, effect, &EffectRow::effect);
}

// Blanks up to the column, tabs kept so that the caret stands under its character whatever the tab
// width; bytes that continue a UTF-8 character take no cell.
std::string caretLine(const std::string& line, int column) {
  std::string caret;
  const std::string before = printable(line.substr(0, static_cast<std::size_t>(column - 1)));
  for (const char c : before) {
    if ((static_cast<unsigned char>(c) & 0xC0) == 0x80) continue;
    caret += c == '\t' ? '\t' : ' ';
  }
  return caret + '^';
}

}  // namespace

const char* severityName(Severity severity) {
  switch (severity) {
    case Severity::Note:
      return "note";
    case Severity::Warning:
      return "warning";
    case Severity::Error:
      break;
  }
  return "error";
}

const char* effectName(Effect effect) { return rowOf(effect).name; }

Effect effectNamed(std::string_view name) {
  const auto* row = std::ranges::find(kEffects, name, &EffectRow::name);
  return row == std::end(kEffects) ? Effect::Unstated : row->effect;
}

Diagnostic withEffect(Diagnostic diagnostic, Effect effect) {
  diagnostic.effect = effect;
  diagnostic.message += std::string("; ") + rowOf(effect).sentence;
  return diagnostic;
}

bool refusesPack(const Diagnostics& diagnostics) {
  return std::ranges::find(diagnostics, Effect::RefusesPack, &Diagnostic::effect) !=
         diagnostics.end();
}

std::string formatLocation(const SourceLocation& at) {
  const std::string file = printable(at.file);
  if (at.line <= 0) return file;
  if (at.column <= 0) return fmt::format("{}:{}", file, at.line);
  return fmt::format("{}:{}:{}", file, at.line, at.column);
}

bool hasErrors(const Diagnostics& diagnostics) {
  return std::any_of(diagnostics.begin(), diagnostics.end(),
                     [](const Diagnostic& d) { return d.severity == Severity::Error; });
}

std::string formatDiagnostic(const Diagnostic& diagnostic) {
  std::string text = formatLocation(diagnostic.at);
  if (!text.empty()) text += ": ";
  text += fmt::format("{}: {}", severityName(diagnostic.severity), printable(diagnostic.message));
  for (const SourceLocation& site : diagnostic.includedFrom) {
    text += "\n  included from " + formatLocation(site);
  }
  if (!diagnostic.sourceLine.empty()) {
    text += "\n  " + printable(diagnostic.sourceLine);
    if (diagnostic.at.column > 0) {
      text += "\n  " + caretLine(diagnostic.sourceLine, diagnostic.at.column);
    }
  }
  for (const RelatedPlace& place : diagnostic.related) {
    text += fmt::format("\n  note: {}: {}", formatLocation(place.at), printable(place.message));
  }
  for (const std::string& note : diagnostic.notes) text += "\n  note: " + printable(note);
  if (!diagnostic.hint.empty()) text += "\n  hint: " + printable(diagnostic.hint);
  return text;
}

void removeDuplicates(Diagnostics& diagnostics) {
  using Key = std::tuple<Severity, std::string, int, int, std::string>;
  std::set<Key> seen;
  std::erase_if(diagnostics, [&seen](const Diagnostic& d) {
    return !seen.insert({d.severity, d.at.file, d.at.line, d.at.column, d.message}).second;
  });
}

}  // namespace orris
