#include <orris/validate/draw_check.h>

#include <fmt/format.h>

#include <orris/render/session/render_session.h>
#include <orris/validate/driver_check.h>
#include <orris/world/dimension_look.h>
#include <orris/world/files/world_json.h>

namespace orris {

extern const char* const kEverythingWorld;

namespace {

constexpr int kDrawnWidth = 64, kDrawnHeight = 36;

/// Holds something for each kind of program (worlds/everything).
std::optional<World> everything(const std::string& dimension, Diagnostics& diagnostics) {
  std::optional<World> world =
      parseWorldJson({kEverythingWorld, "everything", "everything", 0, nullptr}, diagnostics);
  if (world) setDimension(dimension, world->environment);
  return world;
}

void drawOneFrame(gl::Context& context, const std::shared_ptr<const FileSource>& files,
                  const LoadRequest& load, Diagnostics& diagnostics) {
  std::optional<World> world = everything(load.dimension, diagnostics);
  if (!world) return;
  SessionRequest request;
  request.openPack = [&files](Diagnostics&) { return files; };
  request.load = load;
  request.renderer = {.width = kDrawnWidth, .height = kDrawnHeight};
  request.camera = world->cameras.front();
  const auto session = RenderSession::create(context, request, std::move(*world), diagnostics);
  if (session) session->renderFrame(diagnostics);
  for (const std::string& message : context.takeErrors()) {
    diagnostics.push_back({.id = "gl-error", .message = "drawing one frame: " + message});
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
