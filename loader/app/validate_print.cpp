#include "app/validate_print.h"

#include <fmt/format.h>

#include <iostream>
#include <nlohmann/json.hpp>

namespace orris {

void printText(const PackVerdict& verdict) {
  const size_t good = verdict.programs.size() - verdict.failed.size();
  std::string text = fmt::format("{}: {}/{} programs", verdict.path, good, verdict.programs.size());
  if (verdict.dimensions.size() > 1) text += fmt::format(", {} folders", verdict.dimensions.size());
  if (verdict.profiles.size() > 1) text += fmt::format(", {} profiles", verdict.profiles.size());
  std::cout << text << '\n';
  for (const std::string& name : verdict.failed) std::cout << "  failed: " << name << '\n';
}

nlohmann::json toJson(const PackVerdict& verdict) {
  return {{"path", verdict.path},         {"programs", verdict.programs},
          {"failed", verdict.failed},     {"folders", verdict.dimensions},
          {"profiles", verdict.profiles}, {"status", verdict.status}};
}

}  // namespace orris
