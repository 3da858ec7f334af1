// A GL context that a test made itself, as an engine would: OSMesa, with none of Orris's code.
#pragma once

#include <dlfcn.h>
#define GL_GLEXT_PROTOTYPES 1
#include <GL/gl.h>
#include <GL/glext.h>

#include <array>

namespace orris_test {

class OwnContext {
 public:
  explicit OwnContext(bool core) {
    library_ = dlopen("libOSMesa.so.8", RTLD_NOW);
    if (library_ == nullptr) return;
    const auto create = find<void* (*)(const int*, void*)>("OSMesaCreateContextAttribs");
    // Format RGBA, depth of 24 bits, profile, version 4.5.
    const int attributes[] = {0x22, GL_RGBA, 0x30, 24, 0x33, core ? 0x34 : 0x35,
                              0x36, 4,       0x37, 5,  0};
    handle_ = create(attributes, nullptr);
    makeCurrent();
  }
  ~OwnContext() {
    if (handle_ == nullptr) return;
    release();
    find<void (*)(void*)>("OSMesaDestroyContext")(handle_);
  }
  explicit operator bool() const { return handle_ != nullptr; }
  void makeCurrent() { bind(handle_, pixels_.data()); }
  void release() { bind(nullptr, nullptr); }

  /// A GL function by its name, of the type of its prototype.
  template <typename Function>
  Function get(const char* name) const {
    return reinterpret_cast<Function>(address(name));
  }
  void* address(const char* name) const {
    return reinterpret_cast<void*>(find<void (*(*)(const char*))()>("OSMesaGetProcAddress")(name));
  }
  /// For orris_context_adopt().
  static void* resolve(const char* name, void* user) {
    return static_cast<const OwnContext*>(user)->address(name);
  }

 private:
  template <typename Function>
  Function find(const char* name) const {
    return reinterpret_cast<Function>(dlsym(library_, name));
  }
  void bind(void* handle, void* pixels) {
    find<GLboolean (*)(void*, void*, GLenum, GLsizei, GLsizei)>("OSMesaMakeCurrent")(
        handle, pixels, GL_UNSIGNED_BYTE, 4, 4);
  }

  void* library_ = nullptr;
  void* handle_ = nullptr;
  std::array<unsigned char, 64> pixels_{};
};

#define OWN_GL(context, name) (context).get<decltype(&::gl##name)>("gl" #name)

}  // namespace orris_test
