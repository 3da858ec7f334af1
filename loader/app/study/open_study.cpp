#include "app/study/open_study.h"

#include <algorithm>
#include <filesystem>

#include "app/input/inputs.h"
#include "app/output/progress.h"
#include <orris/core/files/read_places.h>

namespace orris {
namespace {

std::string lastName(const std::string& path) {
  return std::filesystem::weakly_canonical(path).filename().string();
}

/// Empty: reported.
std::vector<Camera> chooseCameras(const StudyOptions& options, const World& world, Report& report) {
  std::vector<std::string> names;
  for (const std::string& name : options.cameras)
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  const char* flag = names.empty() ? "--camera" : "--cameras";
  if (names.empty()) names = {options.scene.camera};
  if (names == std::vector<std::string>{"all"}) return world.cameras;
  std::vector<Camera> cameras;
  for (const std::string& name : names)
    if (const auto camera = chooseCamera(world, name, report, flag)) cameras.push_back(*camera);
  return cameras.size() == names.size() ? cameras : std::vector<Camera>();
}

}  // namespace

std::optional<StudyRequest> makeStudyRequest(const StudyOptions& options, const std::shared_ptr<const FileSource>& files,
                                             Report& report) {
  auto world = loadScene(options.scene, options.pack.dimension, report);
  if (!world) return std::nullopt;
  PackOptions pack = options.pack;
  if (pack.dimension.empty()) pack.dimension = world->environment.dimension;
  const MacroDefinitions environment = standardMacros({.versions = pack.versions});
  const auto load = makeLoadRequest(files, pack, environment, report);
  const auto cameras = load ? chooseCameras(options, *world, report) : std::vector<Camera>();
  if (cameras.empty()) return std::nullopt;
  return StudyRequest{.files = files,
                      .load = *load,
                      .versions = pack.versions,
                      .world = std::move(*world),
                      .cameras = cameras,
                      .seed = options.scene.seed,
                      .size = {options.image.width, options.image.height},
                      .packName = lastName(options.pack.path),
                      .worldName = lastName(options.scene.path),
                      .axes = options.axes,
                      .marks = options.marks,
                      .baseline = options.baseline,
                      .references = options.references,
                      .referenceFrames = options.referenceFrames,
                      .metric = findErrorMetric(options.metric),
                      .accumulate = options.accumulate,
                      .plan = options.plan,
                      .backend = options.image.backend,
                      .budget = parseBudget(options.budget)};
}

AllowedFiles filesOfStudy(const std::string& folder) {
  AllowedFiles files;
  files.folders = {folder};
  return files;
}

StudyHooks studyHooks(const StudyFiles& files, std::vector<int> keep, Report& report) {
  return {.report = [&report](Diagnostics& diagnostics) { report.add(diagnostics); },
          .beforeDriver =
              [&files, keep = std::move(keep)] {
                addReadPlace(files.folder());
                confineDrawing(keep);
              },
          .begin =
              [&report](const std::string& what, int total) {
                return [line = std::make_shared<Progress>(what, total, report.output())](int done) {
                  line->advanceTo(done);
                };
              }};
}

std::unique_ptr<Study> openStudy(const StudyOptions& options, const StudyFiles& files, std::vector<int> keep,
                                 Report& report) {
  const auto pack = openPackFiles(options.pack.path, report);
  auto request = pack ? makeStudyRequest(options, pack, report) : std::nullopt;
  if (!request) return nullptr;
  return Study::open(std::move(*request), files, studyHooks(files, std::move(keep), report));
}

}  // namespace orris
