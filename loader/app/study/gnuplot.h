// Plots of a chart by gnuplot, where it is installed.
#pragma once

#include "app/output/report.h"
#include <orris/chart/page/chart_files.h>

namespace orris {

/// Warns where gnuplot is missing or fails. `report` must outlive it.
Plotter gnuplot(Report& report);

/// writeChart() with it. false: reported.
bool writeChart(const ChartData& chart, const StudyFiles& files, Report& report);

}  // namespace orris
