#include "app/study/gnuplot.h"

#include <fmt/format.h>

#include "app/output/child_process.h"

namespace orris {
namespace {

constexpr std::chrono::seconds kLongestPlot{60};
constexpr const char* kSvg = "set terminal svg size 1000,600 font 'sans-serif,12' background rgb 'white'\n";
constexpr const char* kPng = "set terminal pngcairo size 1000,600 font 'sans,10'\n";

void warn(Report& report, std::string id, std::string message, std::string hint) {
  report.add({.severity = Severity::Warning,
              .id = std::move(id),
              .message = std::move(message),
              .hint = std::move(hint)});
}

}  // namespace

Plotter gnuplot(Report& report) {
  return [&report](const PlotScript& script, const std::string& ending) -> std::optional<std::string> {
    const char* terminal = ending == ".svg" ? kSvg : kPng;
    const auto result = runChild({"gnuplot", "-d", "-"}, terminal + script.text, kLongestPlot);
    if (result && result->succeeded()) return result->output;
    if (!result || result->missing)
      warn(report, "gnuplot-missing", "the program gnuplot cannot be run: no plots are drawn",
           "install gnuplot-nox");
    else
      warn(report, "gnuplot-failed",
           fmt::format("gnuplot did not draw {}{}: {}", script.name, ending,
                       result->exitStatus ? result->errors : "it was stopped"),
           "");
    return std::nullopt;
  };
}

bool writeChart(const ChartData& chart, const StudyFiles& files, Report& report) {
  Diagnostics diagnostics;
  const bool written = writeChart(chart, files, gnuplot(report), diagnostics);
  report.add(diagnostics);
  return written;
}

}  // namespace orris
