// OSMesa, loaded at run time and without its header: newer Mesa has neither.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

#include <orris/core/add_diagnostic.h>
#include <orris/gl/context_backends.h>
#include <orris/gl/functions.h>

namespace orris::gl {
namespace {

using OsmesaHandle = void*;

constexpr int kFormat = 0x22;
constexpr int kDepthBits = 0x30;
constexpr int kProfile = 0x33;
constexpr int kCoreProfile = 0x34;
constexpr int kCompatProfile = 0x35;
constexpr int kOsMesaMajor = 0x36;
constexpr int kOsMesaMinor = 0x37;

struct OsmesaApi {
  OsmesaHandle (*createContextAttribs)(const int* attributes, OsmesaHandle share) = nullptr;
  GLboolean (*makeCurrent)(OsmesaHandle, void* buffer, GLenum type, GLsizei width,
                           GLsizei height) = nullptr;
  void (*destroyContext)(OsmesaHandle) = nullptr;
  void (*(*getProcAddress)(const char*))() = nullptr;

  bool load(void* library) {
    const auto resolve = [library](auto& function, const char* name) {
      function = reinterpret_cast<std::decay_t<decltype(function)>>(findSymbol(library, name));
      return function != nullptr;
    };
    return resolve(createContextAttribs, "OSMesaCreateContextAttribs") &&
           resolve(makeCurrent, "OSMesaMakeCurrent") &&
           resolve(destroyContext, "OSMesaDestroyContext") &&
           resolve(getProcAddress, "OSMesaGetProcAddress");
  }
};

class OsmesaContext final : public Context {
 public:
  explicit OsmesaContext(const OsmesaApi& api) : api_(api) {}
  ~OsmesaContext() override {
    if (handle_ == nullptr) return;
    api_.makeCurrent(nullptr, nullptr, 0, 0, 0);
    api_.destroyContext(handle_);
  }
  Backend backend() const override { return Backend::OSMesa; }

  bool create(ContextProfile asked, Diagnostics& diagnostics) {
    for (const ContextProfile profile : profilesToTry(asked)) {
      for (const GlVersion& version : kVersions) {
        if (handle_ == nullptr) handle_ = createOne(profile, version);
      }
    }
    // The library wants a buffer; frames are drawn into framebuffer objects.
    if (handle_ == nullptr || !bind()) {
      addError(diagnostics, "gl-context-refused", {}, "OSMesa gives no " + describeWanted(asked),
               "install Mesa 21 or newer, or run with --backend egl");
      return false;
    }
    const auto resolve = [this](const char* name) {
      return reinterpret_cast<void*>(api_.getProcAddress(name));
    };
    return initialise(resolve, diagnostics);
  }

 protected:
  bool bind() override {
    return api_.makeCurrent(handle_, pixel_.data(), GL_UNSIGNED_BYTE, 1, 1) != GL_FALSE;
  }

 private:
  OsmesaHandle createOne(ContextProfile profile, const GlVersion& version) const {
    const int mask = profile == ContextProfile::Core ? kCoreProfile : kCompatProfile;
    const int attributes[] = {kFormat,       GL_RGBA,      kDepthBits,    24, kProfile, mask, kOsMesaMajor,
                              version.major, kOsMesaMinor, version.minor, 0};
    return api_.createContextAttribs(attributes, nullptr);
  }

  OsmesaApi api_;
  OsmesaHandle handle_ = nullptr;
  std::array<unsigned char, 4> pixel_{};
};

}  // namespace

std::unique_ptr<Context> createOsmesaContext(const ContextRequest& request,
                                             Diagnostics& diagnostics) {
  OsmesaApi api;
  void* library = loadLibrary(request.osmesaLibraries);
  if (library == nullptr || !api.load(library)) {
    addError(diagnostics, "gl-library-missing", {},
             fmt::format("cannot load OSMesa (tried {})", fmt::join(request.osmesaLibraries, ", ")),
             "install libosmesa6 where the system still has it, or run with --backend egl");
    return nullptr;
  }
  auto context = std::make_unique<OsmesaContext>(api);
  if (!context->create(request.profile, diagnostics)) return nullptr;
  return context;
}

}  // namespace orris::gl
