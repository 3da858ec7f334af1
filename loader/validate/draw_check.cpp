#include "validate/draw_check.h"

#include <fmt/format.h>

#include "render/render_session.h"
#include "validate/driver_check.h"
#include "world/world.h"

namespace orris {
namespace {

constexpr int kDrawnWidth = 64, kDrawnHeight = 36;

World smallWorld(const std::string& dimension) {
  World world;
  world.name = "built-in";
  world.blocks = BlockWorld({0, 0, 0}, {8, 4, 8});
  const auto set = [&](const char* state, glm::ivec3 from, glm::ivec3 to) {
    world.blocks.fill(from, to, world.blocks.paletteIndex(*parseBlockState(state)));
  };
  set("stone", {0, 0, 0}, {7, 0, 7});
  set("glowstone", {4, 1, 4}, {4, 1, 4});
  set("oak_leaves", {2, 1, 2}, {2, 2, 2});
  set("glass", {5, 1, 2}, {5, 2, 2});
  set("water", {2, 0, 5}, {4, 0, 6});
  world.cameras = defaultCameras(world.blocks);
  world.environment.dimension = dimension;
  return world;
}

void drawOneFrame(gl::Context& context, const std::shared_ptr<const FileSource>& files,
                  const LoadRequest& load, Diagnostics& diagnostics) {
  World world = smallWorld(load.dimension);
  SessionRequest request;
  request.openPack = [&files](Diagnostics&) { return files; };
  request.load = load;
  request.renderer = {.width = kDrawnWidth, .height = kDrawnHeight};
  request.camera = world.cameras.front();
  const auto session = RenderSession::create(context, request, std::move(world), diagnostics);
  if (session) session->renderFrame(diagnostics);
  for (const std::string& message : context.takeErrors()) {
    Diagnostic& diagnostic = diagnostics.emplace_back();
    diagnostic.id = "gl-error";
    diagnostic.message = "drawing one frame: " + message;
  }
}

/// Most often a driver without a graphics card; but what was not drawn was not checked.
void explainTimeout(const std::string& dimension, std::chrono::seconds time,
                    Diagnostic& diagnostic) {
  diagnostic.id = "draw-timeout";
  diagnostic.message = fmt::format("one frame of {} takes this driver longer than {} s", dimension,
                                   time.count());
  diagnostic.hint =
      "look for loops and dispatches without end; if this driver is only slow, check without "
      "--draw, give more time with --frame-limit, or say --severity draw-timeout=warning";
}

/// A remark at a line comes from loading, which validate has reported already, in other words at times.
bool isOfLoading(const Diagnostic& diagnostic) {
  return diagnostic.severity != Severity::Error && diagnostic.at.line > 0;
}

}  // namespace

void checkDrawing(gl::Backend backend, const std::shared_ptr<const FileSource>& files,
                  const LoadRequest& load, std::chrono::seconds time, Diagnostics& diagnostics) {
  Diagnostics drawn = runWithContext(
      backend, "one frame",
      [&](gl::Context& context, Diagnostics& found) { drawOneFrame(context, files, load, found); },
      time);
  for (Diagnostic& diagnostic : drawn) {
    if (diagnostic.id == "compiler-timeout") explainTimeout(load.dimension, time, diagnostic);
    if (!isOfLoading(diagnostic)) diagnostics.push_back(std::move(diagnostic));
  }
}

}  // namespace orris
