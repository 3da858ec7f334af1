#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <orris/core/add_diagnostic.h>
#include <orris/gl/context_backends.h>
#include <orris/gl/functions.h>

namespace orris::gl {
namespace {

std::string lastGlfwError() {
  const char* description = nullptr;
  if (glfwGetError(&description) == GLFW_NO_ERROR || description == nullptr) return "unknown error";
  return description;
}

bool refuse(Diagnostics& diagnostics, std::string_view action) {
  addError(diagnostics, "gl-no-window", {}, fmt::format("cannot {}: {}", action, lastGlfwError()),
           "a display is needed: set DISPLAY, or run under xvfb-run, or draw without a "
           "window with --backend osmesa or egl");
  return false;
}

class GlfwContext final : public Context {
 public:
  // GLFW stays started until the process ends: stopping it unloads the driver, which like the other
  // two may leave threads and exit handlers behind that still need its code.
  ~GlfwContext() override {
    if (window_ != nullptr) glfwDestroyWindow(window_);
  }
  Backend backend() const override { return Backend::Glfw; }
  GLFWwindow* window() const override { return window_; }

  bool create(const ContextRequest& request, Diagnostics& diagnostics) {
    if (glfwInit() != GLFW_TRUE) return refuse(diagnostics, "start GLFW");
    for (const ContextProfile profile : profilesToTry(request.profile)) {
      for (const GlVersion& version : kVersions) {
        if (window_ == nullptr) window_ = openWindow(request, profile, version);
      }
    }
    if (window_ == nullptr) return refuse(diagnostics, "open a window");
    glfwMakeContextCurrent(window_);
    const auto resolve = [](const char* name) {
      return reinterpret_cast<void*>(glfwGetProcAddress(name));
    };
    return initialise(resolve, diagnostics);
  }

 protected:
  bool bind() override {
    glfwMakeContextCurrent(window_);
    return glfwGetCurrentContext() == window_;
  }

 private:
  static GLFWwindow* openWindow(const ContextRequest& request, ContextProfile profile,
                                const GlVersion& version) {
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_VISIBLE, request.visible ? GLFW_TRUE : GLFW_FALSE);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, version.major);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, version.minor);
    glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS, GLFW_LOSE_CONTEXT_ON_RESET);
    const bool core = profile == ContextProfile::Core;
    glfwWindowHint(GLFW_OPENGL_PROFILE,
                   core ? GLFW_OPENGL_CORE_PROFILE : GLFW_OPENGL_COMPAT_PROFILE);
    return glfwCreateWindow(request.width, request.height, request.title.c_str(), nullptr, nullptr);
  }

  GLFWwindow* window_ = nullptr;
};

}  // namespace

std::unique_ptr<Context> createGlfwContext(const ContextRequest& request,
                                           Diagnostics& diagnostics) {
  auto context = std::make_unique<GlfwContext>();
  if (!context->create(request, diagnostics)) return nullptr;
  return context;
}

}  // namespace orris::gl
