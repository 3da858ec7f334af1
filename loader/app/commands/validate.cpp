// orris validate: checks packs without a world.
#include <CLI/CLI.hpp>
#include <memory>
#include <optional>

#include "app/commands/commands.h"
#include "app/commands/explain.h"
#include "app/input/folder_config.h"
#include "app/output/progress.h"
#include "app/output/report_output.h"
#include "app/validate/validate_flags.h"
#include <orris/core/files/pack_search.h>
#include <orris/validate/result_cache.h>
#include <orris/validate/validate_pack.h>

namespace orris {
namespace {

int runExplain(const ValidateFlags& flags) {
  ReportOutput output(flags.report, flags.output);
  if (!output.open()) return kUsage;
  ProblemList problems;
  output.add(explainGameLog(flags.paths.front(), flags, problems), problems);
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

ValidateOptions optionsOf(const ValidateFlags& flags) {
  ValidateOptions options = flags.validate;
  options.target = findTarget(flags.target);
  options.drawTime = parseBudget(flags.frameTime).value_or(kDrawTime);
  options.matrix = matrixRequest(flags.matrix);
  options.matrixTime = matrixTime(flags.matrix);
  options.judge = flags.report.judge;
  if (flags.noCache) options.cache.clear();
  return options;
}

/// Shows how far each option matrix is.
class MatrixProgress {
 public:
  explicit MatrixProgress(const OutputOptions& output) : output_(output) {}
  void show(std::size_t done, std::size_t total) {
    if (!progress_ || done == 1) progress_.emplace("option matrix", int(total), output_);
    progress_->advance();
  }
  void end() { progress_.reset(); }

 private:
  const OutputOptions& output_;
  std::optional<Progress> progress_;
};

int runValidate(const ValidateFlags& flags) {
  ReportOutput output(flags.report, flags.output);
  if (!output.open()) return kUsage;
  const std::vector<std::string> paths = flags.recursive ? packsBelow(flags.paths) : flags.paths;
  MatrixProgress progress(flags.output);
  ValidateOptions options = optionsOf(flags);
  options.progress = [&](std::size_t done, std::size_t total) { progress.show(done, total); };
  Diagnostics diagnostics;
  auto checker = makeChecker(options, paths.size(), diagnostics);
  Report report(flags.output);
  report.add(diagnostics);
  if (!checker) return report.status();
  const ResultCache cache(options.cache);
  for (const std::string& path : paths) {
    // A list of its own for each pack: equal messages of two packs are two problems.
    ProblemList problems;
    PackVerdict verdict = validatePath(path, options, cache, *checker, problems);
    progress.end();
    output.add(std::move(verdict), problems);
  }
  return output.finish();
}

}  // namespace

void addValidateCommand(CLI::App& app, int& status, const FolderConfig& folder) {
  const auto flags = std::make_shared<ValidateFlags>();
  ValidateOptions& options = flags->validate;
  CLI::App* command = app.add_subcommand("validate", "check shader packs without a world");
  command->add_option("pack", flags->paths, "shader packs: folders or .zip files")
      ->type_name("PACK")
      ->required();
  addPackFlags(*command, options.pack);
  addVersionRangeFlags(*command, options.versions);
  command->add_option("--profiles", options.profiles, "check these profiles: all, or NAME,...")
      ->delimiter(',')
      ->allow_extra_args(false);
  command->add_option("--dimensions", options.dimensions, "check these folders: all, or NAME,...")
      ->delimiter(',')
      ->allow_extra_args(false);
  command->add_flag("--recursive", flags->recursive, "check every pack below the folders named");
  command->add_flag("--draw", options.draw,
                    "compile and link with the GL driver too, and draw one frame");
  addTimeFlag(*command, "--frame-limit", flags->frameTime,
              "give the frame of --draw up after this processor time, 20s or 5m");
  addBackendFlag(*command, options.backend);
  command->add_option("--patched", options.patched,
                      "write the sources as the driver gets them, and where each line is from");
  command
      ->add_option("--cache", options.cache,
                   "keep results in this folder, and take those of packs that did not change")
      ->type_name("DIR")
      ->envname("ORRIS_CACHE");
  command->add_flag("--no-cache", flags->noCache, "check everything, and keep no result");
  command->add_option("--jobs", options.jobs, "processes")->check(CLI::Range(1, 256));
  std::vector<std::string> targets;
  for (const TargetLimits& target : targetTable()) targets.emplace_back(target.name);
  command->add_option("--target", flags->target, "whose rules, limits and macros: iris, apple, ...")
      ->check(CLI::IsMember(targets));
  CLI::Option* log = command->add_option("--explain-log", flags->explainLog,
                                         "put the compiler messages of a game log (- for standard "
                                         "input) at the pack's lines, instead of checking");
  log->type_name("FILE");
  command
      ->add_option("--patched-shaders", flags->patchedShaders,
                   "the folder patched_shaders that Iris wrote in debug mode")
      ->type_name("DIR")
      ->needs(log);
  command->add_option("--stage", flags->stage, "what a bare driver log is about: composite.fsh")
      ->type_name("NAME")
      ->needs(log);
  addMatrixFlags(*command, flags->matrix);
  addReportFlags(*command, flags->report);
  addOutputFlags(*command, flags->output);
  command->callback([flags, &status, &folder] {
    flags->report.silencedUnasked = folder.silenced;
    settleReportFlags(flags->report, flags->output.json);
    status = flags->explainLog.empty() ? runValidate(*flags) : runExplain(*flags);
  });
}

}  // namespace orris
