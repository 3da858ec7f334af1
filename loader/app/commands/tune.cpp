// orris tune: the options that a scene needs, and no more.
#include <orris/chart/study/tune.h>

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands/commands.h"
#include "app/input/common.h"
#include "app/input/inputs.h"
#include "app/study/open_study.h"
#include "app/study/plot_process.h"

namespace orris {
namespace {

struct TuneOptions {
  StudyOptions study;
  std::string settings;  ///< the option file to write
  std::optional<double> error, milliseconds;
};

std::string folderOf(const TuneOptions& options) {
  return options.study.folder.empty() ? options.settings + ".tune" : options.study.folder;
}

TuneGoal goalOf(const TuneOptions& options) {
  return {options.error, options.milliseconds.value_or(0)};
}

const ChartPoint* pointOf(const ChartData& chart, const Setting& setting) {
  for (const ChartPoint& point : chart.points)
    if (point.setting == &setting) return &point;
  return nullptr;
}

std::string numbersOf(const ChartPoint& point) {
  const std::string& chosen = point.result->chosen;
  return fmt::format("{}{:.3f} ms [{:.3f}, {:.3f}], error {:.4g} [{:.4g}, {:.4g}]",
                     chosen.empty() ? "" : "took " + chosen + ", ", point.milliseconds.value,
                     point.milliseconds.interval.low, point.milliseconds.interval.high,
                     point.error.value, point.error.interval.low, point.error.interval.high);
}

/// Why not this one?
std::string verdict(const ChartPoint& point, const ChartPoint& chosen, const TuneGoal& goal) {
  const CostError own{point.milliseconds.value, point.error.value};
  if (!goal.reachedBy(own)) return goal.error ? "too wrong" : "too slow";
  return goal.error ? fmt::format("{:.2f} times the cost", own.cost / chosen.milliseconds.value)
                    : fmt::format("{:.2f} times the error", own.error / chosen.error.value);
}

/// The chosen setting, those that differ from it in one axis, and the rest of the front.
std::string explanation(const ChartData& chart, const ChartPoint& chosen, const TuneGoal& goal) {
  std::string text = fmt::format("{}: {}\n", chosen.setting->label, numbersOf(chosen));
  text += goal.error ? fmt::format("the cheapest found with an error of at most {}\n", *goal.error)
                     : fmt::format("the most accurate found in {} ms a frame\n", goal.milliseconds);
  for (const ChartPoint& point : chart.points) {
    if (&point == &chosen) continue;
    const bool near = differences(*point.setting, *chosen.setting) == 1;
    if (!near && !point.front) continue;
    text += fmt::format("  {}: {}; {}\n", point.setting->label, numbersOf(point),
                        verdict(point, chosen, goal));
  }
  return text;
}

/// All values in force, as the game's option file holds them.
bool writeSettings(const Study& study, const Setting& setting, const std::string& path,
                   Report& report) {
  LoadRequest load = requestFor(study.input().session, setting).load;
  load.buildSources = false;
  const auto pack = loadPack(study.input().asked.files, load, report);
  return pack && writeWholeFile(path, writeOptionFile(pack->options, pack->values), report);
}

void reportOutOfReach(const Study& study, const Tuned& found, const TuneGoal& goal,
                      Report& report) {
  std::string hint = "no setting could be measured";
  if (const auto nearest = nearestTo(found.tried, goal)) {
    const Setting& setting = study.settings()[*nearest];
    hint =
        fmt::format("nearest is {}: {}", setting.label, numbersOf(*pointOf(found.chart, setting)));
  }
  report.error("tune-out-of-reach",
               goal.error
                   ? fmt::format("no setting tried has an error of at most {}", *goal.error)
                   : fmt::format("no setting tried takes at most {} ms a frame", goal.milliseconds),
               hint);
}

void noteBudget(const Tuned& found, Report& report) {
  if (found.ended) return;
  report.add({.severity = Severity::Warning,
              .id = "study-unfinished",
              .message = "the budget ended the search",
              .hint = "run the same command again to go on"});
}

int runTune(const TuneOptions& options, Report& report, nlohmann::json& result) {
  if (!checkWritable(options.settings, report)) return report.status();
  const StudyFiles files(folderOf(options));
  PlotProcess plots;
  const auto study = openStudy(options.study, files, {plots.socket()}, report);
  if (!study) return report.status();
  const TuneGoal goal = goalOf(options);
  const Tuned found = tune(*study, goal);
  if (!writeChart(found.chart, files, plots, report)) return report.status();
  noteBudget(found, report);
  const auto best = bestOf(found.tried, goal);
  if (!best) {
    reportOutOfReach(*study, found, goal, report);
    return report.status();
  }
  const Setting& setting = study->settings()[*best];
  const ChartPoint& chosen = *pointOf(found.chart, setting);
  if (!writeSettings(*study, setting, options.settings, report)) return report.status();
  result = {{"setting", setting.label},
            {"profile", setting.profile},
            {"values", setting.values},
            {"size", {setting.size.width, setting.size.height}},
            {"milliseconds", chosen.milliseconds.value},
            {"error", chosen.error.value},
            {"tried", found.chart.points.size()},
            {"settings", study->settings().size()}};
  if (!options.study.output.json && !options.study.output.quiet)
    printText(explanation(found.chart, chosen, goal));
  sayWritten(options.study.output, {options.settings});
  return report.status();
}

}  // namespace

void addTuneCommand(CLI::App& app, int& status) {
  const auto options = std::make_shared<TuneOptions>();
  CLI::App* command = app.add_subcommand(
      "tune", "the cheapest options within an error, or the most accurate within a time");
  addPackArgument(*command, options->study.pack.path);
  addWorldArgument(*command, options->study.scene.path);
  command->add_option("-o,--output", options->settings, "option file to write, for --settings")
      ->type_name("FILE")
      ->required();
  CLI::Option_group* goal = command->add_option_group("goal");
  goal->add_option("--error", options->error, "the cheapest with at most this error")
      ->check(checkPositive);
  goal->add_option("--ms", options->milliseconds, "the most accurate in at most this time a frame")
      ->check(checkPositive);
  goal->require_option(1);
  command
      ->add_option("--folder", options->study.folder,
                   "for the measurements and their chart; default FILE.tune")
      ->type_name("DIR");
  addStudyFlags(*command, options->study);
  command->callback([options, &status] {
    if (options->study.axes.empty()) options->study.axes = {kProfileAxis};
    Report report(options->study.output);
    nlohmann::json result = nlohmann::json::object();
    const StudyOptions& study = options->study;
    AllowedFiles files = filesOfStudy(folderOf(*options));
    files.outputs = {options->settings};
    const SupervisedWork supervised = {.limits = study.limits,
                                       .backend = study.image.backend,
                                       .pack = study.pack.path,
                                       .files = std::move(files),
                                       .confined = true};
    status = runSupervised(supervised, report, [&] { return runTune(*options, report, result); });
    result["status"] = status;
    printJson(std::move(result), report);
  });
}

}  // namespace orris
