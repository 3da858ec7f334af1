// A GL context without (OSMesa, EGL surfaceless) or with (GLFW) a window. OSMesa and EGL are loaded
// when asked for: a missing library is a message, not a link failure.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <orris/core/diagnostic.h>

struct GLFWwindow;

namespace orris::gl {

enum class Backend { Auto, OSMesa, Egl, Glfw };
std::optional<Backend> parseBackend(std::string_view name);  ///< "auto", "osmesa", "egl", "glfw"
std::string_view backendName(Backend backend);               ///< what parseBackend accepts

/// Of a context. Core has none of the old fixed functions: programs get another text there
/// (glsl/rewrite/core_text.h), and the same picture.
enum class ContextProfile { Auto, Compatibility, Core };
std::optional<ContextProfile> parseContextProfile(std::string_view name);  ///< "auto", "core", ...

struct ContextRequest {
  Backend backend = Backend::Auto;  ///< Auto: OSMesa, else EGL
  ContextProfile profile = ContextProfile::Auto;  ///< Auto: compatibility, else core
  int width = 1, height = 1;        ///< window size, GLFW only
  std::string title = "orris";
  bool visible = true;
  /// File names tried in order.
  std::vector<std::string> osmesaLibraries = {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"};
  std::vector<std::string> eglLibraries = {"libEGL.so.1", "libEGL.so"};
};

/// Facts of the driver, read once.
struct DriverInfo {
  std::string vendor, renderer, version, shadingLanguage;
  int glVersion = 0;  ///< 450
  std::vector<std::string> extensions;
  int maxDrawBuffers = 8;
  int maxTextureUnits = 32;  ///< of all stages together: the units that can be bound to
  int maxImageUnits = 8, maxTextureSize = 0;
  bool coreProfile = false;
};

using GetProcAddress = std::function<void*(const char*)>;

/// A context (>= 4.3 with direct state access) of either profile, made current on the creating
/// thread. One is current at a time: a new one takes over the GL functions of functions.h, and GL
/// objects must be destroyed before their context.
class Context {
 public:
  Context() = default;
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
  virtual ~Context();
  virtual Backend backend() const = 0;
  /// The window, nullptr for headless backends.
  virtual GLFWwindow* window() const { return nullptr; }
  const DriverInfo& driver() const { return driver_; }
  /// Makes it current on this thread, if createContext() made it, and the functions of functions.h its
  /// own, which another context may have replaced. false: it cannot be, or the engine has none current.
  bool makeCurrent();
  /// Messages of high severity (KHR_debug) and glGetError since the last call, oldest first, each
  /// different text once, and whether the GPU was reset, after which nothing is drawn. Compiler messages
  /// are not among them: Program keeps those.
  std::vector<std::string> takeErrors();

 protected:
  /// Binds the context to this thread; false where that fails.
  virtual bool bind() = 0;
  /// To be called by backends once current: loads functions, reads driver facts, installs the
  /// debug callback. false and a diagnostic when something is missing.
  bool initialise(const GetProcAddress& getProcAddress, Diagnostics& diagnostics);

 private:
  DriverInfo driver_;
  GetProcAddress getProcAddress_;
  unsigned (*resetStatus_)() = nullptr;  // glGetGraphicsResetStatus, which old drivers lack
  std::vector<std::string> errors_;  // written by the driver's debug callback
};

/// Whether a context of `backend` is known to be one of a software rasteriser before it is made: OSMesa, Auto
/// where OSMesa can be loaded, EGL with LIBGL_ALWAYS_SOFTWARE=1.
bool isSoftware(Backend backend);

/// Whether the library of a headless backend can be loaded.
bool isInstalled(Backend backend);

/// Of a context's own name for itself: DriverInfo::renderer.
bool isSoftwareRenderer(std::string_view renderer);

/// nullptr and one diagnostic that says what was tried, what failed and what to install.
std::unique_ptr<Context> createContext(const ContextRequest& request, Diagnostics& diagnostics);

/// The context that an engine of its own made current, of either profile; it stays the engine's.
/// GL state that drawing needs is set by each frame and left as it is then (gl/state_guard.h restores it);
/// debug messages are taken over until the value dies. nullptr and a diagnostic when no context is
/// current or it lacks something. Its backend() is Auto.
std::unique_ptr<Context> useCurrentContext(const GetProcAddress& getProcAddress,
                                           Diagnostics& diagnostics);

}  // namespace orris::gl
