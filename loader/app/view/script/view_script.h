// A script for the window: what a person would do, and what must be seen. docs/view.md lists the steps.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include <orris/core/diagnostic.h>
#include <orris/world/files/located_json.h>

namespace orris {

/// One step: what it does ("key") and with what; the object holds its other members.
struct ScriptStep {
  std::string action;
  JsonNode value;
  JsonNode object;
};

struct ViewScript {
  std::string file, text;
  std::vector<ScriptStep> steps;

  /// A problem with a step, at its place in the script.
  Diagnostic problem(const ScriptStep& step, std::string id, std::string message,
                     std::string hint = "") const;
};

/// nullopt and diagnostics when it is no JSON, or a step has an unknown name or a value of a wrong kind.
std::optional<ViewScript> parseViewScript(std::string file, std::string text,
                                          Diagnostics& diagnostics);

/// The same value for comparing with the state.
nlohmann::json plainJson(const JsonNode& node);

/// Why `state` is not as `wanted` says, "" when it is. `wanted`: JSON pointer -> value that must be
/// there, or {"min": n, "max": n, "contains": "text"}.
std::string mismatch(const nlohmann::json& state, const JsonNode& wanted);

}  // namespace orris
