// EGL without a surface, loaded at run time and without its header.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdint>
#include <cstring>

#include <orris/core/add_diagnostic.h>
#include <orris/gl/context_backends.h>

namespace orris::gl {
namespace {

using EglDisplay = void*;
using EglConfig = void*;
using EglHandle = void*;
using EglInt = std::int32_t;
using EglBoolean = unsigned;

constexpr EglInt kExtensions = 0x3055;
constexpr EglInt kNone = 0x3038;
constexpr EglInt kRenderableType = 0x3040;
constexpr EglInt kSurfaceType = 0x3033;
constexpr EglInt kOpenglBit = 0x0008;
constexpr EglInt kEglMajor = 0x3098;
constexpr EglInt kEglMinor = 0x30FB;
constexpr EglInt kProfileMask = 0x30FD;
constexpr EglInt kCoreProfileBit = 0x0001;
constexpr EglInt kCompatibilityProfile = 0x0002;
constexpr unsigned kOpenglApi = 0x30A2;
constexpr EglInt kRobustAccess = 0x31B2;
constexpr EglInt kResetStrategy = 0x31BD;
constexpr EglInt kLoseContextOnReset = 0x31BF;
constexpr unsigned kPlatformDevice = 0x313F;
constexpr unsigned kPlatformSurfaceless = 0x31DD;

struct EglApi {
  void (*(*getProcAddress)(const char*))() = nullptr;
  EglDisplay (*getDisplay)(void* nativeDisplay) = nullptr;
  EglBoolean (*initialize)(EglDisplay, EglInt* major, EglInt* minor) = nullptr;
  const char* (*queryString)(EglDisplay, EglInt name) = nullptr;
  EglBoolean (*bindApi)(unsigned api) = nullptr;
  EglBoolean (*chooseConfig)(EglDisplay, const EglInt* attributes, EglConfig*, EglInt size,
                             EglInt* count) = nullptr;
  EglHandle (*createContext)(EglDisplay, EglConfig, EglHandle share, const EglInt*) = nullptr;
  EglBoolean (*makeCurrent)(EglDisplay, void* draw, void* read, EglHandle) = nullptr;
  EglBoolean (*destroyContext)(EglDisplay, EglHandle) = nullptr;
  EglInt (*getError)() = nullptr;
  // Extensions, may stay null.
  EglDisplay (*getPlatformDisplay)(unsigned platform, void* native, const EglInt*) = nullptr;
  EglBoolean (*queryDevices)(EglInt size, void** devices, EglInt* count) = nullptr;
  const char* (*queryDeviceString)(void* device, EglInt name) = nullptr;

  bool load(void* library) {
    const auto resolve = [library](auto& function, const char* name) {
      function = reinterpret_cast<std::decay_t<decltype(function)>>(findSymbol(library, name));
      return function != nullptr;
    };
    if (!(resolve(getProcAddress, "eglGetProcAddress") && resolve(getDisplay, "eglGetDisplay") &&
          resolve(initialize, "eglInitialize") && resolve(queryString, "eglQueryString") &&
          resolve(bindApi, "eglBindAPI") && resolve(chooseConfig, "eglChooseConfig") &&
          resolve(createContext, "eglCreateContext") && resolve(makeCurrent, "eglMakeCurrent") &&
          resolve(destroyContext, "eglDestroyContext") && resolve(getError, "eglGetError"))) {
      return false;
    }
    getPlatformDisplay =
        reinterpret_cast<decltype(getPlatformDisplay)>(getProcAddress("eglGetPlatformDisplayEXT"));
    queryDevices = reinterpret_cast<decltype(queryDevices)>(getProcAddress("eglQueryDevicesEXT"));
    queryDeviceString =
        reinterpret_cast<decltype(queryDeviceString)>(getProcAddress("eglQueryDeviceStringEXT"));
    return true;
  }
};

bool hasExtension(const char* list, const char* name) {
  if (list == nullptr) return false;
  const size_t length = std::strlen(name);
  for (const char* at = std::strstr(list, name); at != nullptr; at = std::strstr(at + 1, name)) {
    const bool starts = at == list || at[-1] == ' ';
    if (starts && (at[length] == ' ' || at[length] == '\0')) return true;
  }
  return false;
}

// GPUs, then Mesa's surfaceless platform, then whatever the default display is. A GPU of NVIDIA beside Mesa is found
// as a device only: the surfaceless platform is then Mesa's software rasteriser.
std::vector<EglDisplay> candidateDisplays(const EglApi& api) {
  std::vector<EglDisplay> displays;
  if (api.getPlatformDisplay != nullptr) {
    void* devices[16] = {};
    EglInt count = 0;
    const bool listed = !softwareIsAsked() && api.queryDevices != nullptr && api.queryDeviceString != nullptr &&
                        api.queryDevices(16, devices, &count) != 0;
    for (EglInt i = 0; listed && i < count; ++i) {
      if (!hasExtension(api.queryDeviceString(devices[i], kExtensions), "EGL_MESA_device_software"))
        displays.push_back(api.getPlatformDisplay(kPlatformDevice, devices[i], nullptr));
    }
    if (hasExtension(api.queryString(nullptr, kExtensions), "EGL_MESA_platform_surfaceless"))
      displays.push_back(api.getPlatformDisplay(kPlatformSurfaceless, nullptr, nullptr));
  }
  displays.push_back(api.getDisplay(nullptr));
  return displays;
}

class EglContext final : public Context {
 public:
  EglContext(const EglApi& api, ContextProfile profile) : api_(api), profile_(profile) {}
  ~EglContext() override {
    // The display is one per process and platform; terminating it would end other contexts too.
    if (handle_ == nullptr) return;
    api_.makeCurrent(display_, nullptr, nullptr, nullptr);
    api_.destroyContext(display_, handle_);
  }
  Backend backend() const override { return Backend::Egl; }

