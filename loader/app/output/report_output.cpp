#include "app/output/report_output.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <map>

#include "app/input/folder_config.h"
#include "app/input/inputs.h"

namespace orris {

bool ReportOutput::readBaseline(Report& report) {
  if (options_.baseline.empty()) return true;
  const auto text = readWholeFile(options_.baseline, report);
  if (!text) return false;
  Diagnostics diagnostics;
  result_.baseline = Baseline::parse(options_.baseline, *text, diagnostics);
  report.add(diagnostics);
  return result_.baseline.has_value();
}

bool ReportOutput::open() {
  result_.strict = options_.judge.strict;
  result_.verbose = output_.verbose;
  Report report(output_);
  for (const ReportFile& file : options_.files) checkWritable(file.path, report);
  if (!options_.writeBaseline.empty()) checkWritable(options_.writeBaseline, report);
  return readBaseline(report) && report.status() == kClean;
}

void ReportOutput::add(PackVerdict verdict, const ProblemList& problems) {
  addPack(result_, std::move(verdict), problems, options_.judge);
  const PackResult& pack = result_.packs.back();
  std::cerr << messagesOf(pack, output_, options_.judge.strict, styleOf(STDERR_FILENO)) << std::flush;
  if (options_.format == "text") printText(summaryOf(pack));
}

// A stranger's file was read unasked: what it kept from the report is said whatever the flags.
void ReportOutput::sayWhatFolderSilenced() const {
  std::map<std::string, int> counts;
  for (const PackResult& pack : result_.packs) {
    for (const Finding& finding : pack.findings) {
      const std::string& id = finding.diagnostic.id;
      if (finding.milder && options_.silencedUnasked.contains(id)) ++counts[id];
    }
  }
  std::string list;
  for (const auto& [id, count] : counts)
    list += fmt::format("{}{} {}", list.empty() ? "" : ", ", count, id);
  if (!list.empty())
    std::cerr << fmt::format("{}: turned off or lowered: {}\n", kFolderConfig, list);
}

int ReportOutput::finish() {
  sayWhatFolderSilenced();
  if (options_.format != "text") {
    std::cout << findReportFormat(options_.format)->write(result_);
  } else if (result_.baseline) {
    printText(fmt::format("{}: {} known problems, {} gone\n", options_.baseline,
                          result_.baseline->taken(), result_.baseline->left()));
  }
  Report report(output_);
  for (const ReportFile& file : options_.files) {
    writeWholeFile(file.path, findReportFormat(file.format)->write(result_), report);
  }
  if (!options_.writeBaseline.empty()) {
    writeWholeFile(options_.writeBaseline, baselineOf(result_), report);
  }
  return std::max<int>(result_.status, report.status());
}

}  // namespace orris
