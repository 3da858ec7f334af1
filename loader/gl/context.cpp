#include <orris/gl/context.h>

#include <dlfcn.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include <orris/core/add_diagnostic.h>
#include <orris/gl/context_backends.h>
#include <orris/gl/functions.h>

namespace orris::gl {
namespace {

struct BackendName {
  std::string_view name;
  Backend backend;
};
constexpr BackendName kBackendNames[] = {{"auto", Backend::Auto},
                                         {"osmesa", Backend::OSMesa},
                                         {"egl", Backend::Egl},
                                         {"glfw", Backend::Glfw}};

struct ContextProfileName {
  std::string_view name;
  ContextProfile profile;
};
constexpr ContextProfileName kContextProfiles[] = {
    {"auto", ContextProfile::Auto},
    {"compatibility", ContextProfile::Compatibility},
    {"core", ContextProfile::Core}};

/// Whose functions those of functions.h are.
const Context* functionsOwner = nullptr;

class ForeignContext final : public Context {
 public:
  ~ForeignContext() override {
    if (!makeCurrent()) return;
    DebugMessageCallback(reinterpret_cast<GLDEBUGPROC>(callback_), user_);
    if (debugWasOff_) Disable(GL_DEBUG_OUTPUT);
  }
  Backend backend() const override { return Backend::Auto; }
  bool take(const GetProcAddress& getProcAddress, Diagnostics& diagnostics) {
    getString_ = reinterpret_cast<decltype(getString_)>(getProcAddress("glGetString"));
    if (!bind()) {
      addError(diagnostics, "gl-no-current-context", {}, "no GL context is current on this thread",
               "make the engine's context current before Orris is to use it");
      return false;
    }
    using GetPointer = decltype(&::glGetPointerv);
    if (const auto get = reinterpret_cast<GetPointer>(getProcAddress("glGetPointerv"))) {
      get(GL_DEBUG_CALLBACK_FUNCTION, &callback_);
      get(GL_DEBUG_CALLBACK_USER_PARAM, &user_);
    }
    using IsEnabledFunction = decltype(&::glIsEnabled);
    if (const auto asks = reinterpret_cast<IsEnabledFunction>(getProcAddress("glIsEnabled")))
      debugWasOff_ = asks(GL_DEBUG_OUTPUT) == GL_FALSE;
    return initialise(getProcAddress, diagnostics);
  }

 protected:
  bool bind() override { return getString_ != nullptr && getString_(GL_VERSION) != nullptr; }

