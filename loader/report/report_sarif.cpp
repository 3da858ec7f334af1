// SARIF 2.1.0 (OASIS), which code hosts show beside the lines of a change. One run for all packs,
// since hosts take one run for each tool and category.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include <orris/check/rules/rules.h>
#include <orris/report/diagnostic_json.h>
#include <orris/report/report_format.h>

namespace orris {
namespace {

using nlohmann::json;

constexpr std::string_view kHomepage = ORRIS_HOMEPAGE;  // "": nobody publishes this build

const char* levelOf(Severity severity) { return severityName(severity); }  // SARIF has our words

/// Section 3.10: a relative URI reference, so that all but plain characters is escaped.
std::string encodedUri(std::string_view path) {
  std::string uri;
  for (const char c : path) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       std::string_view("-._~/").find(c) != std::string_view::npos;
    uri += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return uri;
}

/// Columns of ours are bytes.
int codePointColumn(const std::string& line, int column) {
  const auto end = line.begin() + std::min<std::ptrdiff_t>(column - 1, std::ssize(line));
  const auto inside = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; };
  return column - static_cast<int>(std::count_if(line.begin(), end, inside));
}

// Section 3.4.4: what has a base is relative.
json artifactOf(const std::string& uri) {
  if (uri.starts_with('/')) return {{"uri", "file://" + encodedUri(uri)}};
  return {{"uri", encodedUri(uri)}, {"uriBaseId", "SRCROOT"}};
}

json physicalLocation(const std::string& uri, const SourceLocation& at, const std::string& line) {
  json location = {{"artifactLocation", artifactOf(uri)}};
  if (at.line <= 0) return location;
  location["region"]["startLine"] = at.line;
  if (at.column > 0) location["region"]["startColumn"] = codePointColumn(line, at.column);
  if (!line.empty()) location["region"]["snippet"]["text"] = line;
  return location;
}

std::string messageOf(const Diagnostic& diagnostic) {
  std::string text = diagnostic.message;
  for (const std::string& note : diagnostic.notes) text += "\nnote: " + note;
  if (!diagnostic.hint.empty()) text += "\nhint: " + diagnostic.hint;
  return text;
}

json suppressionOf(Silence silence) {
  switch (silence) {
    case Silence::Comment:
      return {{"kind", "inSource"}, {"justification", "orris: ignore comment"}};
    case Silence::Flag:
      return {{"kind", "external"}, {"justification", "turned off on the command line"}};
    case Silence::Baseline:
    case Silence::None:
      break;
  }
  return {{"kind", "external"}, {"justification", "known: in the baseline"}};
}

json resultOf(const PackResult& pack, const Finding& finding) {
  const Diagnostic& d = finding.diagnostic;
  json result = {{"ruleId", d.id},
                 {"level", levelOf(d.severity)},
                 {"message", {{"text", messageOf(withFollows(finding))}}},
                 {"partialFingerprints", {{"orris/v1", finding.fingerprint}}},
                 {"suppressions", json::array()}};
  if (const Rule* rule = findRule(d.id)) result["ruleIndex"] = rule - ruleTable().data();
  // Hosts want a place for each result: what has none concerns the pack.
  const std::string& uri = finding.uri.empty() ? pack.root : finding.uri;
  result["locations"] = {{{"physicalLocation", physicalLocation(uri, d.at, d.sourceLine)}}};
  for (std::size_t i = 0; i < d.includedFrom.size(); ++i) {
    const SourceLocation& place = d.includedFrom[i];
    result["relatedLocations"].push_back(
        {{"id", i + 1},
         {"message", {{"text", "included from here"}}},
         {"physicalLocation", physicalLocation(pack.root + place.file, place, "")}});
  }
  for (const RelatedPlace& place : d.related) {
    result["relatedLocations"].push_back(
        {{"id", result["relatedLocations"].size() + 1},
         {"message", {{"text", place.message}}},
         {"physicalLocation", physicalLocation(pack.root + place.at.file, place.at, "")}});
  }
  if (finding.silence != Silence::None)
    result["suppressions"].push_back(suppressionOf(finding.silence));
  return result;
}

json ruleList() {
  json rules = json::array();
  for (const Rule& rule : ruleTable()) {
    const std::string page = fmt::format("docs/checks.md#{}", rule.id);
    json& entry = rules.emplace_back(
        json{{"id", rule.id},
             {"shortDescription", {{"text", rule.summary}}},
             {"help", {{"text", fmt::format("{}. See {}", rule.summary, page)}}},
             {"defaultConfiguration", {{"level", levelOf(rule.severity)}}}});
    if (!kHomepage.empty()) entry["helpUri"] = fmt::format("{}/blob/main/{}", kHomepage, page);
  }
  return rules;
}

}  // namespace

std::string writeSarif(const ValidateResult& result) {
  json run = {{"tool",
               {{"driver",
                 {{"name", "orris"},
                  {"version", ORRIS_VERSION},
                  {"semanticVersion", ORRIS_VERSION},
                  {"rules", ruleList()}}}}},
              {"columnKind", "unicodeCodePoints"},
              {"originalUriBaseIds",
               {{"SRCROOT", {{"description", {{"text", "the root of the repository"}}}}}}},
              {"results", json::array()}};
  if (!kHomepage.empty()) run["tool"]["driver"]["informationUri"] = kHomepage;
  for (const PackResult& pack : result.packs) {
    for (const Finding& finding : pack.findings) {
      const bool shown = finding.diagnostic.severity != Severity::Note || result.verbose;
      if (shown) run["results"].push_back(resultOf(pack, finding));
    }
  }
  const json log = {{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
                    {"version", "2.1.0"},
                    {"runs", {run}}};
  return jsonText(log);
}

}  // namespace orris
