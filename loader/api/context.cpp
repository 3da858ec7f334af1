#include <orris/api/context.h>

#include <string_view>

namespace orris::api {
namespace {

void enrolNew(std::unique_ptr<OrrisContext> context, OrrisContext** out) {
  enrol(context.get(), OrrisContext::kKind);
  *out = context.release();
}

gl::Backend backendNamed(const char* name) {
  const auto backend = gl::parseBackend(name == nullptr ? "auto" : name);
  if (!backend || *backend == gl::Backend::Glfw)
    fail(ORRIS_ERROR_ARGUMENT, std::string("no backend \"") + name + "\": auto, osmesa or egl");
  return *backend;
}

}  // namespace

void makeCurrent(OrrisContext& context) {
  if (!context.gl->makeCurrent())
    fail(ORRIS_ERROR_CONTEXT, context.adopted
                                  ? "the engine's GL context is not current on this thread"
                                  : "the context cannot be made current on this thread");
}

Current::Current(OrrisContext& context) {
  makeCurrent(context);
  if (context.adopted) guard_.emplace();
}

}  // namespace orris::api

using namespace orris::api;

OrrisStatus orris_context_adopt(OrrisGetProcAddress get, void* user, OrrisContext** out) {
  return guarded([&] {
    refuseNull(out, "out");
    *out = nullptr;
    refuseNull(reinterpret_cast<const void*>(get), "get_proc_address");
    orris::Diagnostics diagnostics;
    auto context = std::make_unique<OrrisContext>();
    context->adopted = true;
    context->gl = orris::gl::useCurrentContext(
        [get, user](const char* name) { return get(name, user); }, diagnostics);
    if (!context->gl) fail(ORRIS_ERROR_CONTEXT, diagnostics, "the context cannot be used");
    enrolNew(std::move(context), out);
  });
}

OrrisStatus orris_context_create(const char* backend, OrrisContext** out) {
  return guarded([&] {
    refuseNull(out, "out");
    *out = nullptr;
    orris::gl::ContextRequest request;
    request.backend = backendNamed(backend);
    orris::Diagnostics diagnostics;
    auto context = std::make_unique<OrrisContext>();
    context->gl = orris::gl::createContext(request, diagnostics);
    if (!context->gl) fail(ORRIS_ERROR_CONTEXT, diagnostics, "no context can be made");
    enrolNew(std::move(context), out);
  });
}

OrrisStatus orris_context_facts(OrrisContext* handle, OrrisContextFacts* facts) {
  return guarded([&] {
    OrrisContext& context = live(handle);
    sized(facts, "facts");
    const orris::gl::DriverInfo& driver = context.gl->driver();
    facts->backend =
        context.adopted ? "adopted" : orris::gl::backendName(context.gl->backend()).data();
    facts->vendor = driver.vendor.c_str();
    facts->renderer = driver.renderer.c_str();
    facts->version = driver.version.c_str();
    facts->gl_version = driver.glVersion;
    facts->core_profile = driver.coreProfile ? 1 : 0;
    facts->max_texture_size = driver.maxTextureSize;
    facts->max_texture_units = driver.maxTextureUnits;
    facts->max_draw_buffers = driver.maxDrawBuffers;
    facts->max_image_units = driver.maxImageUnits;
  });
}

OrrisStatus orris_context_destroy(OrrisContext* handle) {
  return guarded([&] {
    OrrisContext& context = live(handle);
    if (context.renderers != 0)
      fail(ORRIS_ERROR_ORDER, std::to_string(context.renderers) +
                                  " renderers of this context live: destroy them before it");
    // Objects are deleted while it is current; of a context that is gone nothing is left to delete.
    context.gl->makeCurrent();
    context.pool->clear();
    strike(handle);
    delete handle;
  });
}
