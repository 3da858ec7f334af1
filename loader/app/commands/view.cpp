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
    "wheel sets the speed; 1 to 9 named cameras; R reload, O next profile, F2 screenshot.\n"
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
  command->add_option("--screenshot", options->screenshot, "picture to write at the end")
      ->type_name("FILE");
  addOutputFlags(*command, options->output);
  command->callback([options, &status] {
    const gl::Backend backend = options->image.backend;
    if (backend != gl::Backend::Auto && backend != gl::Backend::Glfw) {
      throw CLI::ValidationError("--backend", "view needs a window: only glfw can be asked for");
    }
    Viewer viewer(*options);
    status = viewer.run();
  });
}

}  // namespace orris
