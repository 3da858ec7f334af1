// Plots of a chart by gnuplot, where it is installed.
#pragma once

#include <sys/types.h>

#include "app/output/report.h"
#include <orris/chart/page/chart_files.h>

namespace orris {

/// Runs gnuplot for a process that will be shut in and may then start no program: make it before. A driver that
/// was taken over could ask for any script, and scripts may start programs, so that gnuplot is shut in, too.
class PlotProcess {
 public:
  PlotProcess();
  ~PlotProcess();
  PlotProcess(const PlotProcess&) = delete;
  PlotProcess& operator=(const PlotProcess&) = delete;

  /// By which it is asked: the only open file that has to stay.
  int socket() const { return socket_; }
  /// Warns where gnuplot is missing or fails. Both must outlive it.
  Plotter plotter(Report& report) const;

 private:
  int socket_ = -1;
  pid_t process_ = -1;
};

/// writeChart() with it. false: reported.
bool writeChart(const ChartData& chart, const StudyFiles& files, const PlotProcess& plots, Report& report);

}  // namespace orris
