// orris chart: what the settings of a pack cost, and how wrong their pictures are.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands/commands.h"
#include "app/study/chart_output.h"
#include "app/study/study.h"
#include "chart/page/chart_text.h"

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
  Diagnostic diagnostic;
  diagnostic.severity = Severity::Warning;
  diagnostic.id = "study-unfinished";
  diagnostic.message =
      fmt::format("{} of {} settings are measured whole", measured, study.settings().size());
  diagnostic.hint = "run the same command again to go on, without --shard to see all";
  Diagnostics diagnostics = {std::move(diagnostic)};
  report.add(diagnostics);
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
  int status = kClean;
  const StudyFiles files(options.folder);
  const auto study = Study::open(options, files, report, status);
  if (!study) return status;
  study->measure(shardOf(study->settings().size(), options.shard));
  const ChartData chart = study->chart();
  noteUnfinished(*study, report);
  if (!writeChart(chart, files, report, status)) return status;
  result = describeChart(chart, *study);
  if (!options.output.json && !options.output.quiet) printText(summaryTable(chart));
  sayWritten(options.output, {options.folder});
  return status;
}

}  // namespace

void addChartCommand(CLI::App& app, int& status) {
  const auto options = std::make_shared<StudyOptions>();
  CLI::App* command =
      app.add_subcommand("chart", "what settings cost, and how wrong their pictures are");
  addPackArgument(*command, options->pack.path);
  addWorldArgument(*command, options->scene.path);
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
    status = runSupervised({.limits = options->limits, .backend = options->image.backend}, report,
                           [&] { return runChart(*options, report, result); });
    result["status"] = status;
    printJson(std::move(result), report);
  });
}

}  // namespace orris
