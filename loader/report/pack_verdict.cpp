#include <orris/report/pack_verdict.h>

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace orris {
namespace {

// A mistake in a shared file fails all programs; JSON names each.
constexpr std::size_t kMostFailed = 8;

std::string matrixText(const MatrixSummary& matrix) {
  std::string text = fmt::format("  matrix {}", matrix.kind);
  if (!matrix.profile.empty()) text += fmt::format(", profile {}", matrix.profile);
  if (matrix.shards > 1) text += fmt::format(", shard {}/{}", matrix.shard, matrix.shards);
  text += matrix.all && matrix.tried == matrix.configurations
              ? fmt::format(": {} configurations", matrix.configurations)
              : fmt::format(": tried {} of {}{} configurations within the budget", matrix.tried,
                            matrix.all ? "" : "at least ", matrix.configurations);
  return text + fmt::format(", {} program variants, {} distinct programs compiled, {:.1f} s\n",
                            matrix.variants, matrix.compiled, matrix.seconds);
}

nlohmann::json matrixJson(const MatrixSummary& matrix) {
  return {{"kind", matrix.kind},
          {"profile", matrix.profile},
          {"shard", matrix.shard},
          {"shards", matrix.shards},
          {"configurations", matrix.configurations},
          {"allCounted", matrix.all},
          {"tried", matrix.tried},
          {"programVariants", matrix.variants},
          {"distinctPrograms", matrix.compiled},
          {"seconds", matrix.seconds}};
}

}  // namespace

std::string toText(const PackVerdict& verdict) {
  const auto count = [](const ProgramVerdicts& programs, std::string_view kind) {
    return fmt::format("{}/{} {}", programs.all.size() - programs.failed.size(),
                       programs.all.size(), kind);
  };
  std::string text = verdict.path + ": " + count(verdict.programs, "programs");
  for (const auto& [mod, programs] : verdict.modPrograms) text += ", " + count(programs, mod);
  if (verdict.dimensions.size() > 1) text += fmt::format(", {} folders", verdict.dimensions.size());
  if (verdict.profiles.size() > 1) text += fmt::format(", {} profiles", verdict.profiles.size());
  if (verdict.cached) text += ", unchanged since an earlier run";
  text += '\n';
  const auto addFailed = [&](const ProgramVerdicts& programs) {
    std::size_t named = 0;
    for (const std::string& name : programs.failed) {
      if (named++ == kMostFailed) break;
      text += fmt::format("  failed: {}\n", name);
    }
    if (programs.failed.size() > kMostFailed)
      text += fmt::format("  failed: {} more\n", programs.failed.size() - kMostFailed);
  };
  addFailed(verdict.programs);
  for (const auto& [mod, programs] : verdict.modPrograms) addFailed(programs);
  for (const MatrixSummary& matrix : verdict.matrices) text += matrixText(matrix);
  return text;
}

nlohmann::json toJson(const PackVerdict& verdict) {
  nlohmann::json mods = nlohmann::json::array();
  for (const auto& [mod, programs] : verdict.modPrograms) {
    mods.push_back({{"name", mod}, {"programs", programs.all}, {"failed", programs.failed}});
  }
  nlohmann::json matrices = nlohmann::json::array();
  for (const MatrixSummary& matrix : verdict.matrices) matrices.push_back(matrixJson(matrix));
  return {{"path", verdict.path},
          {"programs", verdict.programs.all},
          {"failed", verdict.programs.failed},
          {"mods", mods},
          {"folders", verdict.dimensions},
          {"profiles", verdict.profiles},
          {"matrices", matrices},
          {"cached", verdict.cached},
          {"status", verdict.status}};
}

}  // namespace orris
