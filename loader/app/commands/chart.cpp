// orris chart: what the settings of a pack cost, and how wrong their pictures are.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands/commands.h"
#include "app/input/common.h"
#include "app/study/open_study.h"
#include "app/study/plot_process.h"
#include "app/study/scene_list.h"
#include <orris/chart/page/chart_text.h>

namespace orris {
namespace {

nlohmann::json describeChart(const ChartData& chart, const Study& study) {
  nlohmann::json points = nlohmann::json::array();
  for (const ChartPoint& point : chart.points) {
    points.push_back(
        {{"setting", point.setting->label},
         {"chosen", point.result->chosen},
         {"milliseconds", point.milliseconds.value},
         {"ratio", point.cost.ratio},
         {"ratioInterval", {point.cost.ratioInterval.low, point.cost.ratioInterval.high}},
         {"error", point.error.value},
         {"bias", point.result->error->bias},
         {"noise", point.result->error->noise},
         {"ssim", point.result->ssim},
         {"front", point.front}});
  }
  nlohmann::json result = {{"settings", study.settings().size()},
                           {"measured", study.measured()},
                           {"points", std::move(points)},
                           {"noiseFloor", chart.request.noiseFloor}};
  if (chart.again)
    result["again"] = {
        {"ratio", chart.again->ratio},
        {"interval", {chart.again->ratioInterval.low, chart.again->ratioInterval.high}}};
  return result;
}

void noteUnfinished(const Study& study, Report& report) {
  const std::size_t measured = study.measured();
  if (measured == study.settings().size() || report.status() != kClean) return;
  report.add({.severity = Severity::Warning,
              .id = "study-unfinished",
              .message = fmt::format("{} of {} settings are measured whole", measured,
                                     study.settings().size()),
              .hint = "run the same command again to go on, without --shard to see all"});
}

/// Every n-th setting from the i-th on.
std::vector<std::size_t> shardOf(std::size_t settings, const std::string& text) {
  const Shard shard = parseShard(text).value_or(Shard{1, 1});
  std::vector<std::size_t> indices;
  for (auto i = std::size_t(shard.first) - 1; i < settings; i += std::size_t(shard.second))
    indices.push_back(i);
  return indices;
}

int runChart(const StudyOptions& options, Report& report, nlohmann::json& result) {
  if (options.scenes.names.empty() == options.scene.path.empty()) {
    report.error("usage", "expected either WORLD or --scenes", "orris chart PACK WORLD -o DIR, or PACK --scenes LIST");
    return kUsage;
  }
  if (!options.scenes.names.empty()) return runScenes(options, report, result);
  const StudyFiles files(options.folder);
  PlotProcess plots;
  const auto study = openStudy(options, files, {plots.socket()}, report);
  if (!study) return report.status();
  study->measure(shardOf(study->settings().size(), options.shard));
  const ChartData chart = study->chart();
  noteUnfinished(*study, report);
  if (!writeChart(chart, files, plots, report)) return report.status();
  result = describeChart(chart, *study);
  if (!options.output.json && !options.output.quiet) printText(summaryTable(chart));
  sayWritten(options.output, {options.folder});
  return report.status();
}

void addSceneListFlags(CLI::App& command, SceneListOptions& options) {
  command
      .add_option("--scenes", options.names,
                  "instead of WORLD: judge every setting on each of these scenes against a picture traced of it: "
                  "WORLD, WORLD@CAMERA, or random:SEED:N for N rooms with seeds SEED, SEED + 2, ...")
      ->type_name("LIST")
      ->delimiter(',')
      ->allow_extra_args(false);
  command.add_option("--runs", options.runs, "of --scenes: runs with random numbers of their own")
      ->capture_default_str()
      ->check(CLI::Range(3, 1000));
  command.add_option("--trace-seconds", options.traceSeconds, "of --scenes: trace a scene for at most so long")
      ->capture_default_str()
      ->check(checkPositive);
  command.add_option("--trace-noise", options.traceNoise, "of --scenes: stop tracing at this noise")
      ->capture_default_str()
      ->check(checkPositive);
  command.add_flag("!--no-costs", options.costs, "of --scenes: measure neither costs nor lag");
}

}  // namespace

void addChartCommand(CLI::App& app, int& status) {
  const auto options = std::make_shared<StudyOptions>();
  CLI::App* command =
      app.add_subcommand("chart", "what settings cost, and how wrong their pictures are");
  addPackArgument(*command, options->pack.path);
  addWorldArgument(*command, options->scene.path)->required(false);
  addSceneListFlags(*command, options->scenes);
  command->add_option("-o,--output", options->folder, "folder for the chart and all it is made of")
      ->type_name("DIR")
      ->required();
  addStudyFlags(*command, *options);
  command
      ->add_option("--mark", options->marks,
                   "published settings, and the cost over the first setting's that was published")
      ->type_name("NAME=VALUE,...[:RATIO]")
      ->allow_extra_args(false);
  addShardFlag(*command, options->shard,
               "measure only part I of N; copy the folders' files together and run without: I/N");
  command->callback([options, &status] {
    Report report(options->output);
    nlohmann::json result = nlohmann::json::object();
    const SupervisedWork supervised = {.limits = options->limits,
                                       .backend = options->image.backend,
                                       .pack = options->pack.path,
                                       .files = filesOfStudy(options->folder),
                                       .confined = true};
    status = runSupervised(supervised, report, [&] { return runChart(*options, report, result); });
    result["status"] = status;
    printJson(std::move(result), report);
  });
}

}  // namespace orris