  /// false: lastFailure() says what the last display tried refused.
  bool create() {
    for (EglDisplay display : candidateDisplays(api_)) {
      if (display == nullptr) continue;
      if (api_.initialize(display, nullptr, nullptr) == 0) {
        fail("initialise");
      } else if (createOn(display)) {
        return true;
      }
    }
    return false;
  }

  bool load(Diagnostics& diagnostics) {
    const auto resolve = [this](const char* name) {
      return reinterpret_cast<void*>(api_.getProcAddress(name));
    };
    return initialise(resolve, diagnostics);
  }
  const std::string& lastFailure() const { return failure_; }

 protected:
  bool bind() override {
    // The API is bound by thread.
    return api_.bindApi(kOpenglApi) != 0 &&
           api_.makeCurrent(display_, nullptr, nullptr, handle_) != 0;
  }

 private:
  bool createOn(EglDisplay display) {
    const char* extensions = api_.queryString(display, kExtensions);
    if (!hasExtension(extensions, "EGL_KHR_surfaceless_context")) return fail("go surfaceless");
    if (api_.bindApi(kOpenglApi) == 0) return fail("bind the OpenGL API");
    EglConfig config = nullptr;
    if (!hasExtension(extensions, "EGL_KHR_no_config_context")) {
      const EglInt wanted[] = {kRenderableType, kOpenglBit, kSurfaceType, 0, kNone};
      EglInt count = 0;
      if (api_.chooseConfig(display, wanted, &config, 1, &count) == 0 || count == 0) {
        return fail("find an OpenGL configuration");
      }
    }
    for (const ContextProfile profile : profilesToTry(profile_)) {
      for (const GlVersion& version : kVersions) {
        for (const bool robust : {true, false})
          if (createOne(display, config, profile, version, robust)) return true;
      }
    }
    return fail(("create a " + describeWanted(profile_)).c_str());
  }

  /// Robust: reads beyond a buffer give zeros, and a reset of the GPU is noticed (EGL 1.5; drivers may refuse).
  bool createOne(EglDisplay display, EglConfig config, ContextProfile profile,
                 const GlVersion& version, bool robust) {
    const EglInt mask = profile == ContextProfile::Core ? kCoreProfileBit : kCompatibilityProfile;
    const EglInt attributes[] = {kEglMajor,      version.major,       kEglMinor,
                                 version.minor,  kProfileMask,        mask,
                                 robust ? kRobustAccess : kNone,      1,
                                 kResetStrategy, kLoseContextOnReset, kNone};
    EglHandle handle = api_.createContext(display, config, nullptr, attributes);
    if (handle == nullptr) return false;
    if (api_.makeCurrent(display, nullptr, nullptr, handle) != 0) {
      display_ = display;
      handle_ = handle;
      return true;
    }
    api_.destroyContext(display, handle);
    return false;
  }

  bool fail(const char* action) {
    failure_ = fmt::format("cannot {} (EGL error {:#06x})", action, api_.getError());
    return false;
  }

  EglApi api_;
  ContextProfile profile_;
  EglDisplay display_ = nullptr;
  EglHandle handle_ = nullptr;
  std::string failure_ = "no display is offered";
};

}  // namespace

std::unique_ptr<Context> createEglContext(const ContextRequest& request, Diagnostics& diagnostics) {
  EglApi api;
  void* library = loadLibrary(request.eglLibraries);
  if (library == nullptr || !api.load(library)) {
    addError(diagnostics, "gl-library-missing", {},
             fmt::format("cannot load EGL (tried {})", fmt::join(request.eglLibraries, ", ")),
             "install libegl1 with libegl-mesa0, or run with --backend osmesa");
    return nullptr;
  }
  auto context = std::make_unique<EglContext>(api, request.profile);
  if (!context->create()) {
    addError(diagnostics, "gl-context-refused", {},
             "EGL gives no context: " + context->lastFailure(),
             "install libegl-mesa0 and libgl1-mesa-dri, or run with --backend osmesa");
    return nullptr;
  }
  if (!context->load(diagnostics)) return nullptr;
  return context;
}

}  // namespace orris::gl
