// A chart as tables and as scripts for gnuplot.
#pragma once

#include <string>
#include <vector>

#include <orris/chart/page/chart_data.h>

namespace orris {

/// One row a setting: cost, error, their intervals, bias and noise apart.
std::string settingsCsv(const ChartData& chart);
/// Rows of cells.
using TextTable = std::vector<std::vector<std::string>>;
/// Headings, then one row a setting, for people: the page and summaryTable().
TextTable settingsTable(const ChartData& chart);
/// One row a setting and pass.
std::string passesCsv(const ChartData& chart);
/// One row a setting and number of frames averaged.
std::string accumulatedCsv(const ChartData& chart);
/// settingsTable() in columns, and what is known of the measurement.
std::string summaryTable(const ChartData& chart);

/// A script that draws on gnuplot's standard output once a terminal is set. Names from packs are
/// reduced to letters that mean nothing to gnuplot.
struct PlotScript {
  std::string name;  ///< "cost-error"
  std::string text;
};
std::vector<PlotScript> plotScripts(const ChartData& chart);

}  // namespace orris
