#include "app/view/script/view_script.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include <orris/pack/files/text.h>

namespace orris {
namespace {

using NodeKind = JsonNode::Kind;

/// `others`: members that the step may have beside its own, separated by blanks.
struct StepRow {
  const char* action;
  std::vector<NodeKind> kinds;
  const char* others;
};

const std::vector<StepRow>& stepRows() {
  static const std::vector<StepRow> kRows = {
      {"key", {NodeKind::String}, "hold"},
      {"text", {NodeKind::String}, ""},
      {"move", {NodeKind::Array, NodeKind::String}, ""},
      {"click", {NodeKind::Array, NodeKind::String}, "button"},
      {"drag", {NodeKind::String}, "to"},
      {"scroll", {NodeKind::Integer, NodeKind::Real}, ""},
      {"set", {NodeKind::Object}, ""},
      {"profile", {NodeKind::String}, ""},
      {"live", {NodeKind::Array}, ""},
      {"time", {NodeKind::Integer}, ""},
      {"rain", {NodeKind::Integer, NodeKind::Real}, ""},
      {"thunder", {NodeKind::Integer, NodeKind::Real}, ""},
      {"camera", {NodeKind::String}, ""},
      {"pause", {NodeKind::Boolean}, ""},
      {"pack", {NodeKind::Boolean}, ""},
      {"resize", {NodeKind::Array}, ""},
      {"write", {NodeKind::String}, "text"},
      {"replace", {NodeKind::String}, "old new"},
      {"remove", {NodeKind::String}, ""},
      {"rename", {NodeKind::String}, "to"},
      {"frames", {NodeKind::Integer}, ""},
      {"until", {NodeKind::Object}, "seconds"},
      {"expect", {NodeKind::Object}, ""},
      {"screenshot", {NodeKind::String}, ""},
      {"picture", {NodeKind::String}, ""},
      {"compare", {NodeKind::String}, ""},
      {"program", {NodeKind::String}, ""},
      {"checkFinite", {NodeKind::Boolean}, ""},
      {"show", {NodeKind::String}, ""},
      {"shown", {NodeKind::String}, ""},
      {"state", {NodeKind::String}, ""},
  };
  return kRows;
}

std::string kindNames(const std::vector<NodeKind>& kinds) {
  static constexpr const char* kNames[] = {"null",   "true or false", "a whole number", "a number",
                                           "a text", "a list",        "an object"};
  std::string names;
  for (const NodeKind kind : kinds)
    names += (names.empty() ? "" : " or ") + std::string(kNames[int(kind)]);
  return names;
}

bool readStep(const JsonText& source, const JsonNode& node, ViewScript& script,
              Diagnostics& diagnostics) {
  const auto refuse = [&](std::size_t offset, std::string message, std::string hint = "") {
    diagnostics.push_back(source.error(offset, "script-step", std::move(message), std::move(hint)));
    return false;
  };
  if (node.kind != NodeKind::Object || node.members.empty())
    return refuse(node.offset, "a step is an object like {\"key\": \"F1\"}");
  const JsonMember& first = node.members.front();
  const auto row = std::ranges::find_if(
      stepRows(), [&](const StepRow& one) { return one.action == first.key; });
  if (row == stepRows().end()) {
    std::vector<std::string> names;
    for (const StepRow& one : stepRows()) names.emplace_back(one.action);
    const std::string meant = suggest(first.key, names);
    return refuse(first.offset, fmt::format("there is no step \"{}\"", first.key),
                  meant.empty() ? "steps are " + joinNames(names) : meant);
  }
  if (std::ranges::find(row->kinds, first.value.kind) == row->kinds.end())
    return refuse(first.value.offset,
                  fmt::format("\"{}\" takes {}", first.key, kindNames(row->kinds)));
  const std::vector<std::string> others = splitBlanks(row->others);
  for (std::size_t i = 1; i < node.members.size(); ++i) {
    const JsonMember& member = node.members[i];
    if (std::ranges::find(others, member.key) == others.end())
      return refuse(member.offset, fmt::format("the step \"{}\" has no member \"{}\"", first.key,
                                               member.key));
  }
  script.steps.push_back({first.key, first.value, node});
  return true;
}

std::string differs(const nlohmann::json& found, const nlohmann::json& wanted) {
  const bool ranged = wanted.is_object() && (wanted.contains("min") || wanted.contains("max") ||
                                             wanted.contains("contains"));
  if (!ranged) return found == wanted ? "" : fmt::format("expected {}", wanted.dump());
  if (wanted.contains("min") && !(found.is_number() && found >= wanted["min"]))
    return fmt::format("expected {} or more", wanted["min"].dump());
  if (wanted.contains("max") && !(found.is_number() && found <= wanted["max"]))
    return fmt::format("expected {} or less", wanted["max"].dump());
  if (!wanted.contains("contains")) return "";
  const nlohmann::json& part = wanted["contains"];
  const bool inText = found.is_string() && part.is_string() &&
                      found.get<std::string>().find(part.get<std::string>()) != std::string::npos;
  const bool inList = found.is_array() && std::ranges::find(found, part) != found.end();
  return inText || inList ? "" : fmt::format("expected something with {}", part.dump());
}

}  // namespace

Diagnostic ViewScript::problem(const ScriptStep& step, std::string id, std::string message,
                               std::string hint) const {
  return JsonText{text, file}.error(step.object.offset, std::move(id), std::move(message),
                                    std::move(hint));
}

std::optional<ViewScript> parseViewScript(std::string file, std::string text,
                                          Diagnostics& diagnostics) {
  ViewScript script{std::move(file), std::move(text), {}};
  const JsonText source{script.text, script.file};
  const auto root = parseLocatedJson(source, diagnostics);
  if (!root) return std::nullopt;
  if (root->kind != NodeKind::Array) {
    diagnostics.push_back(source.error(root->offset, "script-step", "a script is a list of steps",
                                       "write [ {\"key\": \"F1\"}, ... ]"));
    return std::nullopt;
  }
  for (const JsonNode& node : root->items)
    if (!readStep(source, node, script, diagnostics)) return std::nullopt;
  return script;
}

nlohmann::json plainJson(const JsonNode& node) {
  switch (node.kind) {
    case NodeKind::Null:
      return nullptr;
    case NodeKind::Boolean:
      return node.boolean;
    case NodeKind::Integer:
      return node.integer;
    case NodeKind::Real:
      return node.real;
    case NodeKind::String:
      return node.text;
    case NodeKind::Array:
      break;
    case NodeKind::Object: {
      nlohmann::json object = nlohmann::json::object();
      for (const JsonMember& member : node.members) object[member.key] = plainJson(member.value);
      return object;
    }
  }
  nlohmann::json array = nlohmann::json::array();
  for (const JsonNode& item : node.items) array.push_back(plainJson(item));
  return array;
}

std::string mismatch(const nlohmann::json& state, const JsonNode& wanted) {
  for (const JsonMember& member : wanted.members) {
    // A pointer with a stray "~" throws.
    if (!member.key.starts_with('/') || member.key.find('~') != std::string::npos)
      return fmt::format("\"{}\" is no place in the state: write \"/profile\"", member.key);
    const nlohmann::json::json_pointer place(member.key);
    const bool exists = state.contains(place);
    const nlohmann::json found = exists ? state[place] : nlohmann::json();
    const std::string problem = differs(found, plainJson(member.value));
    if (!problem.empty())
      return fmt::format("{} is {}, {}", member.key, exists ? found.dump() : "absent", problem);
  }
  return "";
}

}  // namespace orris
