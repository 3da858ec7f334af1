// Text for people: messages as editors click them, each with its id, then the counts.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "app/report_format.h"
#include "app/validate_print.h"
#include "core/limits.h"

namespace orris {
namespace {

std::string counted(int count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

// Lists of blocks in properties run over thousands of columns: what counts is around the caret.
constexpr int kWidest = 160, kBeforeCaret = 100;

bool startsCharacter(char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }

void clipSourceLine(Diagnostic& diagnostic) {
  std::string& line = diagnostic.sourceLine;
  if (std::ssize(line) <= kWidest) return;
  const int size = static_cast<int>(line.size());
  int begin = std::clamp(diagnostic.at.column - 1 - kBeforeCaret, 0, size - kWidest);
  int end = begin + kWidest;
  while (begin > 0 && !startsCharacter(line[begin])) --begin;
  while (end < size && !startsCharacter(line[end])) ++end;
  const bool more = end < size;
  line = (begin > 0 ? "..." : "") + line.substr(begin, end - begin) + (more ? "..." : "");
  if (begin > 0) diagnostic.at.column -= begin - 3;
}

}  // namespace

std::string fullText(Diagnostic diagnostic) {
  diagnostic.message += fmt::format(" [{}]", diagnostic.id);
  const std::string whole = formatDiagnostic(diagnostic);
  clipSourceLine(diagnostic);
  const std::string clipped = formatDiagnostic(diagnostic);
  // The place stays the true one; only the excerpt and its caret are those of the clipped line.
  return whole.substr(0, whole.find('\n')) +
         clipped.substr(std::min(clipped.find('\n'), clipped.size()));
}

std::string messagesOf(const PackResult& pack, const OutputOptions& output, bool strict) {
  std::string text;
  std::map<std::string, std::size_t> printed;
  for (const Finding& finding : pack.findings) {
    const bool shown =
        finding.silence == Silence::None &&
        (isShown(finding.diagnostic.severity, output) || countsAsFailure(finding, strict));
    if (!shown) continue;
    const std::size_t count = ++printed[finding.diagnostic.id];
    if (count <= limits::kPrintedOfAKind || output.verbose)
      text += fullText(finding.diagnostic) + '\n';
  }
  for (const auto& [id, count] : printed) {
    if (count <= limits::kPrintedOfAKind || output.verbose) continue;
    text += fmt::format("{} more messages of the kind {}; --verbose prints all\n",
                        count - limits::kPrintedOfAKind, id);
  }
  return text;
}

std::string summaryOf(const PackResult& pack) {
  std::map<Severity, int> open;
  std::map<Silence, int> silenced;
  for (const Finding& finding : pack.findings) {
    if (finding.diagnostic.severity == Severity::Note) continue;
    if (finding.silence == Silence::None) ++open[finding.diagnostic.severity];
    ++silenced[finding.silence];
  }
  std::vector<std::string> parts;
  if (open[Severity::Error] > 0) parts.push_back(counted(open[Severity::Error], "error"));
  if (open[Severity::Warning] > 0) parts.push_back(counted(open[Severity::Warning], "warning"));
  const int ignored = silenced[Silence::Comment] + silenced[Silence::Flag];
  if (ignored > 0) parts.push_back(fmt::format("{} ignored", ignored));
  if (silenced[Silence::Baseline] > 0) {
    parts.push_back(fmt::format("{} known", silenced[Silence::Baseline]));
  }
  // Nothing was checked when a log was explained, or when the pack did not load.
  const bool checked = !pack.verdict.dimensions.empty();
  std::string text = checked ? toText(pack.verdict) : pack.verdict.path + ": no program checked\n";
  if (!parts.empty()) text += fmt::format("  {}\n", fmt::join(parts, ", "));
  return text;
}

std::string writeText(const ValidateResult& result) {
  std::string text;
  for (const PackResult& pack : result.packs) {
    text += messagesOf(pack, {.verbose = result.verbose}, result.strict) + summaryOf(pack);
  }
  return text;
}

}  // namespace orris
