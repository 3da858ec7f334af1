// orris gallery: what a pack looks like and costs, as one page, beside another revision of it.
#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands/commands.h"
#include "app/gallery/gallery_run.h"

namespace orris {
namespace {

void addGalleryFlags(CLI::App& command, GalleryOptions& options) {
  command.add_option("-o,--output", options.output, "the page, a file .html; or a folder, from which a later run goes on")
      ->type_name("OUT")
      ->required();
  CLI::Option* against = command.add_option("--against", options.against, "another revision of the pack: show what changed since")
      ->type_name("PACK");
  command
      .add_option("--set-file", options.setFile,
                  "worlds, cameras, times, weathers and profiles; default gallery.json beside the pack's shaders folder, "
                  "else a set that comes with Orris")
      ->type_name("FILE");
  command
      .add_option("--profiles", options.profiles, "profiles of scenes that name none: all, or NAME,...")
      ->type_name("LIST")
      ->delimiter(',')
      ->allow_extra_args(false);
  command
      .add_option("--fail-above", options.failAbove, "end with status 1 when a picture changed by more, 0 to 2")
      ->type_name("X")
      ->check(CLI::Range(0.0, 2.0))
      ->needs(against);
  command.add_flag("--allow-missing", options.allowMissing,
                   "status 0 although this driver cannot run some programs");
}

}  // namespace

void addGalleryCommand(CLI::App& app, int& status) {
  const auto options = std::make_shared<GalleryOptions>();
  CLI::App* command = app.add_subcommand("gallery", "pictures of a pack and what changed in them, as one page");
  addPackArgument(*command, options->pack.path);
  addGalleryFlags(*command, *options);
  addPackFlags(*command, options->pack);
  addVersionFlags(*command, options->pack.versions);
  addImageFlags(*command, options->image);
  addFramesFlag(*command, options->image.frames);
  addLimitFlags(*command, options->limits);
  addBudgetFlag(*command, options->budget, "end after this time, 90s or 10m; what is not drawn then is a gap");
  addShardFlag(*command, options->shard, "draw only part I of N; copy the folders' files together and run without: I/N");
  addOutputFlags(*command, options->report);
  command->callback([options, command, &status] {
    options->sizeGiven = command->count("--size") > 0;
    options->framesGiven = command->count("--frames") > 0;
    Report report(options->report);
    nlohmann::json result = nlohmann::json::object();
    status = runGallery(*options, report, result);
    result["status"] = status;
    printJson(std::move(result), report);
  });
}

}  // namespace orris
