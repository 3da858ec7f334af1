// Where the reports of `orris validate` go: standard output, standard error and files.
#pragma once

#include "app/output/report.h"
#include "app/output/report_options.h"
#include <orris/report/report_format.h>

namespace orris {

class ReportOutput {
 public:
  ReportOutput(const ReportOptions& options, const OutputOptions& output)
      : options_(options), output_(output) {}

  /// Reads the baseline and sees that each file can be written; else reports and returns false.
  bool open();
  /// Judges one pack and prints its messages. Call after each, so that long work shows them.
  void add(PackVerdict verdict, const ProblemList& problems);
  /// Prints and writes what the flags ask for; the exit status of the run.
  int finish();

 private:
  bool readBaseline(Report& report);
  void sayWhatFolderSilenced() const;

  const ReportOptions& options_;
  const OutputOptions& output_;
  ValidateResult result_;
};

}  // namespace orris
