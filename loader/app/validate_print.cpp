#include "app/validate_print.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace orris {

std::string toText(const PackVerdict& verdict) {
  const auto count = [](const ProgramVerdicts& programs, std::string_view kind) {
    return fmt::format("{}/{} {}", programs.all.size() - programs.failed.size(),
                       programs.all.size(), kind);
  };
  std::string text = verdict.path + ": " + count(verdict.programs, "programs");
  for (const auto& [mod, programs] : verdict.modPrograms) text += ", " + count(programs, mod);
  if (verdict.dimensions.size() > 1) text += fmt::format(", {} folders", verdict.dimensions.size());
  if (verdict.profiles.size() > 1) text += fmt::format(", {} profiles", verdict.profiles.size());
  text += '\n';
  const auto addFailed = [&](const ProgramVerdicts& programs) {
    for (const std::string& name : programs.failed) text += fmt::format("  failed: {}\n", name);
  };
  addFailed(verdict.programs);
  for (const auto& [mod, programs] : verdict.modPrograms) addFailed(programs);
  return text;
}

nlohmann::json toJson(const PackVerdict& verdict) {
  nlohmann::json mods = nlohmann::json::array();
  for (const auto& [mod, programs] : verdict.modPrograms) {
    mods.push_back({{"name", mod}, {"programs", programs.all}, {"failed", programs.failed}});
  }
  return {{"path", verdict.path},
          {"programs", verdict.programs.all},
          {"failed", verdict.programs.failed},
          {"mods", mods},
          {"folders", verdict.dimensions},
          {"profiles", verdict.profiles},
          {"status", verdict.status}};
}

}  // namespace orris
