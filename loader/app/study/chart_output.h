// What `orris chart` leaves in its folder: tables, plots, the page.
#pragma once

#include "app/output/report.h"
#include <orris/chart/page/chart_data.h>
#include <orris/chart/study/study_files.h>

namespace orris {

/// settings.csv, passes.csv, frames.csv, and NAME.gp, NAME.svg, NAME.png of each plot, index.html. A
/// missing gnuplot is a warning, and leaves out the plots. false: reported.
bool writeChart(const ChartData& chart, const StudyFiles& files, Report& report);

}  // namespace orris
