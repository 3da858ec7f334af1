// Workflow commands of GitHub Actions: each becomes an annotation at the line of a pull request.
#include <fmt/format.h>

#include <orris/core/printable.h>
#include <orris/report/report_format.h>

namespace orris {
namespace {

const char* commandOf(Severity severity) {
  if (severity == Severity::Note) return "notice";
  return severityName(severity);
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
  return text;
}

/// The runner reads up to the end of the line.
std::string escapedData(std::string_view text) {
  return replaced(replaced(printableLines(text), "%", "%25"), "\n", "%0A");
}

std::string escapedProperty(std::string_view text) {
  return replaced(replaced(escapedData(text), ":", "%3A"), ",", "%2C");
}

std::string annotation(const Finding& finding) {
  const Diagnostic d = withFollows(finding);
  std::string line = fmt::format("::{} ", commandOf(d.severity));
  if (!finding.uri.empty()) line += fmt::format("file={},", escapedProperty(finding.uri));
  if (d.at.line > 0) line += fmt::format("line={},", d.at.line);
  if (d.at.line > 0 && d.at.column > 0) line += fmt::format("col={},", d.at.column);
  std::string message = d.message;
  for (const SourceLocation& place : d.includedFrom) {
    message += fmt::format("\nincluded from {}:{}", place.file, place.line);
  }
  for (const RelatedPlace& place : d.related) {
    message += fmt::format("\nnote: {}: {}", formatLocation(place.at), place.message);
  }
  for (const std::string& note : d.notes) message += "\nnote: " + note;
  if (!d.hint.empty()) message += "\nhint: " + d.hint;
  return line + fmt::format("title={}::{}\n", escapedProperty(d.id), escapedData(message));
}

}  // namespace

std::string writeGithub(const ValidateResult& result) {
  std::string text;
  for (const PackResult& pack : result.packs) {
    for (const Finding& finding : pack.findings) {
      const bool shown = finding.diagnostic.severity != Severity::Note || result.verbose;
      if (finding.silence == Silence::None && shown) text += annotation(finding);
    }
  }
  return text;
}

}  // namespace orris
