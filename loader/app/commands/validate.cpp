// orris validate: checks packs without a world.
#include <CLI/CLI.hpp>
#include <memory>

#include "app/commands/commands.h"
#include "app/commands/explain.h"
#include "app/input/folder_config.h"
#include "app/report/report_output.h"
#include "app/validate/result_cache.h"
#include "app/validate/validate_run.h"
#include "core/pack_search.h"

namespace orris {
namespace {

int runExplain(const ValidateOptions& options) {
  ReportOutput output(options.report, options.output);
  if (!output.open()) return kUsage;
  Report report(options.output, Report::Mode::Keep);
  output.add(explainGameLog(options.paths.front(), options, report), report);
  return output.finish();
}

/// The packs below each path; a path that holds none stays, to be reported.
std::vector<std::string> packsBelow(const std::vector<std::string>& paths) {
  std::vector<std::string> packs;
  for (const std::string& path : paths) {
    std::vector<std::string> found = findPacks(path);
    if (found.empty()) found.push_back(path);
    packs.insert(packs.end(), found.begin(), found.end());
  }
  return packs;
}

int runValidate(const ValidateOptions& options) {
  ReportOutput output(options.report, options.output);
  if (!output.open()) return kUsage;
  const std::vector<std::string> paths =
      options.recursive ? packsBelow(options.paths) : options.paths;
  Checker checker{.jobs = options.jobs,
                  .target = *findTarget(options.target),
                  .backend = options.backend,
                  .budget = MatrixBudget(matrixTime(options.matrix), paths.size())};
  checker.drawTime = parseBudget(options.frameTime).value_or(kDrawTime);
  if (options.draw && !findDriver(options, checker)) return kHostFailed;
  const ResultCache cache(options.noCache ? "" : options.cache);
  for (const std::string& path : paths) {
    // A report of its own for each pack: equal messages of two packs are two problems.
    Report report(options.output, Report::Mode::Keep);
    PackVerdict verdict = validatePack(path, options, cache, checker, report);
    output.add(std::move(verdict), report);
  }
  return output.finish();
}

}  // namespace

void addValidateCommand(CLI::App& app, int& status, const FolderConfig& folder) {
  const auto options = std::make_shared<ValidateOptions>();
  CLI::App* command = app.add_subcommand("validate", "check shader packs without a world");
  command->add_option("pack", options->paths, "shader packs: folders or .zip files")
      ->type_name("PACK")
      ->required();
  addPackFlags(*command, options->pack);
  addVersionRangeFlags(*command, options->versions);
  command->add_option("--profiles", options->profiles, "check these profiles: all, or NAME,...")
      ->delimiter(',')
      ->allow_extra_args(false);
  command->add_option("--dimensions", options->dimensions, "check these folders: all, or NAME,...")
      ->delimiter(',')
      ->allow_extra_args(false);
  command->add_flag("--recursive", options->recursive, "check every pack below the folders named");
  command->add_flag("--draw", options->draw,
                    "compile and link with the GL driver too, and draw one frame");
  addTimeFlag(*command, "--frame-limit", options->frameTime,
              "give the frame of --draw up after this processor time, 20s or 5m");
  addBackendFlag(*command, options->backend);
  command->add_option("--patched", options->patched,
                      "write the sources as the driver gets them, and where each line is from");
  command
      ->add_option("--cache", options->cache,
                   "keep results in this folder, and take those of packs that did not change")
      ->type_name("DIR")
      ->envname("ORRIS_CACHE");
  command->add_flag("--no-cache", options->noCache, "check everything, and keep no result");
  command->add_option("--jobs", options->jobs, "processes")->check(CLI::Range(1, 256));
  std::vector<std::string> targets;
  for (const TargetLimits& target : targetTable()) targets.emplace_back(target.name);
  command->add_option("--target", options->target, "whose rules, limits and macros: iris, apple, ...")
      ->check(CLI::IsMember(targets));
  CLI::Option* log = command->add_option("--explain-log", options->explainLog,
                                         "put the compiler messages of a game log (- for standard "
                                         "input) at the pack's lines, instead of checking");
  log->type_name("FILE");
  command
      ->add_option("--patched-shaders", options->patchedShaders,
                   "the folder patched_shaders that Iris wrote in debug mode")
      ->type_name("DIR")
      ->needs(log);
  command->add_option("--stage", options->stage, "what a bare driver log is about: composite.fsh")
      ->type_name("NAME")
      ->needs(log);
  addMatrixFlags(*command, options->matrix);
  addReportFlags(*command, options->report);
  addOutputFlags(*command, options->output);
  command->callback([options, &status, &folder] {
    options->report.silencedUnasked = folder.silenced;
    settleReportFlags(options->report, options->output.json);
    status = options->explainLog.empty() ? runValidate(*options) : runExplain(*options);
  });
}

}  // namespace orris