 private:
  decltype(&::glGetString) getString_ = nullptr;
  void* callback_ = nullptr;  ///< the engine's, for debug messages
  void* user_ = nullptr;
  bool debugWasOff_ = false;
};

// What the loader calls beyond OpenGL 4.3; all are part of 4.5.
constexpr const char* kExtensionsBelow45[] = {"GL_ARB_direct_state_access", "GL_ARB_clear_texture",
                                              "GL_ARB_buffer_storage"};

// An endless source of errors must not fill the memory.
constexpr size_t kMaxErrors = 64;

void addOnce(std::vector<std::string>& errors, std::string text) {
  if (errors.size() < kMaxErrors && std::find(errors.begin(), errors.end(), text) == errors.end()) {
    errors.push_back(std::move(text));
  }
}

void APIENTRY onDebugMessage(GLenum source, GLenum, GLuint, GLenum severity, GLsizei length,
                             const GLchar* message, const void* user) {
  if (severity != GL_DEBUG_SEVERITY_HIGH || source == GL_DEBUG_SOURCE_SHADER_COMPILER) return;
  std::string text = length < 0 ? std::string(message) : std::string(message, size_t(length));
  while (!text.empty() && (text.back() == '\n' || text.back() == '\0')) text.pop_back();
  addOnce(*static_cast<std::vector<std::string>*>(const_cast<void*>(user)), std::move(text));
}

std::string errorName(GLenum error) {
  switch (error) {
    case GL_INVALID_ENUM:
      return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE:
      return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION:
      return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
      return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY:
      return "GL_OUT_OF_MEMORY";
    case GL_STACK_UNDERFLOW:
      return "GL_STACK_UNDERFLOW";
    case GL_STACK_OVERFLOW:
      return "GL_STACK_OVERFLOW";
    default:
      return fmt::format("GL error {:#06x}", error);
  }
}

int getInteger(GLenum name) {
  GLint value = 0;
  GetIntegerv(name, &value);
  return value;
}

std::string getString(GLenum name) {
  const GLubyte* text = GetString(name);
  return text == nullptr ? std::string() : std::string(reinterpret_cast<const char*>(text));
}

DriverInfo readDriver() {
  DriverInfo driver;
  driver.vendor = getString(GL_VENDOR);
  driver.renderer = getString(GL_RENDERER);
  driver.version = getString(GL_VERSION);
  driver.shadingLanguage = getString(GL_SHADING_LANGUAGE_VERSION);
  driver.glVersion = getInteger(GL_MAJOR_VERSION) * 100 + getInteger(GL_MINOR_VERSION) * 10;
  const int count = getInteger(GL_NUM_EXTENSIONS);
  for (int i = 0; i < count; ++i) {
    const GLubyte* name = GetStringi(GL_EXTENSIONS, GLuint(i));
    if (name != nullptr) driver.extensions.emplace_back(reinterpret_cast<const char*>(name));
  }
  driver.maxDrawBuffers = getInteger(GL_MAX_DRAW_BUFFERS);
  driver.maxTextureUnits = getInteger(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS);
  driver.maxImageUnits = getInteger(GL_MAX_IMAGE_UNITS);
  driver.maxTextureSize = getInteger(GL_MAX_TEXTURE_SIZE);
  driver.coreProfile = isCoreProfile();
  return driver;
}

// What the driver lacks of what the loader needs; empty when nothing.
std::string lacking(const DriverInfo& driver) {
  if (driver.glVersion < 430) return "OpenGL 4.3";
  if (driver.glVersion >= 450) return {};
  std::vector<std::string> missing;
  for (const char* name : kExtensionsBelow45) {
    const auto& all = driver.extensions;
    if (std::find(all.begin(), all.end(), name) == all.end()) missing.emplace_back(name);
  }
  return fmt::format("{}", fmt::join(missing, ", "));
}

void installDebugCallback(std::vector<std::string>* errors) {
  Enable(GL_DEBUG_OUTPUT);
  // Synchronous: messages come on this thread, before the call that caused them returns.
  Enable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  DebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_FALSE);
  DebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DEBUG_SEVERITY_HIGH, 0, nullptr, GL_TRUE);
  DebugMessageCallback(onDebugMessage, errors);
}

std::unique_ptr<Context> createHeadless(const ContextRequest& request, Diagnostics& diagnostics) {
  Diagnostics failures;
  if (auto context = createOsmesaContext(request, failures)) return context;
  if (auto context = createEglContext(request, failures)) return context;
  Diagnostic diagnostic;
  diagnostic.id = "gl-no-headless-context";
  diagnostic.message = "no way to draw without a display: neither OSMesa nor EGL gave a context";
  for (const Diagnostic& failure : failures) diagnostic.notes.push_back(failure.message);
  diagnostic.hint = "install libosmesa6, or libegl1 with libegl-mesa0 and libgl1-mesa-dri";
  diagnostics.push_back(std::move(diagnostic));
  return nullptr;
}

}  // namespace

std::optional<Backend> parseBackend(std::string_view name) {
  for (const BackendName& known : kBackendNames) {
    if (known.name == name) return known.backend;
  }
  return std::nullopt;
}

std::string_view backendName(Backend backend) {
  for (const BackendName& known : kBackendNames) {
    if (known.backend == backend) return known.name;
  }
  return "auto";
}

std::optional<ContextProfile> parseContextProfile(std::string_view name) {
  for (const ContextProfileName& known : kContextProfiles) {
    if (known.name == name) return known.profile;
  }
  return std::nullopt;
}

std::vector<ContextProfile> profilesToTry(ContextProfile asked) {
  if (asked != ContextProfile::Auto) return {asked};
  return {ContextProfile::Compatibility, ContextProfile::Core};
}

std::string describeWanted(ContextProfile asked) {
  return fmt::format("{}context of OpenGL 4.3 or newer",
                     asked == ContextProfile::Core            ? "core "
                     : asked == ContextProfile::Compatibility ? "compatibility "
                                                              : "");
}

