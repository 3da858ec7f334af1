#include <orris/report/diagnostic_json.h>

#include <nlohmann/json.hpp>

namespace orris {

nlohmann::json toJson(const SourceLocation& location) {
  return {{"file", location.file}, {"line", location.line}, {"column", location.column}};
}

nlohmann::json toJson(const Diagnostics& diagnostics) {
  nlohmann::json list = nlohmann::json::array();
  for (const Diagnostic& diagnostic : diagnostics) {
    nlohmann::json entry = toJson(diagnostic.at);
    entry["severity"] = severityName(diagnostic.severity);
    entry["id"] = diagnostic.id;
    entry["message"] = diagnostic.message;
    entry["includedFrom"] = nlohmann::json::array();
    for (const SourceLocation& place : diagnostic.includedFrom) {
      entry["includedFrom"].push_back(toJson(place));
    }
    entry["sourceLine"] = diagnostic.sourceLine;
    entry["related"] = nlohmann::json::array();
    for (const RelatedPlace& place : diagnostic.related) {
      entry["related"].push_back(toJson(place.at));
      entry["related"].back()["message"] = place.message;
    }
    entry["notes"] = diagnostic.notes;
    entry["hint"] = diagnostic.hint;
    if (diagnostic.effect != Effect::Unstated) entry["effect"] = effectName(diagnostic.effect);
    list.push_back(std::move(entry));
  }
  return list;
}

std::string jsonText(const nlohmann::json& value) {
  // Packs are untrusted: bytes that are not UTF-8 must not end the program.
  std::string text = value.dump(2, ' ', true, nlohmann::json::error_handler_t::replace);
  // Some runners of CI services look for "##[command]" anywhere in a line.
  for (std::size_t at = 0; (at = text.find("##", at)) != std::string::npos; ++at)
    text.replace(at + 1, 1, "\\u0023");
  return text + '\n';
}

}  // namespace orris
