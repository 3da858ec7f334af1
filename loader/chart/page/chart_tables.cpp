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

std::string places4(double value) { return fmt::format("{:.4f}", value); }
std::string digits6(double value) { return fmt::format("{:.6g}", value); }
std::string flag(bool value) { return value ? "1" : "0"; }

/// A measured setting with what its columns ask for.
struct SettingRow {
  const ChartPoint& point;
  const SettingResult& result;
  const ErrorSummary& error;
  const AccumulatedError& after;
};

struct SettingColumn {
  const char* name;
  std::string (*text)(const SettingRow& row);
};

/// Of settings.csv, in its order.
constexpr SettingColumn kSettingColumns[] = {
    {"setting", [](const SettingRow& row) { return quoted(row.point.setting->label); }},
    {"size", [](const SettingRow& row) {
       const ImageSize& size = row.point.setting->size;
       return fmt::format("{}x{}", size.width, size.height);
     }},
    {"pairs", [](const SettingRow& row) { return std::to_string(row.point.cost.pairs); }},
    {"ms", [](const SettingRow& row) { return places4(row.point.milliseconds.value); }},
    {"ms_low", [](const SettingRow& row) { return places4(row.point.milliseconds.interval.low); }},
    {"ms_high", [](const SettingRow& row) { return places4(row.point.milliseconds.interval.high); }},
    {"ratio", [](const SettingRow& row) { return places4(row.point.cost.ratio); }},
    {"ratio_low", [](const SettingRow& row) { return places4(row.point.cost.ratioInterval.low); }},
    {"ratio_high", [](const SettingRow& row) { return places4(row.point.cost.ratioInterval.high); }},
    {"ms_median", [](const SettingRow& row) { return places4(row.point.cost.median); }},
    {"ms_p95", [](const SettingRow& row) { return places4(row.point.p95); }},
    {"published_ratio", [](const SettingRow& row) {
       return row.point.publishedRatio ? fmt::format("{}", *row.point.publishedRatio) : std::string();
     }},
    {"frames", [](const SettingRow& row) { return std::to_string(row.error.frames); }},
    {"bias", [](const SettingRow& row) { return digits6(row.error.bias); }},
    {"bias_low", [](const SettingRow& row) { return digits6(row.error.biasInterval.low); }},
    {"bias_high", [](const SettingRow& row) { return digits6(row.error.biasInterval.high); }},
    {"signed_bias", [](const SettingRow& row) { return digits6(row.error.signedBias); }},
    {"noise", [](const SettingRow& row) { return digits6(row.error.noise); }},
    {"accumulated", [](const SettingRow& row) { return std::to_string(row.after.frames); }},
    {"error", [](const SettingRow& row) { return digits6(row.after.error); }},
    {"error_low", [](const SettingRow& row) { return digits6(row.after.interval.low); }},
    {"error_high", [](const SettingRow& row) { return digits6(row.after.interval.high); }},
    {"relmse", [](const SettingRow& row) { return digits6(row.error.relMse); }},
    {"relmse_median", [](const SettingRow& row) { return digits6(row.error.relMseMedian); }},
    {"relmse_trimmed", [](const SettingRow& row) { return digits6(row.error.relMseTrimmed); }},
    {"ssim", [](const SettingRow& row) { return digits6(row.result.ssim); }},
    {"not_finite", [](const SettingRow& row) { return std::to_string(row.error.notFinite); }},
    {"front", [](const SettingRow& row) { return flag(row.point.front); }},
    {"published", [](const SettingRow& row) { return flag(row.point.published); }},
};

/// A line of the table: what `cell` says of each column.
template <class Cell>
std::string lineOf(Cell cell) {
  std::string line;
  for (const SettingColumn& column : kSettingColumns) line += (line.empty() ? "" : ",") + cell(column);
  return line + "\n";
}

}  // namespace

std::string settingsCsv(const ChartData& chart) {
  std::string text = lineOf([](const SettingColumn& column) { return std::string(column.name); });
  for (const ChartPoint& point : chart.points) {
    const ErrorSummary& error = *point.result->error;
    const SettingRow row{point, *point.result, error, error.after(chart.request.accumulated)};
    text += lineOf([&row](const SettingColumn& column) { return column.text(row); });
  }
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
