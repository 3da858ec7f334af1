#include <fmt/format.h>

#include <orris/chart/page/chart_text.h>

namespace orris {
namespace {

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

std::string settingRow(const ChartPoint& point, int accumulated) {
  const ErrorSummary& error = *point.result->error;
  const AccumulatedError& after = error.after(accumulated);
  const Estimate& time = point.milliseconds;
  std::string row = fmt::format(
      "{},{}x{},{},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{}",
      quoted(point.setting->label), point.setting->size.width, point.setting->size.height,
      point.cost.pairs, time.value, time.interval.low, time.interval.high, point.cost.ratio,
      point.cost.ratioInterval.low, point.cost.ratioInterval.high, point.cost.median, point.p95,
      point.publishedRatio ? fmt::format("{}", *point.publishedRatio) : "");
  row +=
      fmt::format(",{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{},{:.6g},{:.6g},{:.6g}", error.frames,
                  error.bias, error.biasInterval.low, error.biasInterval.high, error.signedBias,
                  error.noise, after.frames, after.error, after.interval.low, after.interval.high);
  return row + fmt::format(",{:.6g},{:.6g},{:.6g},{:.6g},{},{},{}\n", error.relMse,
                           error.relMseMedian, error.relMseTrimmed, point.result->ssim,
                           error.notFinite, int(point.front), int(point.published));
}

}  // namespace

std::string settingsCsv(const ChartData& chart) {
  std::string text =
      "setting,size,pairs,ms,ms_low,ms_high,ratio,ratio_low,ratio_high,ms_median,ms_p95,"
      "published_ratio,frames,bias,bias_low,bias_high,signed_bias,noise,accumulated,error,"
      "error_low,error_high,relmse,relmse_median,relmse_trimmed,ssim,not_finite,front,published\n";
  for (const ChartPoint& point : chart.points) text += settingRow(point, chart.request.accumulated);
  return text;
}

std::string passesCsv(const ChartData& chart) {
  std::string text = "setting,pass,ms\n";
  for (const ChartPoint& point : chart.points) {
    for (const auto& [name, milliseconds] : point.passes)
      text +=
          fmt::format("{},{},{:.4f}\n", quoted(point.setting->label), quoted(name), milliseconds);
  }
  return text;
}

std::string accumulatedCsv(const ChartData& chart) {
  std::string text = "setting,frames,error,error_low,error_high\n";
  for (const ChartPoint& point : chart.points) {
    for (const AccumulatedError& run : point.result->error->accumulated)
      text += fmt::format("{},{},{:.6g},{:.6g},{:.6g}\n", quoted(point.setting->label), run.frames,
                          run.error, run.interval.low, run.interval.high);
  }
  return text;
}

std::string summaryTable(const ChartData& chart) {
  std::size_t width = 7;
  for (const ChartPoint& point : chart.points) width = std::max(width, point.setting->label.size());
  std::string text =
      fmt::format("{:<{}} {:>9} {:>7} {:>17} {:>9} {:>8} {:>8} {:>8} {:>7}\n", "setting", width,
                  "ms/frame", "ratio", "95 %", "published", "bias", "noise", "error", "SSIM");
  for (const ChartPoint& point : chart.points) {
    text += fmt::format(
        "{:<{}} {:>9.3f} {:>7.3f} {:>8.3f}-{:<8.3f} {:>9} {:>8.4f} {:>8.4f} {:>8.4f} {:>7.4f}{}\n",
        point.setting->label, width, point.milliseconds.value, point.cost.ratio,
        point.cost.ratioInterval.low, point.cost.ratioInterval.high,
        point.publishedRatio ? fmt::format("{}", *point.publishedRatio) : "-",
        point.result->error->bias, point.result->error->noise,
        point.result->error->after(chart.request.accumulated).error, point.result->ssim,
        point.front ? " *" : "");
  }
  for (const ChartPoint& point : chart.points)
    if (!point.result->chosen.empty())
      text += fmt::format("{} took {}\n", point.setting->label, point.result->chosen);
  text += "* on the Pareto front of cost and " + std::string(chart.request.metric->label) + "\n";
  if (chart.again) {
    text += fmt::format("A/A: {:.4f} [{:.4f}, {:.4f}] of {} pairs\n", chart.again->ratio,
                        chart.again->ratioInterval.low, chart.again->ratioInterval.high,
                        chart.again->pairs);
  }
  return text +
         fmt::format("noise floor of the reference: {:.3g} %\n", 100 * chart.request.noiseFloor);
}

}  // namespace orris
