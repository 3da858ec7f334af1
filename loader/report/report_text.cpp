// Text for people: messages as editors click them, each with its id, then the counts.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include <orris/core/limits.h>
#include <orris/report/report_format.h>

namespace orris {
namespace {

std::string counted(int count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

}  // namespace

Diagnostic withFollows(const Finding& finding) {
  Diagnostic diagnostic = finding.diagnostic;
  const auto count = finding.follows.size();
  if (count > 0) {
    diagnostic.notes.push_back(fmt::format("{} finding{} from this one (--verbose lists them)",
                                           count, count == 1 ? " follows" : "s follow"));
  }
  return diagnostic;
}

std::string messagesOf(const PackResult& pack, const Verbosity& verbosity, bool strict,
                       const TextStyle& style) {
  const std::string folder = shadersFolderOf(pack.verdict.path);
  std::string text;
  std::map<std::string, std::size_t> printed;
  const auto add = [&](const Finding& finding) {
    const bool shown =
        finding.silence == Silence::None &&
        (isShown(finding.diagnostic.severity, verbosity) || countsAsFailure(finding, strict));
    if (!shown) return;
    const std::size_t count = ++printed[finding.diagnostic.id];
    if (count <= limits::kPrintedOfAKind || verbosity.verbose)
      text += styledText(withFollows(finding), style, folder) + '\n';
  };
  for (const Finding& finding : pack.findings) {
    add(finding);
    if (verbosity.verbose) std::ranges::for_each(finding.follows, add);
  }
  for (const auto& [id, count] : printed) {
    if (count <= limits::kPrintedOfAKind || verbosity.verbose) continue;
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
    text += messagesOf(pack, {.verbose = result.verbose}, result.strict, {}) + summaryOf(pack);
  }
  return text;
}

}  // namespace orris
