#include "app/study/scene_list.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/commands/trace_loop.h"
#include "app/commands/trace_scene_input.h"
#include "app/input/inputs.h"
#include "app/input/shipped_worlds.h"
#include "app/study/open_study.h"
#include <orris/chart/scenes/scene_study.h>
#include <orris/core/files/read_places.h>
#include <orris/core/work_record.h>
#include <orris/trace/film/traced_picture.h>
#include <orris/world/resources/resource_stack.h>

namespace orris {
namespace {

bool traceReference(const StudyOptions& options, const std::string& picture, Report& report) {
  const auto view = openReferenceScene(options.pack, options.scene, options.image, report);
  if (!view) return false;
  Diagnostics diagnostics;
  bool good = false;
  // No driver works, and tracing has a limit of its own, which may be longer than that of loading a scene.
  noteIdle();
  withTraceHooks(report, [&](const TraceHooks& hooks) {
    const TraceLimits limits{.seconds = options.scenes.traceSeconds, .noise = options.scenes.traceNoise};
    good = provideTraced(picture, *view, {options.scene.seed, -1}, limits, hooks, diagnostics);
  });
  noteWork("loading", "", options.pack.path);
  report.add(diagnostics);
  return good;
}

RowPlan planOf(const StudyOptions& options) {
  const MeasurePlan& plan = options.plan;
  return {options.scenes.runs, plan.warmUp, plan.frames, options.scenes.costs ? plan.rounds : 0,
          plan.visit,          plan.clock,  plan.buffer, options.scene.seed};
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
          {"ratio", row.cost.ratio},     {"editing", row.editing.ratio}, {"moving", row.moving.ratio}, {"lag", row.lag},
          {"megabytes", row.megabytes}};
}

/// Scenes are opened one after another, when this process is shut in. false: reported.
bool addPlacesOfScenes(const StudyOptions& options, const std::vector<SceneName>& scenes, Report& report) {
  for (const SceneName& scene : scenes)
    if (const std::string path = findWorld(scene.world); !path.empty()) addReadPlace(path);
  if (!options.pack.settingsFile.empty()) addReadPlace(options.pack.settingsFile);
  Diagnostics diagnostics;
  const bool opened = openResources(options.scene.resources, diagnostics).has_value();
  report.add(diagnostics);
  return opened;
}

}  // namespace

int runScenes(const StudyOptions& options, Report& report, nlohmann::json& result) {
  const auto scenes = parseScenes(options.scenes.names);
  if (!scenes) {
    report.error("scenes-syntax", "--scenes: expected WORLD, WORLD@CAMERA or random:SEED:N, separated by commas",
                 "--scenes cornell,h4_house@inside,random:1:20");
    return report.status();
  }
  const StudyFiles files(options.folder);
  const auto pack = openPackFiles(options.pack.path, report);
  if (!pack || !addPlacesOfScenes(options, *scenes, report)) return report.status();
  const auto open = [&](const SceneName& scene) -> std::optional<StudyRequest> {
    StudyOptions one = options;
    one.scene.path = scene.world;
    one.scene.camera = scene.camera;
    one.references = {files.path(fileStem(scene), ".exr")};
    if (!traceReference(one, one.references.front(), report)) return std::nullopt;
    return makeStudyRequest(one, pack, report);
  };
  const auto rows = measureScenes(
      {*scenes, open, planOf(options), options.image.backend, parseBudget(options.budget)}, files, studyHooks(files, {}, report));
  if (!rows) return std::max(report.status(), kUsage);
  result["rows"] = nlohmann::json::array();
  for (const SceneRow& row : *rows) result["rows"].push_back(describeRow(row));
  if (!options.output.json && !options.output.quiet && !rows->empty()) printText(sceneSummary(*rows));
  sayWritten(options.output, {options.folder});
  return report.status();
}

}  // namespace orris
