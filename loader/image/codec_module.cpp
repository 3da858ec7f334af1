#include <dlfcn.h>
#include <fmt/format.h>

#include <filesystem>
#include <vector>

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

std::string imageCodecsFile() {
  // The folders in which dlopen() looks.
  void* program = dlopen(nullptr, RTLD_LAZY);
  Dl_serinfo size{};
  if (!program || dlinfo(program, RTLD_DI_SERINFOSIZE, &size) != 0) return "";
  std::vector<std::max_align_t> memory(size.dls_size / sizeof(std::max_align_t) + 1);
  auto* info = reinterpret_cast<Dl_serinfo*>(memory.data());
  *info = size;
  if (dlinfo(program, RTLD_DI_SERINFO, info) != 0) return "";
  for (unsigned i = 0; i < info->dls_cnt; ++i) {
    const auto file = std::filesystem::path(info->dls_serpath[i].dls_name) / ORRIS_CODECS_MODULE;
    std::error_code error;
    if (std::filesystem::is_regular_file(file, error)) return file.string();
  }
  return "";
}

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
