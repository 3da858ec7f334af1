// What a chart leaves in its folder: tables, plots, the page.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include <orris/chart/page/chart_data.h>
#include <orris/chart/page/chart_text.h>
#include <orris/chart/study/study_files.h>

namespace orris {

/// Draws a script as a file with this ending, ".svg" or ".png". nullopt: there will be no such file.
using Plotter = std::function<std::optional<std::string>(const PlotScript& script, const std::string& ending)>;

/// settings.csv, passes.csv, frames.csv, and NAME.gp, NAME.svg, NAME.png of each plot, index.html. false: see
/// diagnostics.
bool writeChart(const ChartData& chart, const StudyFiles& files, const Plotter& plot, Diagnostics& diagnostics);

}  // namespace orris
