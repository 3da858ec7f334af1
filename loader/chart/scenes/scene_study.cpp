#include <orris/chart/scenes/scene_study.h>

#include <fmt/format.h>

#include <filesystem>

#include <orris/core/files/named_file.h>

namespace orris {
namespace {

using Clock = std::chrono::steady_clock;

/// All settings on one scene. false: see diagnostics.
bool measureScene(const RowPlan& plan, StudyRequest request, gl::Context& context, std::vector<SceneRow>& rows,
                  Diagnostics& diagnostics) {
  const auto input = readStudyInput(std::move(request), diagnostics);
  if (!input) return false;
  const ReferencePicture& reference = input->references.begin()->second;
  RowMeter meter(context, input->asked.world, reference, plan);
  std::vector<SceneRow> own;
  std::vector<SessionRequest> requests;
  for (const Setting& setting : input->settings) {
    requests.push_back(requestFor(input->session, setting));
    auto row = meter.row(requests.back(), setting.label, diagnostics);
    if (!row) break;
    own.push_back(std::move(*row));
  }
  const bool good = own.size() == input->settings.size() &&
                    (plan.rounds == 0 || meter.addCosts(requests, own, diagnostics));
  rows.insert(rows.end(), own.begin(), own.end());
  return good;
}

Diagnostic unfinished(std::size_t done, std::size_t all) {
  return {.severity = Severity::Warning,
          .id = "study-unfinished",
          .message = fmt::format("the budget ended after {} of {} scenes", done, all),
          .hint = "give more time, or fewer scenes"};
}

}  // namespace

std::optional<std::vector<SceneRow>> measureScenes(const SceneStudyRequest& request, const StudyFiles& files,
                                                   const StudyHooks& hooks) {
  const auto finished = [&hooks](Diagnostics diagnostics, bool good) {
    hooks.report(diagnostics);
    return good;
  };
  Diagnostics diagnostics;
  const bool made = files.create(diagnostics);
  if (made && hooks.beforeDriver) hooks.beforeDriver();
  const auto context = made ? gl::createContext({.backend = request.backend}, diagnostics) : nullptr;
  if (!finished(std::move(diagnostics), context != nullptr)) return std::nullopt;
  const std::size_t all = request.scenes.size();
  const auto advance = hooks.begin ? hooks.begin("measuring scenes", int(all)) : [](int) {};
  const std::string table = (std::filesystem::path(files.folder()) / "scenes.csv").string();
  const Clock::time_point start = Clock::now();
  std::vector<SceneRow> rows;
  std::size_t done = 0;
  for (; done < all && (!request.budget || Clock::now() - start < *request.budget); ++done) {
    auto study = request.open(request.scenes[done]);
    if (!study) return std::nullopt;
    Diagnostics found;
    const bool good = measureScene(request.plan, std::move(*study), *context, rows, found) &&
                      writeNamedFile(table, sceneRowsCsv(rows), found);
    if (!finished(std::move(found), good)) return std::nullopt;
    advance(int(done) + 1);
  }
  if (done < all) finished({unfinished(done, all)}, true);
  return rows;
}

}  // namespace orris
