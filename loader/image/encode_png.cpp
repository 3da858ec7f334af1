#include <orris/image/encode_png.h>

#include <orris/core/add_diagnostic.h>
#include <orris/image/codecs/image_codecs.h>

namespace orris {
namespace {

template <class Image>
std::optional<std::string> encodeAny(const Image& image, const std::string& file,
                                     Diagnostics& diagnostics) {
  const ImageCodecs* codecs = imageCodecs(file, diagnostics);
  if (!codecs) return std::nullopt;
  std::string bytes;
  const auto reason = codecs->encode(".png", image, bytes);
  if (!reason) return bytes;
  addError(diagnostics, "image-write", {file}, "cannot make a PNG of its picture: " + *reason);
  return std::nullopt;
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
