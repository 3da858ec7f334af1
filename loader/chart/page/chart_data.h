// All that a chart shows, as numbers: what the CSV, the plots and the page are written from.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <orris/chart/measure/setting.h>
#include <orris/chart/measure/setting_result.h>

namespace orris {

struct Estimate {
  double value = 0;
  Interval interval;
};

/// What the error axis shows.
struct ErrorMetric {
  const char* name;   ///< as --metric takes it
  const char* label;  ///< of the axis
  Estimate (*of)(const SettingResult& result, int accumulated);
};
const std::vector<ErrorMetric>& errorMetrics();
const ErrorMetric* findErrorMetric(const std::string& name);

/// A setting that somebody has published numbers of.
struct PublishedMark {
  Setting setting;              ///< marks all settings that include it
  std::optional<double> ratio;  ///< published cost over the baseline's
};

struct ChartPoint {
  const Setting* setting = nullptr;
  const SettingResult* result = nullptr;
  PairedCost cost;
  Estimate milliseconds;  ///< a frame: ratio * the baseline's
  double p95 = 0;         ///< milliseconds of a slow frame
  Estimate error;
  std::vector<std::pair<std::string, double>> passes;  ///< milliseconds a frame, in frame order
  bool front = false, published = false;
  std::optional<double> publishedRatio;
};

struct ChartRequest {
  std::string title;
  std::vector<std::pair<std::string, std::string>> facts;  ///< machine, camera, ...: name, text
  const ErrorMetric* metric = nullptr;
  int accumulated = 1;  ///< frames that the metric averages
  std::vector<PublishedMark> marks;
  double noiseFloor = 0;                 ///< of the worst reference
  const SettingResult* again = nullptr;  ///< the baseline measured a second time; nullptr: not yet
};

struct ChartData {
  ChartRequest request;
  std::vector<ChartPoint> points;  ///< those measured, in the order of the settings; baseline first
  std::optional<PairedCost> again;  ///< A/A: must be 1 within its interval
};

/// Points of those settings whose error and cost are both known. `settings` and `results` belong
/// together and must outlive it; the first is the baseline.
ChartData makeChart(ChartRequest request, const std::vector<Setting>& settings,
                    const std::vector<const SettingResult*>& results);

}  // namespace orris