bool softwareIsAsked() {
  const char* software = std::getenv("LIBGL_ALWAYS_SOFTWARE");
  return software && (*software == '1' || *software == 't' || *software == 'y');
}

bool isSoftware(Backend backend) {
  if (backend == Backend::Glfw) return false;
  if (backend == Backend::OSMesa || softwareIsAsked()) return true;
  return backend == Backend::Auto && loadLibrary(ContextRequest().osmesaLibraries) != nullptr;
}

bool isInstalled(Backend backend) {
  const ContextRequest request;
  return loadLibrary(backend == Backend::Egl ? request.eglLibraries : request.osmesaLibraries) != nullptr;
}

bool isSoftwareRenderer(std::string_view renderer) {
  return renderer.find("llvmpipe") != renderer.npos || renderer.find("softpipe") != renderer.npos;
}

Context::~Context() {
  if (functionsOwner == this) functionsOwner = nullptr;
}

bool Context::makeCurrent() {
  if (!bind()) return false;
  if (functionsOwner == this) return true;
  functionsOwner = this;
  return loadFunctions(getProcAddress_).empty();
}

bool Context::initialise(const GetProcAddress& getProcAddress, Diagnostics& diagnostics) {
  getProcAddress_ = getProcAddress;
  functionsOwner = this;
  const std::vector<std::string> missing = loadFunctions(getProcAddress);
  if (GetString != nullptr && GetStringi != nullptr && GetIntegerv != nullptr) {
    driver_ = readDriver();
    const std::string lacks = lacking(driver_);
    if (!lacks.empty()) {
      addError(diagnostics, "gl-too-old", {},
               fmt::format("the GL driver \"{}\" ({}) lacks {}", driver_.renderer, driver_.version,
                           lacks),
               "use a newer driver, or Mesa's software driver: --backend osmesa, or "
               "LIBGL_ALWAYS_SOFTWARE=1 with --backend egl");
      return false;
    }
  }
  if (!missing.empty()) {
    addError(diagnostics, "gl-function-missing", {},
             fmt::format("the GL driver does not offer {}", fmt::join(missing, ", ")),
             "use another driver or --backend");
    return false;
  }
  resetStatus_ = reinterpret_cast<decltype(resetStatus_)>(getProcAddress("glGetGraphicsResetStatus"));
  installDebugCallback(&errors_);
  return true;
}

std::vector<std::string> Context::takeErrors() {
  if (const GLenum status = resetStatus_ != nullptr ? resetStatus_() : GLenum(GL_NO_ERROR)) {
    addOnce(errors_, fmt::format("the GPU was reset and the context is lost: {}",
                                 status == GL_GUILTY_CONTEXT_RESET
                                     ? "a program ran too long, or read or wrote where it has no memory"
                                 : status == GL_INNOCENT_CONTEXT_RESET ? "another process was the cause"
                                                                       : "the driver names no cause"));
  }
  // A driver reports the same error twice, in words and by number; the words suffice.
  const bool reported = !errors_.empty();
  for (int i = 0; i < int(kMaxErrors); ++i) {
    const GLenum error = GetError();
    if (error == GL_NO_ERROR) break;
    if (!reported) addOnce(errors_, errorName(error));
  }
  return std::exchange(errors_, {});
}

std::unique_ptr<Context> createContext(const ContextRequest& request, Diagnostics& diagnostics) {
  switch (request.backend) {
    case Backend::OSMesa:
      return createOsmesaContext(request, diagnostics);
    case Backend::Egl:
      return createEglContext(request, diagnostics);
    case Backend::Glfw:
      return createGlfwContext(request, diagnostics);
    case Backend::Auto:
      break;
  }
  return createHeadless(request, diagnostics);
}

std::unique_ptr<Context> useCurrentContext(const GetProcAddress& getProcAddress,
                                           Diagnostics& diagnostics) {
  auto context = std::make_unique<ForeignContext>();
  if (!context->take(getProcAddress, diagnostics)) return nullptr;
  return context;
}

void* loadLibrary(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    if (void* library = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL)) return library;
  }
  return nullptr;
}

void* findSymbol(void* library, const char* name) { return dlsym(library, name); }

}  // namespace orris::gl
