// orris view: a window to fly through a world and watch a pack change while it is edited.
#include <CLI/CLI.hpp>
#include <memory>

#include "app/commands/commands.h"
#include "app/view/viewer.h"

namespace orris {
namespace {

constexpr const char* kKeys =
    "Keys: W A S D, space and shift fly, a click takes the mouse and Esc gives it back or ends, "
    "the\n"
    "wheel sets the speed; 1 to 9 named cameras; F1 lists all keys: O options, T time and weather,\n"
    "F3 passes and pixels, R reload, P next profile, K pack on and off, F2 screenshot.\n"
    "Edited pack files and PACK.txt are taken over at once; what does not compile changes nothing.";

}  // namespace

void addViewCommand(CLI::App& app, int& status) {
  const auto options = std::make_shared<ViewOptions>();
  CLI::App* command = app.add_subcommand("view", "show a world in a window, following edits");
  command->footer(kKeys);
  addPackArgument(*command, options->pack.path);
  addWorldArgument(*command, options->scene.path);
  addPackFlags(*command, options->pack);
  addVersionFlags(*command, options->pack.versions);
  addSceneFlags(*command, options->scene);
  addImageFlags(*command, options->image);
  addFramesFlag(*command, options->image.frames);
  command->add_option("--screenshot", options->screenshot, "picture to write at the end")
      ->type_name("FILE");
  command
      ->add_option("--script", options->script,
                   "steps to do instead of a user: keys, edits, waits, pictures (docs/view.md)")
      ->type_name("FILE");
  addLimitFlags(*command, options->limits);
  addOutputFlags(*command, options->output);
  command->callback([options, &status] {
    const gl::Backend backend = options->image.backend;
    const bool window = backend == gl::Backend::Auto || backend == gl::Backend::Glfw;
    const bool hidden = backend == gl::Backend::Egl && !options->script.empty();
    if (!window && !hidden) {
      throw CLI::ValidationError(
          "--backend", "view needs a window: glfw, or egl with --script");
    }
    Viewer viewer(*options);
    status = viewer.run();
  });
}

}  // namespace orris
