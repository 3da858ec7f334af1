#include "app/study/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/input/inputs.h"
#include "app/report/progress.h"
#include "chart/measure/combine.h"
#include "chart/measure/display.h"
#include "chart/measure/measure.h"
#include "chart/study/study_key.h"
#include "pack/files/text.h"

namespace orris {
namespace {

constexpr const char* kAgain = " (again)";

bool writeStudyPicture(const std::string& path, const Image8& image, Report& report) {
  Diagnostics diagnostics;
  const bool written = writeImage(path, image, diagnostics);
  report.add(diagnostics);
  return written;
}

std::string lastName(const std::string& path) {
  return std::filesystem::weakly_canonical(path).filename().string();
}

}  // namespace

std::unique_ptr<Study> Study::open(const StudyOptions& options, const StudyFiles& files,
                                   Report& report) {
  std::unique_ptr<Study> study(new Study(options, files, report));
  return study->prepare() ? std::move(study) : nullptr;
}

bool Study::prepare() {
  auto input = readStudyInput(options_, report_);
  if (!input || !files_.create(report_)) return false;
  input_ = std::move(*input);
  if (const auto budget = parseBudget(options_.budget)) end_ = Measuring::Clock::now() + *budget;
  Diagnostics diagnostics;
  context_ = gl::createContext({.backend = options_.image.backend}, diagnostics);
  report_.add(diagnostics);
  if (!context_) return false;
  digest_ = studyDigest(*input_.files, input_.world, context_->driver());
  if (!drawReferences()) return false;
  makeJobs();
  return true;
}

bool Study::timeLeft() const { return !end_ || Measuring::Clock::now() < *end_; }

void Study::measure(const std::vector<std::size_t>& indices) {
  for (std::size_t camera = 0; camera < input_.cameras.size(); ++camera) {
    std::vector<SettingJob*> jobs = {&job(0, camera)};
    for (const std::size_t index : indices)
      if (index != 0) jobs.push_back(&job(index, camera));
    if (camera == 0) jobs.push_back(&again_);
    measure(jobs);
  }
  const std::vector<std::string> errors = context_->takeErrors();
  for (const std::string& message : errors) report_.error("gl-error", message);
}

void Study::measure(const std::vector<SettingJob*>& jobs) {
  Progress progress("measuring frames", framesLeft(jobs, options_.plan), report_.output());
  int drawn = 0;
  const MeasureHooks hooks = {
      [&](int frames) { progress.advanceTo(drawn += frames); },
      [&](const SettingJob& job) { files_.write(job.result, report_); },
      [&](const SettingJob& job, const ImageF& frame, const ImageF& mean) {
        writePictures(job, frame, mean);
      }};
  Measuring measuring(*context_, input_.world, options_.plan, hooks, end_);
  Diagnostics diagnostics;
  measuring.run(jobs, diagnostics);
  report_.add(diagnostics);
}

std::string Study::referenceName(const View& view) const {
  const std::string name = fmt::format("reference-{}x{}", view.size.width, view.size.height);
  return view.camera == 0 ? name
                          : fmt::format("{}-{}", name, fileStem(input_.cameras[view.camera].name));
}

/// The first camera's files bear the setting's name alone.
std::string Study::jobLabel(const Setting& setting, std::size_t camera) const {
  return camera == 0 ? setting.label
                     : fmt::format("{} from {}", setting.label, input_.cameras[camera].name);
}

SessionRequest Study::request(const Setting& setting, std::size_t camera) const {
  SessionRequest request = requestFor(input_.request, setting);
  request.camera = input_.cameras[camera];
  return request;
}

/// The references that are a setting, from the folder or drawn now; each as people see it.
bool Study::drawReferences() {
  for (const Setting& setting : settings()) {
    for (std::size_t camera = 0; camera < input_.cameras.size(); ++camera) {
      const View view{camera, setting.size};
      if (input_.references.contains(view)) continue;
      auto drawn = reference(view);
      if (!drawn) return false;
      input_.references[view] = std::move(*drawn);
    }
  }
  bool written = true;
  for (const auto& [view, reference] : input_.references) {
    written &= writeStudyPicture(files_.path(referenceName(view), ".png"),
                      displayed(reference.mean, displayExposure(reference)), report_);
  }
  return written;
}

std::optional<ReferencePicture> Study::reference(const View& view) {
  Setting setting = *input_.reference;
  setting.size = view.size;
  const SessionRequest wanted = request(setting, view.camera);
  const std::string name = referenceName(view), picture = files_.path(name, ".exr");
  const std::string keyFile = files_.path(name, ".key");
  const std::string key =
      referenceKey(digest_, wanted, options_.plan, options_.referenceFrames) + "\n";
  if (std::filesystem::exists(keyFile) && readWholeFile(keyFile, report_) == key) {
    Diagnostics unread;  // it is drawn again
    if (auto known = readReference(picture, unread)) return known;
  }
  auto drawn = drawReference(wanted);
  Diagnostics diagnostics;
  const bool written = drawn && writeReference(picture, *drawn, diagnostics);
  report_.add(diagnostics);
  return written && writeWholeFile(keyFile, key, report_) ? drawn : std::nullopt;
}

std::optional<ReferencePicture> Study::drawReference(const SessionRequest& request) {
  const MeasurePlan& plan = options_.plan;
  Progress progress("drawing the reference", plan.warmUp + plan.frames + options_.referenceFrames,
                    report_.output());
  int frames = 0;
  const MeasureHooks hooks = {[&](int drawn) { progress.advanceTo(frames += drawn); }, {}, {}};
  Measuring measuring(*context_, input_.world, plan, hooks, end_);
  Diagnostics diagnostics;
  auto drawn = measuring.drawReference(request, options_.referenceFrames, diagnostics);
  report_.add(diagnostics);
  if (drawn) return drawn;
  if (report_.status() == kClean)
    report_.error("budget-short", "the budget ended before the reference was drawn",
                  "give more time, or fewer --reference-frames");
  return std::nullopt;
}

void Study::makeJobs() {
  for (const Setting& setting : settings())
    for (std::size_t camera = 0; camera < input_.cameras.size(); ++camera) makeJob(setting, camera);
  again_.request = jobs_.front().request;
  again_.result = files_.read(settings().front().label + kAgain,
                              settingKey(digest_, again_, options_.plan), report_);
}

void Study::makeJob(const Setting& setting, std::size_t camera) {
  SettingJob& job = jobs_.emplace_back();
  job.request = request(setting, camera);
  job.reference = &referenceOf(setting, camera);
  job.exposure = displayExposure(*job.reference);
  job.result =
      files_.read(jobLabel(setting, camera), settingKey(digest_, job, options_.plan), report_);
}

void Study::writePictures(const SettingJob& job, const ImageF& frame, const ImageF& mean) {
  const auto path = [&](const char* ending) {
    return files_.settingPath(job.result.label, ending);
  };
  writeStudyPicture(path(".png"), displayed(frame, job.exposure), report_);
  writeStudyPicture(path(".mean.png"), displayed(mean, job.exposure), report_);
  writeStudyPicture(path(".error.png"), signedDifference(mean, job.reference->mean), report_);
}

std::size_t Study::measured() const {
  const std::size_t cameras = input_.cameras.size();
  std::size_t count = 0;
  for (auto first = jobs_.begin(); first != jobs_.end(); first += std::ptrdiff_t(cameras)) {
    count += std::size_t(std::all_of(first, first + std::ptrdiff_t(cameras),
                                     [&](const auto& job) { return job.done(options_.plan); }));
  }
  return count;
}

ChartData Study::chart() {
  ChartRequest request;
  std::vector<std::string> names;
  for (const Camera& camera : input_.cameras) names.push_back(camera.name);
  request.title =
      fmt::format("{} on {}, camera{} {}", lastName(options_.pack.path),
                  lastName(options_.scene.path), names.size() > 1 ? "s" : "", joinNames(names));
  request.metric = findErrorMetric(options_.metric);
  request.accumulated = options_.accumulate;
  request.marks = input_.marks;
  request.again = &again_.result;
  for (const auto& [view, reference] : input_.references)
    request.noiseFloor = std::max(request.noiseFloor, noiseFloor(reference));
  const MeasurePlan& plan = options_.plan;
  request.facts = {
      {"driver", context_->driver().renderer},
      {"clock", plan.clock == FrameClock::Wall ? "passing time" : "processor time of all threads"},
      {"frames before the first that counts", std::to_string(plan.warmUp)},
      {"frames whose error is measured", std::to_string(plan.frames)},
      {"frames a visit, two visits a pair", std::to_string(plan.visit)}};
  combined_.clear();
  for (std::size_t setting = 0; setting < settings().size(); ++setting) {
    std::vector<const SettingResult*> cameras;
    for (std::size_t camera = 0; camera < input_.cameras.size(); ++camera)
      cameras.push_back(&job(setting, camera).result);
    combined_.push_back(combine(cameras));
  }
  std::vector<const SettingResult*> results;
  for (const SettingResult& result : combined_) results.push_back(&result);
  return makeChart(std::move(request), settings(), results);
}

}  // namespace orris
