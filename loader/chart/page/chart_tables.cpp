#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

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

/// For people: "-" for what was not measured.
std::string shownPlaces(double value, int places) {
  return std::isfinite(value) ? fmt::format("{:.{}f}", value, places) : "-";
}
std::string shownRange(const Interval& interval) {
  return shownPlaces(interval.low, 3) + " to " + shownPlaces(interval.high, 3);
}

/// A measured setting with what its columns ask for.
struct SettingRow {
  const ChartPoint& point;
  const SettingResult& result;
  const ErrorSummary& error;
  const AccumulatedError& after;
};

using CellText = std::string (*)(const SettingRow& row);
struct SettingColumn {
  const char* name;  ///< in settings.csv; "": not there
  CellText text;
  const char* heading = "";  ///< on the page and the terminal; "": not there
  CellText shown = nullptr;  ///< there; none: as in settings.csv
};

/// In place of the name of the chart's metric.
constexpr const char* kMetricHeading = "metric";

/// Of the three tables of a chart, in their order.
constexpr SettingColumn kSettingColumns[] = {
    {"setting", [](const SettingRow& row) { return row.point.setting->label; }, "setting"},
    {"size", [](const SettingRow& row) {
       const ImageSize& size = row.point.setting->size;
       return fmt::format("{}x{}", size.width, size.height);
     }},
    {"pairs", [](const SettingRow& row) { return std::to_string(row.point.cost.pairs); }},
    {"ms", [](const SettingRow& row) { return places4(row.point.milliseconds.value); }, "ms a frame",
     [](const SettingRow& row) { return shownPlaces(row.point.milliseconds.value, 3); }},
    {"", [](const SettingRow& row) { return shownRange(row.point.milliseconds.interval); }, "95 % interval"},
    {"ms_low", [](const SettingRow& row) { return places4(row.point.milliseconds.interval.low); }},
    {"ms_high", [](const SettingRow& row) { return places4(row.point.milliseconds.interval.high); }},
    {"ratio", [](const SettingRow& row) { return places4(row.point.cost.ratio); }, "cost ratio",
     [](const SettingRow& row) { return shownPlaces(row.point.cost.ratio, 3); }},
    {"", [](const SettingRow& row) { return shownRange(row.point.cost.ratioInterval); }, "95 % interval"},
    {"ratio_low", [](const SettingRow& row) { return places4(row.point.cost.ratioInterval.low); }},
    {"ratio_high", [](const SettingRow& row) { return places4(row.point.cost.ratioInterval.high); }},
    {"ms_median", [](const SettingRow& row) { return places4(row.point.cost.median); }},
    {"ms_p95", [](const SettingRow& row) { return places4(row.point.p95); }, "slow frame (p95)",
     [](const SettingRow& row) { return shownPlaces(row.point.p95, 2); }},
    {"published_ratio", [](const SettingRow& row) {
       return row.point.publishedRatio ? fmt::format("{}", *row.point.publishedRatio) : std::string();
     }, "published", [](const SettingRow& row) {
       return row.point.publishedRatio ? fmt::format("{}", *row.point.publishedRatio) : std::string("-");
     }},
    {"frames", [](const SettingRow& row) { return std::to_string(row.error.frames); }},
    {"", [](const SettingRow& row) { return shownPlaces(row.point.error.value, 4); }, kMetricHeading},
    {"bias", [](const SettingRow& row) { return digits6(row.error.bias); }, "bias",
     [](const SettingRow& row) { return shownPlaces(row.error.bias, 4); }},
    {"bias_low", [](const SettingRow& row) { return digits6(row.error.biasInterval.low); }},
    {"bias_high", [](const SettingRow& row) { return digits6(row.error.biasInterval.high); }},
    {"signed_bias", [](const SettingRow& row) { return digits6(row.error.signedBias); }},
    {"noise", [](const SettingRow& row) { return digits6(row.error.noise); }, "noise",
     [](const SettingRow& row) { return shownPlaces(row.error.noise, 4); }},
    {"accumulated", [](const SettingRow& row) { return std::to_string(row.after.frames); }},
    {"error", [](const SettingRow& row) { return digits6(row.after.error); }},
    {"error_low", [](const SettingRow& row) { return digits6(row.after.interval.low); }},
    {"error_high", [](const SettingRow& row) { return digits6(row.after.interval.high); }},
    {"relmse", [](const SettingRow& row) { return digits6(row.error.relMse); }, "relMSE",
     [](const SettingRow& row) { return shownPlaces(row.error.relMse, 4); }},
    {"relmse_median", [](const SettingRow& row) { return digits6(row.error.relMseMedian); }},
    {"relmse_trimmed", [](const SettingRow& row) { return digits6(row.error.relMseTrimmed); }},
    {"ssim", [](const SettingRow& row) { return digits6(row.result.ssim); }, "SSIM",
     [](const SettingRow& row) { return shownPlaces(row.result.ssim, 4); }},
    {"not_finite", [](const SettingRow& row) { return std::to_string(row.error.notFinite); }},
    {"front", [](const SettingRow& row) { return flag(row.point.front); }},
    {"published", [](const SettingRow& row) { return flag(row.point.published); }},
};

SettingRow rowOf(const ChartPoint& point, const ChartData& chart) {
  const ErrorSummary& error = *point.result->error;
  return {point, *point.result, error, error.after(chart.request.accumulated)};
}

/// A line of settings.csv: what `cell` says of each column.
template <class Cell>
std::string lineOf(Cell cell) {
  std::string line;
  for (const SettingColumn& column : kSettingColumns)
    if (*column.name != '\0') line += (line.empty() ? "" : ",") + quoted(cell(column));
  return line + "\n";
}

}  // namespace

std::string settingsCsv(const ChartData& chart) {
  std::string text = lineOf([](const SettingColumn& column) { return std::string(column.name); });
  for (const ChartPoint& point : chart.points) {
    const SettingRow row = rowOf(point, chart);
    text += lineOf([&row](const SettingColumn& column) { return column.text(row); });
  }
  return text;
}

TextTable settingsTable(const ChartData& chart) {
  TextTable table(1);
  for (const SettingColumn& column : kSettingColumns) {
    if (*column.heading == '\0') continue;
    table[0].push_back(std::string_view(column.heading) == kMetricHeading ? chart.request.metric->label : column.heading);
  }
  for (const ChartPoint& point : chart.points) {
    const SettingRow row = rowOf(point, chart);
    std::vector<std::string>& cells = table.emplace_back();
    for (const SettingColumn& column : kSettingColumns)
      if (*column.heading != '\0') cells.push_back((column.shown ? column.shown : column.text)(row));
  }
  return table;
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
  const TextTable table = settingsTable(chart);
  std::vector<std::size_t> widths(table[0].size());
  for (const std::vector<std::string>& cells : table)
    for (std::size_t i = 0; i < cells.size(); ++i) widths[i] = std::max(widths[i], cells[i].size());
  std::string text;
  for (std::size_t line = 0; line < table.size(); ++line) {
    text += fmt::format("{:<{}}", table[line][0], widths[0]);
    for (std::size_t i = 1; i < widths.size(); ++i) text += fmt::format("  {:>{}}", table[line][i], widths[i]);
    text += line > 0 && chart.points[line - 1].front ? " *\n" : "\n";
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
