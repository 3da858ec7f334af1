#include "app/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/inputs.h"
#include "app/progress.h"
#include "chart/display.h"
#include "chart/measure.h"
#include "chart/study_key.h"

namespace orris {
namespace {

constexpr const char* kAgain = " (again)";

std::string referenceName(ImageSize size) {
  return fmt::format("reference-{}x{}", size.width, size.height);
}

void writePicture(const std::string& path, const Image8& image, Report& report, int& status) {
  Diagnostics diagnostics;
  if (!writeImage(path, image, diagnostics)) status = kHostFailed;
  report.add(diagnostics);
}

std::string lastName(const std::string& path) {
  return std::filesystem::weakly_canonical(path).filename().string();
}

}  // namespace

std::unique_ptr<Study> Study::open(const StudyOptions& options, const StudyFiles& files,
                                   Report& report, int& status) {
  std::unique_ptr<Study> study(new Study(options, files, report, status));
  return study->prepare() ? std::move(study) : nullptr;
}

bool Study::prepare() {
  auto input = readStudyInput(options_, report_, status_);
  if (!input || !files_.create(report_, status_)) return false;
  input_ = std::move(*input);
  if (const auto budget = parseBudget(options_.budget)) end_ = Measuring::Clock::now() + *budget;
  Diagnostics diagnostics;
  context_ = gl::createContext({.backend = options_.image.backend}, diagnostics);
  report_.add(diagnostics);
  if (!context_) status_ = kHostFailed;
  if (!context_) return false;
  digest_ = studyDigest(*input_.files, input_.world, context_->driver());
  if (!drawReferences()) return false;
  makeJobs();
  return true;
}

bool Study::timeLeft() const { return !end_ || Measuring::Clock::now() < *end_; }

void Study::measure(const std::vector<std::size_t>& indices) {
  std::vector<SettingJob*> jobs = {&jobs_.front()};
  for (const std::size_t index : indices)
    if (index != 0) jobs.push_back(&jobs_[index]);
  jobs.push_back(&again_);
  Progress progress("measuring frames", framesLeft(jobs, options_.plan), report_.output());
  int drawn = 0;
  const MeasureHooks hooks = {
      [&](int frames) { progress.advanceTo(drawn += frames); },
      [&](const SettingJob& job) { files_.write(job.result, report_, status_); },
      [&](const SettingJob& job, const ImageF& frame, const ImageF& mean) {
        writePictures(job, frame, mean);
      }};
  Measuring measuring(*context_, input_.world, options_.plan, hooks, end_);
  Diagnostics diagnostics;
  measuring.run(jobs, diagnostics);
  report_.add(diagnostics);
  const std::vector<std::string> errors = context_->takeErrors();
  for (const std::string& message : errors) report_.error("gl-error", message);
  if (status_ == kClean) status_ = errors.empty() ? int(report_.status()) : int(kHostFailed);
}

/// The references that are a setting, from the folder or drawn now; each as people see it.
bool Study::drawReferences() {
  for (const Setting& setting : settings()) {
    if (input_.references.contains(setting.size)) continue;
    auto drawn = reference(setting.size);
    if (!drawn) return false;
    input_.references[setting.size] = std::move(*drawn);
  }
  for (const auto& [size, reference] : input_.references) {
    writePicture(files_.path(referenceName(size), ".png"),
                 displayed(reference.mean, displayExposure(reference)), report_, status_);
  }
  return status_ == kClean;
}

std::optional<ReferencePicture> Study::reference(ImageSize size) {
  Setting setting = *input_.reference;
  setting.size = size;
  const SessionRequest request = requestFor(input_.request, setting);
  const std::string name = referenceName(size), picture = files_.path(name, ".exr");
  const std::string keyFile = files_.path(name, ".key");
  const std::string key =
      referenceKey(digest_, request, options_.plan, options_.referenceFrames) + "\n";
  int ignored = kClean;
  if (std::filesystem::exists(keyFile) && readWholeFile(keyFile, report_, ignored) == key) {
    Diagnostics unread;  // it is drawn again
    if (auto known = readReference(picture, unread)) return known;
  }
  auto drawn = drawReference(request);
  Diagnostics diagnostics;
  const bool written = drawn && writeReference(picture, *drawn, diagnostics);
  report_.add(diagnostics);
  if (drawn && !written) status_ = kHostFailed;
  return written && writeWholeFile(keyFile, key, report_, status_) ? drawn : std::nullopt;
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
  status_ = report_.status();
  if (status_ == kClean) {
    report_.error("budget-short", "the budget ended before the reference was drawn",
                  "give more time, or fewer --reference-frames");
    status_ = kUsage;
  }
  return std::nullopt;
}

void Study::makeJobs() {
  for (const Setting& setting : settings()) {
    SettingJob& job = jobs_.emplace_back();
    job.request = requestFor(input_.request, setting);
    job.reference = &input_.references.at(setting.size);
    job.exposure = displayExposure(*job.reference);
    job.result = files_.read(setting.label, settingKey(digest_, job, options_.plan), report_);
  }
  again_.request = jobs_.front().request;
  again_.result = files_.read(settings().front().label + kAgain,
                              settingKey(digest_, again_, options_.plan), report_);
}

void Study::writePictures(const SettingJob& job, const ImageF& frame, const ImageF& mean) {
  const auto path = [&](const char* ending) {
    return files_.settingPath(job.result.label, ending);
  };
  writePicture(path(".png"), displayed(frame, job.exposure), report_, status_);
  writePicture(path(".mean.png"), displayed(mean, job.exposure), report_, status_);
  writePicture(path(".error.png"), signedDifference(mean, job.reference->mean), report_, status_);
}

std::size_t Study::measured() const {
  return std::size_t(std::count_if(jobs_.begin(), jobs_.end(),
                                   [&](const SettingJob& job) { return job.done(options_.plan); }));
}

ChartData Study::chart() const {
  ChartRequest request;
  request.title = fmt::format("{} on {}, camera {}", lastName(options_.pack.path),
                              lastName(options_.scene.path), input_.request.camera.name);
  request.metric = findErrorMetric(options_.metric);
  request.accumulated = options_.accumulate;
  request.marks = input_.marks;
  request.again = &again_.result;
  for (const auto& [size, reference] : input_.references)
    request.noiseFloor = std::max(request.noiseFloor, noiseFloor(reference));
  const MeasurePlan& plan = options_.plan;
  request.facts = {
      {"driver", context_->driver().renderer},
      {"clock", plan.clock == FrameClock::Wall ? "passing time" : "processor time of all threads"},
      {"frames before the first that counts", std::to_string(plan.warmUp)},
      {"frames whose error is measured", std::to_string(plan.frames)},
      {"frames a visit, two visits a pair", std::to_string(plan.visit)}};
  std::vector<const SettingResult*> results;
  for (const SettingJob& job : jobs_) results.push_back(&job.result);
  return makeChart(std::move(request), settings(), results);
}

}  // namespace orris
