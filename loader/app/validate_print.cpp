#include "app/validate_print.h"

#include <fmt/format.h>

#include <iostream>
#include <nlohmann/json.hpp>

namespace orris {

void printText(const PackVerdict& verdict) {
  const auto count = [](const ProgramVerdicts& programs, std::string_view kind) {
    return fmt::format("{}/{} {}", programs.all.size() - programs.failed.size(),
                       programs.all.size(), kind);
  };
  std::string text = verdict.path + ": " + count(verdict.programs, "programs");
  for (const auto& [mod, programs] : verdict.modPrograms) text += ", " + count(programs, mod);
  if (verdict.dimensions.size() > 1) text += fmt::format(", {} folders", verdict.dimensions.size());
  if (verdict.profiles.size() > 1) text += fmt::format(", {} profiles", verdict.profiles.size());
  std::cout << text << '\n';
  const auto printFailed = [](const ProgramVerdicts& programs) {
    for (const std::string& name : programs.failed) std::cout << "  failed: " << name << '\n';
  };
  printFailed(verdict.programs);
  for (const auto& [mod, programs] : verdict.modPrograms) printFailed(programs);
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
