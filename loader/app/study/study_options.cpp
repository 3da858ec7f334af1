#include "app/study/study_options.h"

#include <CLI/CLI.hpp>

#include <orris/chart/page/chart_data.h>

namespace orris {
namespace {

void addReferenceFlags(CLI::App& command, StudyOptions& options) {
  command
      .add_option("--reference", options.references,
                  "what errors are measured against: a picture of orris trace, one for each size "
                  "(and camera: CAMERA=FILE), or a setting NAME=VALUE,...")
      ->type_name("FILE|SETTING")
      ->allow_extra_args(false);
  command
      .add_option("--reference-frames", options.referenceFrames,
                  "frames averaged for a reference that is a setting")
      ->capture_default_str()
      ->check(CLI::Range(2, 1000000));
  command.add_option("--buffer", options.plan.buffer,
                     "compare this buffer (colortex0), as it is, instead of the screen");
}

void addPlanFlags(CLI::App& command, MeasurePlan& plan) {
  command.add_option("--warm-up", plan.warmUp, "frames drawn before the first that counts")
      ->capture_default_str()
      ->check(CLI::Range(0, 1000000));
  command.add_option("--frames", plan.frames, "frames whose error is measured")
      ->capture_default_str()
      ->check(CLI::Range(2, 1000000));
  command.add_option("--rounds", plan.rounds, "pairs of times for each setting")
      ->capture_default_str()
      ->check(CLI::Range(1, 100000));
  command.add_option("--visit", plan.visit, "frames in a row, twice a round")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  command
      .add_option_function<std::string>(
          "--clock",
          [&plan](const std::string& name) {
            plan.clock = name == "cpu" ? FrameClock::Processor : FrameClock::Wall;
          },
          "what times frames: wall, or cpu, for software rasterisers on busy machines")
      ->check(CLI::IsMember({"wall", "cpu"}));
  command.add_option("--alive", plan.alive, "settings kept loaded at the same time")
      ->capture_default_str()
      ->check(CLI::Range(1, 512));
}

void addMetricFlags(CLI::App& command, StudyOptions& options) {
  std::vector<std::string> names;
  for (const ErrorMetric& metric : errorMetrics()) names.emplace_back(metric.name);
  command.add_option("--metric", options.metric, "what counts as the error")
      ->capture_default_str()
      ->check(CLI::IsMember(names));
  command
      .add_option("--accumulate", options.accumulate,
                  "average so many frames before their error is taken")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000000));
}

}  // namespace

void addStudyFlags(CLI::App& command, StudyOptions& options) {
  addSceneFlags(command, options.scene);
  command
      .add_option("--axis", options.axes,
                  "what is varied: an option, profile or size, all values or NAME=A,B,...")
      ->type_name("NAME[=A,B,...]")
      ->allow_extra_args(false);
  command
      .add_option("--cameras", options.cameras,
                  "cameras of the world that are judged together, or all: NAME,...")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->excludes("--camera");
  command
      .add_option("--baseline", options.baseline,
                  "the setting that costs are given as multiples of; default the first")
      ->type_name("NAME=VALUE,...");
  addReferenceFlags(command, options);
  addMetricFlags(command, options);
  addPlanFlags(command, options.plan);
  addBudgetFlag(command, options.budget, "end after this time, 90s or 10m; the next run goes on");
  addPackFlags(command, options.pack);
  addVersionFlags(command, options.pack.versions);
  addSizeFlag(command, options.image);
  addBackendFlag(command, options.image.backend);
  addLimitFlags(command, options.limits);
  addOutputFlags(command, options.output);
}

}  // namespace orris
