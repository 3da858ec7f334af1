// orris validate: checks packs without a world.
#include <CLI/CLI.hpp>
#include <memory>

#include "app/commands.h"
#include "app/report_output.h"
#include "app/validate_run.h"

namespace orris {
namespace {

int runValidate(const ValidateOptions& options) {
  ReportOutput output(options.report, options.output);
  if (!output.open()) return kUsage;
  Checker checker{.jobs = options.jobs, .target = *findTarget(options.target)};
  if (options.draw && !openContext(options, checker)) return kHostFailed;
  for (const std::string& path : options.paths) {
    // A report of its own for each pack: equal messages of two packs are two problems.
    Report report(options.output, Report::Mode::Keep);
    PackVerdict verdict = validatePack(path, options, checker, report);
    output.add(std::move(verdict), report);
  }
  return output.finish();
}

}  // namespace

void addValidateCommand(CLI::App& app, int& status) {
  const auto options = std::make_shared<ValidateOptions>();
  CLI::App* command = app.add_subcommand("validate", "check shader packs without a world");
  command->add_option("pack", options->paths, "shader packs: folders or .zip files")
      ->type_name("PACK")
      ->required();
  addPackFlags(*command, options->pack);
  command->add_option("--profiles", options->profiles, "check these profiles: all, or NAME,...")
      ->delimiter(',')
      ->allow_extra_args(false);
  command->add_option("--dimensions", options->dimensions, "check these folders: all, or NAME,...")
      ->delimiter(',')
      ->allow_extra_args(false);
  command->add_flag("--draw", options->draw,
                    "compile and link with the GL driver too, and draw one frame");
  addBackendFlag(*command, options->backend);
  command->add_option("--patched", options->patched,
                      "write the sources as the driver gets them, and where each line is from");
  command->add_option("--jobs", options->jobs, "threads")->check(CLI::Range(1, 256));
  std::vector<std::string> targets;
  for (const TargetLimits& target : targetTable()) targets.emplace_back(target.name);
  command->add_option("--target", options->target, "whose limits and macros: mesa, apple, ...")
      ->check(CLI::IsMember(targets));
  addReportFlags(*command, options->report);
  addOutputFlags(*command, options->output);
  command->callback([options, &status] {
    settleReportFlags(options->report, options->output.json);
    status = runValidate(*options);
  });
}

}  // namespace orris
