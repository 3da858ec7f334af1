// A chart as tables and as scripts for gnuplot.
#pragma once

#include <string>
#include <vector>

#include <orris/chart/page/chart_data.h>

namespace orris {

/// One row a setting: cost, error, their intervals, bias and noise apart.
std::string settingsCsv(const ChartData& chart);
/// One row a setting and pass.
std::string passesCsv(const ChartData& chart);
/// One row a setting and number of frames averaged.
std::string accumulatedCsv(const ChartData& chart);
/// One line a setting, for people.
std::string summaryTable(const ChartData& chart);

/// A script that draws on gnuplot's standard output once a terminal is set. Names from packs are
/// reduced to letters that mean nothing to gnuplot.
struct PlotScript {
  std::string name;  ///< "cost-error"
  std::string text;
};
std::vector<PlotScript> plotScripts(const ChartData& chart);

}  // namespace orris
