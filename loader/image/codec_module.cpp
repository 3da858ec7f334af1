#include <dlfcn.h>
#include <fmt/format.h>

#include <orris/core/add_diagnostic.h>
#include <orris/image/codecs/image_codecs.h>

namespace orris {
namespace {

struct LoadedCodecs {
  const ImageCodecs* codecs = nullptr;
  std::string reason;
};

LoadedCodecs loadCodecs() {
  LoadedCodecs loaded;
  // Found by the run path of the program, which cmake/OrrisCodecs.cmake gives it.
  if (void* module = dlopen(ORRIS_CODECS_MODULE, RTLD_LAZY | RTLD_LOCAL)) {
    using Codecs = const ImageCodecs* (*)();
    if (const auto codecs = reinterpret_cast<Codecs>(dlsym(module, kImageCodecsFunction)))
      loaded.codecs = codecs();
  }
  if (!loaded.codecs) {
    const char* text = dlerror();
    loaded.reason = text ? text : "unknown reason";
  }
  return loaded;
}

}  // namespace

const ImageCodecs* imageCodecs(const std::string& picture, Diagnostics& diagnostics) {
  static const LoadedCodecs loaded = loadCodecs();
  if (!loaded.codecs) {
    addError(diagnostics, "image-codecs", {picture},
             fmt::format("the picture codecs of Orris cannot be loaded: {}", loaded.reason),
             "install Orris again: its module of codecs or a library of OpenImageIO is missing");
  }
  return loaded.codecs;
}

}  // namespace orris
