// A GL context without (OSMesa, EGL surfaceless) or with (GLFW) a window. All three libraries are
// loaded when asked for: a missing one is a message, not a link failure.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/diagnostic.h"

struct GLFWwindow;

namespace orris::gl {

enum class Backend { Auto, OSMesa, Egl, Glfw };
std::optional<Backend> parseBackend(std::string_view name);  ///< "auto", "osmesa", "egl", "glfw"

struct ContextRequest {
  Backend backend = Backend::Auto;  ///< Auto: OSMesa, else EGL
  int width = 1, height = 1;        ///< window size, GLFW only
  std::string title = "orris";
  bool visible = true;
};

/// Facts of the driver, read once.
struct DriverInfo {
  std::string vendor, renderer, version, shadingLanguage;
  int glVersion = 0;  ///< 450
  std::vector<std::string> extensions;
  int maxDrawBuffers = 8, maxTextureUnits = 32, maxImageUnits = 8, maxTextureSize = 0;
};

/// A current compatibility-profile context (>= 3.3), made current on the creating thread.
class Context {
 public:
  virtual ~Context() = default;
  virtual Backend backend() const = 0;
  /// The window, nullptr for headless backends.
  virtual GLFWwindow* window() const { return nullptr; }
  const DriverInfo& driver() const { return driver_; }
  /// Messages of high severity (KHR_debug) and glGetError since the last call, oldest first.
  std::vector<std::string> takeErrors();

 protected:
  /// To be called by backends once current: loads functions, reads driver facts, installs the
  /// debug callback. false and a diagnostic when something is missing.
  bool initialise(void* (*getProcAddress)(const char*), Diagnostics& diagnostics);

 private:
  DriverInfo driver_;
  std::shared_ptr<std::vector<std::string>> errors_ = std::make_shared<std::vector<std::string>>();
};

/// nullptr and a diagnostic that says what was tried, what failed and what to install.
std::unique_ptr<Context> createContext(const ContextRequest& request, Diagnostics& diagnostics);

}  // namespace orris::gl
