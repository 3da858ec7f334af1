// orris compare: how far one picture is from another.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/report.h"
#include "image/image.h"
#include "image/image_compare.h"

namespace orris {
namespace {

struct CompareOptions {
  std::string image, reference, differencePath;
  float gain = 8;
  float threshold = 1.0f / 255;
  std::optional<double> limits[5];
  OutputOptions output;
};

/// One number of a comparison, and the flag that limits it.
struct Metric {
  const char* name;
  double ImageDifference::*value;
  const char* flag;
  bool higherIsBetter = false;
};
constexpr Metric kMetrics[] = {
    {"rmse", &ImageDifference::rmse, "--max-rmse"},
    {"relMse", &ImageDifference::relMse, "--max-relmse"},
    {"maxAbsolute", &ImageDifference::maxAbsolute, "--max-abs"},
    {"fractionAbove", &ImageDifference::fractionAbove, "--max-fraction"},
    {"ssim", &ImageDifference::ssim, "--min-ssim", true},
};

void checkLimits(const ImageDifference& difference, const CompareOptions& options, Report& report) {
  for (size_t i = 0; i < std::size(kMetrics); ++i) {
    const Metric& metric = kMetrics[i];
    const std::optional<double> limit = options.limits[i];
    const double value = difference.*metric.value;
    if (!limit || (metric.higherIsBetter ? value >= *limit : value <= *limit)) continue;
    report.error("limit-exceeded", fmt::format("{} is {:.6g}, {} allows {:.6g}", metric.name, value,
                                               metric.flag, *limit));
  }
}

void printResult(const ImageDifference& difference, const CompareOptions& options,
                 const Report& report) {
  nlohmann::json json = {
      {"image", options.image}, {"reference", options.reference}, {"threshold", options.threshold}};
  for (const Metric& metric : kMetrics) {
    json[metric.name] = difference.*metric.value;
    if (!options.output.json)
      std::cout << fmt::format("{:<14} {:.6g}\n", metric.name, difference.*metric.value);
  }
  printJson(json, report);
}

int runCompare(const CompareOptions& options) {
  Report report(options.output);
  Diagnostics diagnostics;
  const std::optional<ImageF> image = readImage(options.image, diagnostics);
  const std::optional<ImageF> reference = readImage(options.reference, diagnostics);
  report.add(diagnostics);
  if (!image || !reference) return kUsage;

  const auto difference = compareImages(*image, *reference, options.threshold, diagnostics);
  report.add(diagnostics);
  if (!difference) return kProblems;
  if (!options.differencePath.empty()) {
    const bool written = writeImage(options.differencePath,
                                    differenceImage(*image, *reference, options.gain), diagnostics);
    report.add(diagnostics);
    if (!written) return kUsage;
  }
  checkLimits(*difference, options, report);
  printResult(*difference, options, report);
  return report.status();
}

}  // namespace

void addCompareCommand(CLI::App& app, int& status) {
  const auto options = std::make_shared<CompareOptions>();
  CLI::App* command = app.add_subcommand("compare", "error metrics and a difference picture");
  command->add_option("image", options->image, "picture to judge")->type_name("A")->required();
  command->add_option("reference", options->reference, "picture to compare with")
      ->type_name("B")
      ->required();
  command->add_option("--diff", options->differencePath, "write the difference picture")
      ->type_name("OUT");
  command->add_option("--gain", options->gain, "brightness of the difference picture")
      ->capture_default_str();
  command
      ->add_option("--threshold", options->threshold, "difference that fractionAbove counts from")
      ->capture_default_str();
  for (size_t i = 0; i < std::size(kMetrics); ++i) {
    command->add_option(kMetrics[i].flag, options->limits[i],
                        fmt::format("fail when {} is {}", kMetrics[i].name,
                                    kMetrics[i].higherIsBetter ? "lower" : "higher"));
  }
  addOutputFlags(*command, options->output);
  command->callback([options, &status] { status = runCompare(*options); });
}

}  // namespace orris
