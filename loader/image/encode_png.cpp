#include <orris/image/encode_png.h>

#include <orris/core/add_diagnostic.h>
#include <orris/image/png_file.h>

namespace orris {
namespace {

template <class Image>
std::optional<std::string> encodeAny(const Image& image, const std::string& file,
                                     Diagnostics& diagnostics) {
  std::string reason;
  auto bytes = pngOf(image, reason);
  if (!bytes) addError(diagnostics, "image-write", {file}, "cannot make a PNG of its picture: " + reason);
  return bytes;
}

}  // namespace

std::optional<std::string> encodePng(const Image16& image, const std::string& file,
                                     Diagnostics& diagnostics) {
  return encodeAny(image, file, diagnostics);
}

std::optional<std::string> encodePng(const Image8& image, const std::string& file,
                                     Diagnostics& diagnostics) {
  return encodeAny(image, file, diagnostics);
}

}  // namespace orris
