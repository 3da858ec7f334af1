#include "app/lsp/check_work.h"

#include <nlohmann/json.hpp>
#include <utility>

#include <orris/report/diagnostic_json.h>
#include <orris/report/findings.h>
#include <orris/validate/edited_check.h>
#include <orris/validate/validate_pack.h>

namespace orris {
namespace {

using nlohmann::json;

// A pack whose edits bring ever new texts: those of long ago are forgotten.
constexpr std::size_t kMostQuiet = 20000;

json findingJson(const Finding& finding) {
  const Diagnostic& d = finding.diagnostic;
  json value = toJson(Diagnostics{d}).front();
  value["uri"] = finding.uri;
  value["programs"] = finding.programs;
  value["follows"] = finding.follows.size();
  if (d.repair)
    value["repair"] = {{"file", d.repair->file},
                       {"line", d.repair->line},
                       {"text", d.repair->text},
                       {"replaces", d.repair->replaces}};
  return value;
}

json findingsJson(PackVerdict verdict, const ProblemList& problems) {
  json list = json::array();
  const PackResult result = judgePack(std::move(verdict), problems, {}, nullptr);
  // Notes are what `validate` prints only with --verbose.
  for (const Finding& finding : result.findings)
    if (finding.silence == Silence::None && finding.diagnostic.severity != Severity::Note)
      list.push_back(findingJson(finding));
  return list;
}

Verdicts verdictsOf(const std::set<std::uint64_t>& quiet) {
  Verdicts verdicts;
  for (const std::uint64_t hash : quiet) verdicts[hash] = true;
  return verdicts;
}

}  // namespace

void checkForEditor(const std::string& path, const ValidateOptions& options, const CheckJob& job,
                    CheckMemory& memory, const std::function<void(json)>& say) {
  ProblemList problems;
  Diagnostics diagnostics;
  const std::shared_ptr<const FileSource> opened = openPack(path, diagnostics);
  problems.add(diagnostics);
  if (!opened) return say({{"part", "whole"}, {"findings", findingsJson({.path = path}, problems)}});
  const auto files = overlaidSource(opened, job.overlay);
  if (memory.quiet.size() > kMostQuiet) memory.quiet.clear();
  Checker checker{.jobs = options.jobs, .target = *options.target,
                  .budget = MatrixBudget(std::nullopt, 1), .glslang = verdictsOf(memory.quiet),
                  .quiet = &memory.quiet, .folders = std::move(memory.folders)};
  if (!job.changed.empty()) {
    ProblemList first;
    const std::set<std::string> stages = compileEdited(files, job.changed, options, checker, first);
    if (!stages.empty())
      say({{"part", "programs"},
           {"entries", stages},
           {"findings", findingsJson({.path = path, .files = files}, first)}});
  }
  // What was found of some programs is found again, with the rest; what was not is known by now.
  checker.glslang = verdictsOf(memory.quiet);
  PackVerdict verdict = validateFiles(path, files, options, checker, problems);
  say({{"part", "whole"}, {"findings", findingsJson(std::move(verdict), problems)}});
  memory.folders = std::move(checker.folders);
}

}  // namespace orris
