#include "app/report/report_output.h"

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
  int status = kClean;
  const auto text = readWholeFile(options_.baseline, report, status);
  if (!text) return false;
  Diagnostics diagnostics;
  result_.baseline = Baseline::parse(options_.baseline, *text, diagnostics);
  report.add(diagnostics);
  return result_.baseline.has_value();
}

bool ReportOutput::open() {
  result_.strict = options_.strict;
  result_.verbose = output_.verbose;
  Report report(output_);
  int status = kClean;
  for (const ReportFile& file : options_.files) checkWritable(file.path, report, status);
  if (!options_.writeBaseline.empty()) checkWritable(options_.writeBaseline, report, status);
  return readBaseline(report) && status == kClean;
}

void ReportOutput::add(PackVerdict verdict, const Report& report) {
  Baseline* baseline = result_.baseline ? &*result_.baseline : nullptr;
  result_.packs.push_back(judgePack(std::move(verdict), report, options_, baseline));
  const PackResult& pack = result_.packs.back();
  std::cerr << messagesOf(pack, output_, options_.strict, styleOf(STDERR_FILENO)) << std::flush;
  if (options_.format == "text") printText(summaryOf(pack));
  result_.status = std::max(result_.status, pack.verdict.status);
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
  int status = kClean;
  for (const ReportFile& file : options_.files) {
    writeWholeFile(file.path, findReportFormat(file.format)->write(result_), report, status);
  }
  if (!options_.writeBaseline.empty()) {
    writeWholeFile(options_.writeBaseline, baselineText(), report, status);
  }
  return std::max(result_.status, status);
}

// Notes are not printed as a rule, so they need not be known either.
std::string ReportOutput::baselineText() const {
  Diagnostics problems;
  for (const PackResult& pack : result_.packs) {
    for (const Finding& finding : pack.findings) {
      const bool known = finding.silence == Silence::None || finding.silence == Silence::Baseline;
      if (known && finding.diagnostic.severity != Severity::Note) {
        problems.push_back(finding.diagnostic);
      }
      for (const Finding& other : finding.follows) {
        if (other.diagnostic.severity != Severity::Note) problems.push_back(other.diagnostic);
      }
    }
  }
  return formatBaseline(problems);
}

}  // namespace orris
