#include <orris/api/renderer.h>

#include <cstring>

#include <orris/core/add_diagnostic.h>
#include <orris/world/dimension_look.h>
#include <orris/world/world.h>

namespace orris::api {
namespace {

constexpr int kMostPixels = 16384;  // of an axis

std::string textOr(const char* text, std::string otherwise) {
  return text == nullptr ? std::move(otherwise) : std::string(text);
}

OptionValues optionsOf(const OrrisRendererRequest& request) {
  OptionValues values;
  if (request.option_count != 0) refuseNull(request.options, "request->options");
  for (std::uint32_t i = 0; i < request.option_count; ++i) {
    refuseNull(request.options[i], "an element of request->options");
    const std::string line = request.options[i];
    const std::size_t equals = line.find('=');
    if (equals == std::string::npos || equals == 0)
      fail(ORRIS_ERROR_ARGUMENT, "the option \"" + line + "\" is not of the form NAME=VALUE");
    values[line.substr(0, equals)] = line.substr(equals + 1);
  }
  return values;
}

/// Nothing in it but what the game's defaults are; the engine draws.
World emptyWorld() {
  World world;
  world.name = "engine";
  world.cameras = {Camera()};
  return world;
}

World worldOf(const OrrisRenderer& renderer, const OrrisRendererRequest& request) {
  if (request.world == nullptr) return emptyWorld();
  Diagnostics diagnostics;
  auto world = loadWorld(request.world, request.seed, diagnostics);
  report(renderer, diagnostics);
  if (!world) fail(ORRIS_ERROR_WORLD, diagnostics, "the world cannot be read");
  return std::move(*world);
}

SessionRequest sessionRequest(OrrisRenderer& renderer, const OrrisRendererRequest& request,
                              const World& world) {
  SessionRequest session;
  session.openPack = [path = std::string(request.pack)](Diagnostics& diagnostics) {
    return std::shared_ptr<const FileSource>(openPack(path, diagnostics));
  };
  session.load.dimension = world.environment.dimension;
  session.load.profile = textOr(request.profile, "");
  session.load.values = optionsOf(request);
  session.renderer = {
      .width = request.width, .height = request.height, .pool = renderer.context->pool};
  session.camera = world.cameras.front();
  session.seed = request.seed;
  session.engine = renderer.geometry.get();
  return session;
}

}  // namespace

void report(const OrrisRenderer& renderer, Diagnostics diagnostics) {
  removeDuplicates(diagnostics);
  if (renderer.onDiagnostic == nullptr) return;
  for (const Diagnostic& diagnostic : diagnostics) {
    const std::string text = formatDiagnostic(diagnostic);
    const OrrisDiagnostic out = {sizeof(OrrisDiagnostic),
                                 static_cast<OrrisSeverity>(diagnostic.severity),
                                 diagnostic.id.c_str(),
                                 diagnostic.at.file.c_str(),
                                 diagnostic.at.line,
                                 diagnostic.at.column,
                                 diagnostic.message.c_str(),
                                 diagnostic.hint.c_str(),
                                 text.c_str()};
    renderer.onDiagnostic(&out, renderer.user);
  }
}

void finishLoad(OrrisRenderer& renderer, bool succeeded, const Diagnostics& diagnostics) {
  report(renderer, diagnostics);
  if (!succeeded) fail(ORRIS_ERROR_PACK, diagnostics, "the pack cannot be drawn");
}

void addGlErrors(OrrisContext& context, Diagnostics& diagnostics) {
  for (const std::string& message : context.gl->takeErrors())
    addError(diagnostics, "gl-error", {}, "the GL driver reports: " + message);
}

void checkSize(int width, int height) {
  if (width < 1 || height < 1 || width > kMostPixels || height > kMostPixels)
    fail(ORRIS_ERROR_ARGUMENT, "a size of " + std::to_string(width) + "x" + std::to_string(height) +
                                   ": both must be 1 to " + std::to_string(kMostPixels));
}

}  // namespace orris::api

using namespace orris::api;

void orris_renderer_request_init(OrrisRendererRequest* request, size_t size) {
  if (request == nullptr) return;
  OrrisRendererRequest defaults;
  std::memset(&defaults, 0, sizeof(defaults));
  defaults.width = 1280;
  defaults.height = 720;
  initialise(request, size, &defaults, sizeof(defaults));
}

OrrisStatus orris_renderer_create(OrrisContext* context, const OrrisRendererRequest* given,
                                  OrrisRenderer** out) {
  return guarded([&] {
    refuseNull(out, "out");
    *out = nullptr;
    const OrrisRendererRequest& request = sized(given, "request");
    refuseNull(request.pack, "request->pack");
    checkSize(request.width, request.height);
    auto renderer = std::make_unique<OrrisRenderer>();
    renderer->context = &live(context);
    renderer->onDiagnostic = request.on_diagnostic;
    renderer->user = request.user;
    if (request.world == nullptr)
      renderer->geometry = std::make_unique<SubmittedGeometry>(geometrySetOf(request.kinds));
    orris::World world = worldOf(*renderer, request);
    if (request.dimension != nullptr) setDimension(request.dimension, world.environment);
    const orris::SessionRequest session = sessionRequest(*renderer, request, world);
    const Current current(*context);
    orris::Diagnostics diagnostics;
    renderer->session =
        orris::RenderSession::create(*context->gl, session, std::move(world), diagnostics);
    finishLoad(*renderer, renderer->session != nullptr, diagnostics);
    ++context->renderers;
    enrol(renderer.get(), OrrisRenderer::kKind);
    *out = renderer.release();
  });
}

OrrisStatus orris_renderer_destroy(OrrisRenderer* handle) {
  return guarded([&] {
    OrrisRenderer& renderer = live(handle);
    const Current current(*renderer.context);
    --renderer.context->renderers;
    strike(handle);
    delete handle;
  });
}

OrrisStatus orris_renderer_reload(OrrisRenderer* handle) {
  return guarded([&] {
    OrrisRenderer& renderer = live(handle);
    const Current current(*renderer.context);
    orris::Diagnostics diagnostics;
    finishLoad(renderer, renderer.session->reload("files changed", diagnostics), diagnostics);
  });
}

OrrisStatus orris_renderer_resize(OrrisRenderer* handle, int32_t width, int32_t height) {
  return guarded([&] {
    OrrisRenderer& renderer = live(handle);
    checkSize(width, height);
    const Current current(*renderer.context);
    if (renderer.session->renderer().size() == glm::ivec2(width, height)) return;
    renderer.drawn = false;
    orris::Diagnostics diagnostics;
    finishLoad(renderer, renderer.session->renderer().resize(width, height, diagnostics),
               diagnostics);
  });
}

OrrisStatus orris_renderer_set_dimension(OrrisRenderer* handle, const char* dimension) {
  return guarded([&] {
    OrrisRenderer& renderer = live(handle);
    refuseNull(dimension, "dimension");
    const Current current(*renderer.context);
    orris::RenderSession& session = *renderer.session;
    const std::string asked = dimension, before = session.loadRequest().dimension,
                      worldBefore = session.environment().dimension;
    session.loadRequest().dimension = session.environment().dimension = asked;
    orris::Diagnostics diagnostics;
    const bool succeeded = session.reload("dimension " + asked, diagnostics);
    if (!succeeded) {
      session.loadRequest().dimension = before;
      session.environment().dimension = worldBefore;
    }
    finishLoad(renderer, succeeded, diagnostics);
  });
}
