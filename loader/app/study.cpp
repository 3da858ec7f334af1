#include "app/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "app/inputs.h"
#include "app/progress.h"
#include "app/study_input.h"
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

/// Measures one study; the parts of runStudy share what is here.
class StudyRun {
 public:
  StudyRun(const StudyOptions& options, const StudyFiles& files, Report& report, int& status)
      : options_(options), files_(files), report_(report), status_(status) {}

  bool run(Study& study) {
    auto input = readStudyInput(options_, study, report_, status_);
    if (!input || !files_.create(report_, status_)) return false;
    if (const auto budget = parseBudget(options_.budget)) end_ = Measuring::Clock::now() + *budget;
    Diagnostics diagnostics;
    const auto context = gl::createContext({.backend = options_.image.backend}, diagnostics);
    report_.add(diagnostics);
    if (!context) status_ = kHostFailed;
    return context && measure(study, *input, *context);
  }

 private:
  bool measure(Study& study, const StudyInput& input, gl::Context& context) {
    study.driver = context.driver().renderer;
    const Digest digest = studyDigest(*study.files, input.world, context.driver());
    if (!drawReferences(study, input, context, digest)) return false;
    makeJobs(study, input, digest);
    const std::vector<SettingJob*> jobs = shardOf(study);
    Progress progress("measuring frames", framesLeft(jobs, options_.plan), report_.output());
    int drawn = 0;
    const MeasureHooks hooks = {
        [&](int frames) { progress.advanceTo(drawn += frames); },
        [&](const SettingJob& job) { files_.write(job.result, report_, status_); },
        [&](const SettingJob& job, const ImageF& frame, const ImageF& mean) {
          writePictures(job, frame, mean);
        }};
    Measuring measuring(context, input.world, options_.plan, hooks, end_);
    Diagnostics diagnostics;
    measuring.run(jobs, diagnostics);
    report_.add(diagnostics);
    const std::vector<std::string> errors = context.takeErrors();
    for (const std::string& message : errors) report_.error("gl-error", message);
    if (status_ == kClean) status_ = errors.empty() ? int(report_.status()) : int(kHostFailed);
    return true;
  }

  /// The references that are a setting, from the folder or drawn now; each as people see it.
  bool drawReferences(Study& study, const StudyInput& input, gl::Context& context,
                      const Digest& digest) {
    for (const Setting& setting : study.settings) {
      if (study.references.contains(setting.size)) continue;
      Setting reference = *input.reference;
      reference.size = setting.size;
      if (!drawReference(study, input, context, digest, reference)) return false;
    }
    for (const auto& [size, reference] : study.references) {
      writePicture(files_.path(referenceName(size), ".png"),
                   displayed(reference.mean, displayExposure(reference)), report_, status_);
    }
    return status_ == kClean;
  }

  bool drawReference(Study& study, const StudyInput& input, gl::Context& context,
                     const Digest& digest, const Setting& setting) {
    const SessionRequest request = requestFor(input.request, setting);
    const std::string name = referenceName(setting.size), picture = files_.path(name, ".exr");
    const std::string keyFile = files_.path(name, ".key");
    const std::string key =
        referenceKey(digest, request, options_.plan, options_.referenceFrames) + "\n";
    Diagnostics diagnostics;
    int ignored = kClean;
    if (std::filesystem::exists(keyFile) && readWholeFile(keyFile, report_, ignored) == key) {
      auto known = readReference(picture, diagnostics);
      if (known) study.references[setting.size] = std::move(*known);
      if (known) return true;
      diagnostics.clear();  // it is drawn again
    }
    Progress progress("drawing the reference",
                      options_.plan.warmUp + options_.plan.frames + options_.referenceFrames,
                      report_.output());
    const MeasureHooks hooks = {[&](int frames) {
                                  for (int i = 0; i < frames; ++i) progress.advance();
                                },
                                {},
                                {}};
    Measuring measuring(context, input.world, options_.plan, hooks, end_);
    auto drawn = measuring.drawReference(request, options_.referenceFrames, diagnostics);
    const bool good = drawn && writeReference(picture, *drawn, diagnostics) &&
                      writeWholeFile(keyFile, key, report_, status_);
    report_.add(diagnostics);
    if (!drawn) reportNoReference();
    if (good) study.references[setting.size] = std::move(*drawn);
    return good;
  }

