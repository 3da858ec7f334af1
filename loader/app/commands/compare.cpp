// orris compare: how far one picture is from another.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands/commands.h"
#include "app/output/report.h"
#include <orris/image/image.h>
#include <orris/image/image_compare.h>
#include <orris/image/mask_compare.h>

namespace orris {
namespace {

struct CompareOptions {
  std::string image, reference, differencePath;
  float gain = 8;
  float threshold = 1.0f / 255;
  std::optional<double> limits[5];
  bool mask = false;
  std::optional<double> maxEdge, maxInterior;
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

/// Counts as a share of all pixels, since sizes differ.
void checkMaskLimits(const MaskDifference& difference, const CompareOptions& options,
                     Report& report) {
  const auto check = [&](const char* name, long long count, const std::optional<double>& limit,
                         const char* flag) {
    const double share = difference.pixels == 0 ? 0 : double(count) / double(difference.pixels);
    if (limit && share > *limit)
      report.error("limit-exceeded",
                   fmt::format("{} is {:.6g}, {} allows {:.6g}", name, share, flag, *limit));
  };
  check("edge", difference.edge, options.maxEdge, "--max-edge");
  check("interior", difference.interior, options.maxInterior, "--max-interior");
}

int runMasks(const CompareOptions& options, const ImageF& image, const ImageF& reference,
             Report& report) {
  Diagnostics diagnostics;
  const auto difference = compareMasks(image, reference, diagnostics);
  if (difference && !options.differencePath.empty() &&
      !writeImage(options.differencePath, maskDifferenceImage(image, reference), diagnostics)) {
    report.add(diagnostics);
    return kUsage;
  }
  report.add(diagnostics);
  if (!difference) return kProblems;
  checkMaskLimits(*difference, options, report);
  if (!options.output.json)
    std::cout << fmt::format("{:<14} {}\n{:<14} {}\n{:<14} {:.6g}\n{:<14} {}\n", "pixels",
                             difference->pixels, "edge", difference->edge, "edgeShare",
                             difference->edgeShare(), "interior", difference->interior);
  printJson({{"image", options.image},
             {"reference", options.reference},
             {"pixels", difference->pixels},
             {"lit", difference->lit},
             {"edge", difference->edge},
             {"edgeShare", difference->edgeShare()},
             {"interior", difference->interior}},
            report);
  sayWritten(options.output, {options.differencePath});
  return report.status();
}

int runCompare(const CompareOptions& options) {
  Report report(options.output);
  Diagnostics diagnostics;
  const std::optional<ImageF> image = readImage(options.image, diagnostics);
  const std::optional<ImageF> reference = readImage(options.reference, diagnostics);
  report.add(diagnostics);
  if (!image || !reference) return kUsage;
  if (options.mask) return runMasks(options, *image, *reference, report);

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
  sayWritten(options.output, {options.differencePath});
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
  command->add_flag("--mask", options->mask,
                    "compare masks of shadows: wrong pixels on edges of B and inside");
  command
      ->add_option("--max-edge", options->maxEdge, "with --mask: fail when more pixels are wrong")
      ->needs("--mask");
  command
      ->add_option("--max-interior", options->maxInterior,
                   "with --mask: fail when more pixels inside are wrong")
      ->needs("--mask");
  addOutputFlags(*command, options->output);
  command->callback([options, &status] { status = runCompare(*options); });
}

}  // namespace orris
