#include <orris/chart/study/study.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include <orris/chart/measure/combine.h>
#include <orris/chart/measure/display.h>
#include <orris/chart/measure/measure.h>
#include <orris/chart/study/study_key.h>
#include <orris/core/files/named_file.h>
#include <orris/image/image.h>
#include <orris/pack/files/text.h>

namespace orris {
namespace {

constexpr const char* kAgain = " (again)";

}  // namespace

std::unique_ptr<Study> Study::open(StudyRequest request, const StudyFiles& files,
                                   StudyHooks hooks) {
  std::unique_ptr<Study> study(new Study(files, std::move(hooks)));
  return study->prepare(std::move(request)) ? std::move(study) : nullptr;
}

bool Study::prepare(StudyRequest request) {
  Diagnostics diagnostics;
  auto input = readStudyInput(std::move(request), diagnostics);
  if (input && files_.create(diagnostics)) {
    input_ = std::move(*input);
    if (input_.asked.budget) end_ = Measuring::Clock::now() + *input_.asked.budget;
    if (hooks_.beforeDriver) hooks_.beforeDriver();
    context_ = gl::createContext({.backend = input_.asked.backend}, diagnostics);
  }
  hooks_.report(diagnostics);
  if (!context_) return false;
  digest_ = studyDigest(*input_.asked.files, input_.asked.world, context_->driver());
  if (!drawReferences()) return false;
  makeJobs();
  return true;
}

std::function<void(int)> Study::begin(const std::string& what, int total) const {
  return hooks_.begin ? hooks_.begin(what, total) : [](int) {};
}

bool Study::timeLeft() const { return !end_ || Measuring::Clock::now() < *end_; }

void Study::measure(const std::vector<std::size_t>& indices) {
  for (std::size_t camera = 0; camera < input_.asked.cameras.size(); ++camera) {
    std::vector<SettingJob*> jobs = {&job(0, camera)};
    for (const std::size_t index : indices)
      if (index != 0) jobs.push_back(&job(index, camera));
    if (camera == 0) jobs.push_back(&again_);
    measure(jobs);
  }
  Diagnostics diagnostics;
  for (const std::string& message : context_->takeErrors())
    diagnostics.push_back({.id = "gl-error", .message = message});
  hooks_.report(diagnostics);
}

void Study::measure(const std::vector<SettingJob*>& jobs) {
  const auto progress = begin("measuring frames", framesLeft(jobs, input_.asked.plan));
  int drawn = 0;
  const MeasureHooks hooks = {[&](int frames) { progress(drawn += frames); },
                              [&](const SettingJob& job) {
                                Diagnostics diagnostics;
                                files_.write(job.result, diagnostics);
                                hooks_.report(diagnostics);
                              },
                              [&](const SettingJob& job, const ImageF& frame, const ImageF& mean) {
                                writePictures(job, frame, mean);
                              }};
  Measuring measuring(*context_, input_.asked.world, input_.asked.plan, hooks, end_);
  Diagnostics diagnostics;
  measuring.run(jobs, diagnostics);
  hooks_.report(diagnostics);
}

std::string Study::referenceName(const View& view) const {
  const std::string name = fmt::format("reference-{}x{}", view.size.width, view.size.height);
  return view.camera == 0
             ? name
             : fmt::format("{}-{}", name, fileStem(input_.asked.cameras[view.camera].name));
}

/// The first camera's files bear the setting's name alone.
std::string Study::jobLabel(const Setting& setting, std::size_t camera) const {
  return camera == 0 ? setting.label
                     : fmt::format("{} from {}", setting.label, input_.asked.cameras[camera].name);
}

SessionRequest Study::request(const Setting& setting, std::size_t camera) const {
  SessionRequest request = requestFor(input_.session, setting);
  request.camera = input_.asked.cameras[camera];
  return request;
}

/// The references that are a setting, from the folder or drawn now; each as people see it.
bool Study::drawReferences() {
  for (const Setting& setting : settings()) {
    for (std::size_t camera = 0; camera < input_.asked.cameras.size(); ++camera) {
      const View view{camera, setting.size};
      if (input_.references.contains(view)) continue;
      auto drawn = reference(view);
      if (!drawn) return false;
      input_.references[view] = std::move(*drawn);
    }
  }
  Diagnostics unwritten;
  for (const auto& [view, reference] : input_.references) {
    writeImage(files_.path(referenceName(view), ".png"),
               displayed(reference.mean, displayExposure(reference)), unwritten);
  }
  const bool written = unwritten.empty();
  hooks_.report(unwritten);
  return written;
}

std::optional<ReferencePicture> Study::reference(const View& view) {
  Setting setting = *input_.reference;
  setting.size = view.size;
  const SessionRequest wanted = request(setting, view.camera);
  const std::string name = referenceName(view), picture = files_.path(name, ".exr");
  const std::string keyFile = files_.path(name, ".key");
  const std::string key =
      referenceKey(digest_, wanted, input_.asked.plan, input_.asked.referenceFrames) + "\n";
  Diagnostics unread;  // it is drawn again
  if (std::filesystem::exists(keyFile) && readNamedFile(keyFile, unread) == key) {
    if (auto known = readReference(picture, unread)) return known;
  }
  auto drawn = drawReference(wanted);
  Diagnostics diagnostics;
  const bool written = drawn && writeReference(picture, *drawn, diagnostics) &&
                       writeNamedFile(keyFile, key, diagnostics);
  hooks_.report(diagnostics);
  return written ? std::move(drawn) : std::nullopt;
}

std::optional<ReferencePicture> Study::drawReference(const SessionRequest& request) {
  const MeasurePlan& plan = input_.asked.plan;
  const int total = input_.asked.referenceFrames;
  const auto progress = begin("drawing the reference", plan.warmUp + plan.frames + total);
  int frames = 0;
  const MeasureHooks hooks = {[&](int drawn) { progress(frames += drawn); }, {}, {}};
  Measuring measuring(*context_, input_.asked.world, plan, hooks, end_);
  Diagnostics diagnostics;
  auto drawn = measuring.drawReference(request, total, diagnostics);
  if (!drawn && !hasErrors(diagnostics))
    diagnostics.push_back({.id = "budget-short",
                           .message = "the budget ended before the reference was drawn",
                           .hint = "give more time, or fewer --reference-frames"});
  hooks_.report(diagnostics);
  return drawn;
}

void Study::makeJobs() {
  for (const Setting& setting : settings())
    for (std::size_t camera = 0; camera < input_.asked.cameras.size(); ++camera)
      makeJob(setting, camera);
  again_.request = jobs_.front().request;
  Diagnostics diagnostics;
  again_.result = files_.read(settings().front().label + kAgain,
                              settingKey(digest_, again_, input_.asked.plan), diagnostics);
  hooks_.report(diagnostics);
}

void Study::makeJob(const Setting& setting, std::size_t camera) {
  SettingJob& job = jobs_.emplace_back();
  job.request = request(setting, camera);
  job.reference = &referenceOf(setting, camera);
  job.exposure = displayExposure(*job.reference);
  Diagnostics diagnostics;
  job.result = files_.read(jobLabel(setting, camera), settingKey(digest_, job, input_.asked.plan),
                           diagnostics);
  hooks_.report(diagnostics);
}

void Study::writePictures(const SettingJob& job, const ImageF& frame, const ImageF& mean) {
  const auto path = [&](const char* ending) {
    return files_.settingPath(job.result.label, ending);
  };
  Diagnostics diagnostics;
  writeImage(path(".png"), displayed(frame, job.exposure), diagnostics);
  writeImage(path(".mean.png"), displayed(mean, job.exposure), diagnostics);
  writeImage(path(".error.png"), signedDifference(mean, job.reference->mean), diagnostics);
  hooks_.report(diagnostics);
}

std::size_t Study::measured() const {
  const std::size_t cameras = input_.asked.cameras.size();
  std::size_t count = 0;
  for (auto first = jobs_.begin(); first != jobs_.end(); first += std::ptrdiff_t(cameras)) {
    count += std::size_t(std::all_of(first, first + std::ptrdiff_t(cameras),
                                     [&](const auto& job) { return job.done(input_.asked.plan); }));
  }
  return count;
}

ChartData Study::chart() {
  ChartRequest request;
  std::vector<std::string> names;
  for (const Camera& camera : input_.asked.cameras) names.push_back(camera.name);
  request.title =
      fmt::format("{} on {}, camera{} {}", input_.asked.packName, input_.asked.worldName,
                  names.size() > 1 ? "s" : "", joinNames(names));
  request.metric = input_.asked.metric;
  request.accumulated = input_.asked.accumulate;
  request.marks = input_.marks;
  request.again = &again_.result;
  for (const auto& [view, reference] : input_.references)
    request.noiseFloor = std::max(request.noiseFloor, noiseFloor(reference));
  const MeasurePlan& plan = input_.asked.plan;
  request.facts = {
      {"driver", context_->driver().renderer},
      {"clock", plan.clock == FrameClock::Wall ? "passing time" : "processor time of all threads"},
      {"frames before the first that counts", std::to_string(plan.warmUp)},
      {"frames whose error is measured", std::to_string(plan.frames)},
      {"frames a visit, two visits a pair", std::to_string(plan.visit)}};
  combined_.clear();
  for (std::size_t setting = 0; setting < settings().size(); ++setting) {
    std::vector<const SettingResult*> cameras;
    for (std::size_t camera = 0; camera < input_.asked.cameras.size(); ++camera)
      cameras.push_back(&job(setting, camera).result);
    combined_.push_back(combine(cameras));
  }
  std::vector<const SettingResult*> results;
  for (const SettingResult& result : combined_) results.push_back(&result);
  return makeChart(std::move(request), settings(), results);
}

}  // namespace orris