  void reportNoReference() {
    if (report_.status() != kClean) {
      status_ = kProblems;
      return;
    }
    report_.error("budget-short", "the budget ended before the reference was drawn",
                  "give more time, or fewer --reference-frames");
    status_ = kUsage;
  }

  void makeJobs(Study& study, const StudyInput& input, const Digest& digest) {
    for (const Setting& setting : study.settings) {
      SettingJob& job = study.jobs.emplace_back();
      job.request = requestFor(input.request, setting);
      job.reference = &study.references.at(setting.size);
      job.exposure = displayExposure(*job.reference);
      job.result = files_.read(setting.label, settingKey(digest, job, options_.plan), report_);
    }
    study.again.request = study.jobs.front().request;
    study.again.result = files_.read(study.settings.front().label + kAgain,
                                     settingKey(digest, study.again, options_.plan), report_);
  }

  /// The baseline, then every n-th setting from the i-th on, then the baseline again.
  std::vector<SettingJob*> shardOf(Study& study) const {
    const Shard shard = parseShard(options_.shard).value_or(Shard{1, 1});
    std::vector<SettingJob*> jobs = {&study.jobs.front()};
    for (std::size_t i = 1; i < study.jobs.size(); ++i)
      if (int(i % std::size_t(shard.second)) == shard.first % shard.second)
        jobs.push_back(&study.jobs[i]);
    jobs.push_back(&study.again);
    return jobs;
  }

  void writePictures(const SettingJob& job, const ImageF& frame, const ImageF& mean) {
    const auto path = [&](const char* ending) {
      return files_.settingPath(job.result.label, ending);
    };
    writePicture(path(".png"), displayed(frame, job.exposure), report_, status_);
    writePicture(path(".mean.png"), displayed(mean, job.exposure), report_, status_);
    writePicture(path(".error.png"), signedDifference(mean, job.reference->mean), report_, status_);
  }

  const StudyOptions& options_;
  const StudyFiles& files_;
  Report& report_;
  int& status_;
  std::optional<Measuring::Clock::time_point> end_;
};

}  // namespace

std::size_t Study::measured(const MeasurePlan& plan) const {
  return std::size_t(std::count_if(jobs.begin(), jobs.end(),
                                   [&](const SettingJob& job) { return job.done(plan); }));
}

ChartData Study::chart(const StudyOptions& options) const {
  ChartRequest request;
  const auto name = [](const std::string& path) {
    return std::filesystem::absolute(path).lexically_normal().filename().string();
  };
  request.title = fmt::format("{} on {}, camera {}", name(options.pack.path),
                              name(options.scene.path), camera.name);
  request.metric = findErrorMetric(options.metric);
  request.accumulated = options.accumulate;
  request.marks = marks;
  request.again = &again.result;
  for (const auto& [size, reference] : references)
    request.noiseFloor = std::max(request.noiseFloor, noiseFloor(reference));
  request.facts = {{"driver", driver},
                   {"frames before the first that counts", std::to_string(options.plan.warmUp)},
                   {"frames whose error is measured", std::to_string(options.plan.frames)},
                   {"frames a visit, two visits a pair", std::to_string(options.plan.visit)}};
  std::vector<const SettingResult*> results;
  for (const SettingJob& job : jobs) results.push_back(&job.result);
  return makeChart(std::move(request), settings, results);
}

std::unique_ptr<Study> runStudy(const StudyOptions& options, const StudyFiles& files,
                                Report& report, int& status) {
  auto study = std::make_unique<Study>();
  return StudyRun(options, files, report, status).run(*study) ? std::move(study) : nullptr;
}

}  // namespace orris
