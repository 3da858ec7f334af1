// JSON for scripts; its schema is docs/schema/validate.schema.json.
#include <nlohmann/json.hpp>

#include <orris/report/diagnostic_json.h>
#include <orris/report/report_format.h>

namespace orris {
namespace {

using nlohmann::json;

constexpr int kSchema = 1;

const char* silenceName(Silence silence) {
  switch (silence) {
    case Silence::Comment:
      return "comment";
    case Silence::Flag:
      return "flag";
    case Silence::Baseline:
      return "baseline";
    case Silence::None:
      break;
  }
  return "none";
}

json entryOf(const Finding& finding) {
  json entry = toJson(Diagnostics{finding.diagnostic}).front();
  entry["uri"] = finding.uri;
  entry["fingerprint"] = finding.fingerprint;
  entry["programs"] = finding.programs;
  entry["follows"] = json::array();
  for (const Finding& other : finding.follows) entry["follows"].push_back(entryOf(other));
  if (finding.silence != Silence::None) entry["silencedBy"] = silenceName(finding.silence);
  return entry;
}

json packOf(const PackResult& pack) {
  json entry = toJson(pack.verdict);
  entry["diagnostics"] = json::array();
  entry["silenced"] = json::array();
  for (const Finding& finding : pack.findings) {
    const bool open = finding.silence == Silence::None;
    entry[open ? "diagnostics" : "silenced"].push_back(entryOf(finding));
  }
  return entry;
}

}  // namespace

std::string writeJson(const ValidateResult& result) {
  json root = {{"schema", kSchema},
               {"tool", {{"name", "orris"}, {"version", ORRIS_VERSION}}},
               {"packs", json::array()},
               {"status", result.status}};
  for (const PackResult& pack : result.packs) root["packs"].push_back(packOf(pack));
  if (result.baseline) {
    root["baseline"] = {{"known", result.baseline->taken()}, {"gone", result.baseline->left()}};
  }
  return jsonText(root);
}

}  // namespace orris
