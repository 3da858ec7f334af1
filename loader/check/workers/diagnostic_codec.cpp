#include <orris/check/workers/diagnostic_codec.h>

#include <nlohmann/json.hpp>

namespace orris {
namespace {

using nlohmann::json;

json pack(const SourceLocation& at) { return json::array({at.file, at.line, at.column}); }

SourceLocation unpackLocation(const json& value) { return {value[0], value[1], value[2]}; }

json pack(const std::optional<LineEdit>& edit) {
  if (!edit) return nullptr;
  return json::array({edit->file, edit->line, edit->text, edit->replaces});
}

json pack(const Diagnostic& d) {
  json chain = json::array(), related = json::array();
  for (const SourceLocation& at : d.includedFrom) chain.push_back(pack(at));
  for (const RelatedPlace& place : d.related)
    related.push_back(json::array({pack(place.at), place.message}));
  return json::array({int(d.severity), d.id, pack(d.at), d.message, chain, d.sourceLine, d.notes,
                      d.hint, effectName(d.effect), related, pack(d.repair)});
}

Diagnostic unpack(const json& value) {
  Diagnostic d;
  d.severity = static_cast<Severity>(value[0].get<int>());
  d.id = value[1];
  d.at = unpackLocation(value[2]);
  d.message = value[3];
  for (const json& at : value[4]) d.includedFrom.push_back(unpackLocation(at));
  d.sourceLine = value[5];
  d.notes = value[6].get<std::vector<std::string>>();
  d.hint = value[7];
  d.effect = effectNamed(value[8].get<std::string>());
  for (const json& place : value[9])
    d.related.push_back({unpackLocation(place[0]), place[1].get<std::string>()});
  if (const json& edit = value[10]; !edit.is_null())
    d.repair = LineEdit{edit[0], edit[1], edit[2], edit[3]};
  return d;
}

}  // namespace

std::string encodeDiagnostics(const Diagnostics& diagnostics) {
  json list = json::array();
  for (const Diagnostic& diagnostic : diagnostics) list.push_back(pack(diagnostic));
  std::string bytes;
  json::to_cbor(list, bytes);
  return bytes;
}

Diagnostics decodeDiagnostics(std::string_view bytes) {
  Diagnostics diagnostics;
  for (const json& value : json::from_cbor(bytes.begin(), bytes.end())) {
    diagnostics.push_back(unpack(value));
  }
  return diagnostics;
}

}  // namespace orris
