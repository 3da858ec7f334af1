#include "app/study/scene_study.h"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/commands/trace_loop.h"
#include "app/commands/trace_scene_input.h"
#include "app/input/inputs.h"
#include "app/output/progress.h"
#include "app/study/open_study.h"
#include <orris/chart/scenes/row_meter.h>
#include <orris/trace/edge_pixels.h>
#include <orris/trace/film/checkpoint.h>
#include <orris/world/random_room.h>

namespace orris {
namespace {

using Clock = std::chrono::steady_clock;
constexpr int kMostRooms = 10000;

std::optional<std::uint32_t> wholeNumber(std::string_view text) {
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// "random:SEED:N"
bool addRooms(std::string_view text, std::vector<SceneName>& scenes) {
  text.remove_prefix(kRandomRoom.size());
  const std::size_t colon = text.find(':');
  const auto seed = wholeNumber(text.substr(0, colon));
  const auto count = colon == std::string_view::npos ? std::optional<std::uint32_t>(1)
                                                     : wholeNumber(text.substr(colon + 1));
  if (!seed || !count || *count == 0 || *count > kMostRooms) return false;
  for (std::uint32_t i = 0; i < *count; ++i)
    scenes.push_back({fmt::format("{}{}", kRandomRoom, *seed + 2 * i), ""});
  return true;
}

std::string fileNameOf(const SceneName& scene) {
  return fileStem(scene.camera.empty() ? scene.world : scene.world + "@" + scene.camera);
}

/// The picture that errors are measured against, from the folder where it is of the same scene; else traced now.
bool traceReference(const StudyOptions& options, const std::string& picture, Report& report) {
  const auto view = openReferenceScene(options.pack, options.scene, options.image, report);
  if (!view) return false;
  const TraceSettings settings{options.scene.seed, -1};
  const std::uint64_t key = traceKey(view->scene, view->camera, settings);
  const std::string checkpoint = picture + ".trace";
  std::optional<TraceFilm> film;
  Diagnostics another;  // of another scene: traced anew
  if (std::filesystem::exists(checkpoint)) film = readCheckpoint(checkpoint, key, another);
  if (film && std::filesystem::exists(picture)) return true;
  if (!film) film = TraceFilm(view->camera.width, view->camera.height, {0, 1});
  const TraceJob job{view->scene, view->camera, settings, 0, checkpoint, key};
  traceUntil(*film, job, {.samples = 0, .seconds = options.scenes.traceSeconds, .noise = options.scenes.traceNoise},
             report);
  if (report.status() != kClean) return false;
  return writeTraced(picture, *film, edgePixels(view->scene, view->camera), report);
}

RowPlan planOf(const StudyOptions& options) {
  const MeasurePlan& plan = options.plan;
  return {options.scenes.runs, plan.warmUp, plan.frames, options.scenes.costs ? plan.rounds : 0,
          plan.visit,          plan.clock,  plan.buffer, options.scene.seed};
}

/// All settings on one scene. false: reported.
bool measureOne(const StudyOptions& options, gl::Context& context, std::vector<SceneRow>& rows, Report& report) {
  auto request = makeStudyRequest(options, report);
  if (!request) return false;
  Diagnostics diagnostics;
  const auto input = readStudyInput(std::move(*request), diagnostics);
  report.add(diagnostics);
  if (!input) return false;
  const ReferencePicture& reference = input->references.begin()->second;
  const RowPlan plan = planOf(options);
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
  report.add(diagnostics);
  rows.insert(rows.end(), own.begin(), own.end());
  return good;
}

nlohmann::json describeRow(const SceneRow& row) {
  nlohmann::json channels = nlohmann::json::array();
  for (const ChannelBias& bias : row.bias)
    channels.push_back({{"rms", signedRoot(bias.square)},
                        {"rmsInterval", {signedRoot(bias.squareInterval.low), signedRoot(bias.squareInterval.high)}},
                        {"signed", bias.signedMean},
                        {"signedInterval", {bias.signedInterval.low, bias.signedInterval.high}},
                        {"drift", bias.drift}});
  return {{"scene", row.scene},          {"camera", row.camera},     {"time", row.time},
          {"setting", row.setting},      {"bias", channels},         {"noise", row.noise.back()},
          {"ratio", row.cost.ratio},     {"editing", row.editing.ratio}, {"lag", row.lag},
          {"megabytes", row.megabytes}};
}

void warnUnfinished(std::size_t done, std::size_t all, Report& report) {
  report.add({.severity = Severity::Warning,
              .id = "study-unfinished",
              .message = fmt::format("the budget ended after {} of {} scenes", done, all),
              .hint = "give more time, or fewer scenes"});
}

}  // namespace

std::optional<std::vector<SceneName>> parseScenes(const std::vector<std::string>& list) {
  std::vector<SceneName> scenes;
  for (const std::string& text : list) {
    if (text.starts_with(kRandomRoom)) {
      if (!addRooms(text, scenes)) return std::nullopt;
      continue;
    }
    const std::size_t at = text.rfind('@');
    scenes.push_back({text.substr(0, at), at == std::string::npos ? "" : text.substr(at + 1)});
    if (scenes.back().world.empty()) return std::nullopt;
  }
  return scenes;
}

int runScenes(const StudyOptions& options, Report& report, nlohmann::json& result) {
  const auto scenes = parseScenes(options.scenes.names);
  if (!scenes) {
    report.error("scenes-syntax", "--scenes: expected WORLD, WORLD@CAMERA or random:SEED:N, separated by commas",
                 "--scenes cornell,h4_house@inside,random:1:20");
    return report.status();
  }
  const StudyFiles files(options.folder);
  Diagnostics diagnostics;
  const bool created = files.create(diagnostics);
  report.add(diagnostics);
  if (!created) return report.status();
  const auto context = gl::createContext({.backend = options.image.backend}, diagnostics);
  report.add(diagnostics);
  if (!context) return report.status();
  const auto budget = parseBudget(options.budget);
  const Clock::time_point start = Clock::now();
  Progress progress("measuring scenes", int(scenes->size()), report.output());
  std::vector<SceneRow> rows;
  std::size_t done = 0;
  for (; done < scenes->size() && (!budget || Clock::now() - start < *budget); ++done) {
    const SceneName& scene = (*scenes)[done];
    StudyOptions one = options;
    one.scene.path = scene.world;
    one.scene.camera = scene.camera;
    one.references = {files.path(fileNameOf(scene), ".exr")};
    if (!traceReference(one, one.references.front(), report)) return report.status();
    if (!measureOne(one, *context, rows, report)) return std::max(report.status(), kUsage);
    const std::string table = (std::filesystem::path(options.folder) / "scenes.csv").string();
    if (!writeWholeFile(table, sceneRowsCsv(rows), report)) return report.status();
    progress.advanceTo(int(done) + 1);
  }
  if (done < scenes->size()) warnUnfinished(done, scenes->size(), report);
  result["rows"] = nlohmann::json::array();
  for (const SceneRow& row : rows) result["rows"].push_back(describeRow(row));
  if (!options.output.json && !options.output.quiet && !rows.empty()) printText(sceneSummary(rows));
  sayWritten(options.output, {options.folder});
  return report.status();
}

}  // namespace orris
