// Pixels in memory and their files. OpenImageIO stays in a module (image/codecs) of its own.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <orris/core/diagnostic.h>

namespace orris {

/// Row-major, top row first, `channels` floats or bytes a pixel.
template <class T>
struct BasicImage {
  int width = 0, height = 0, channels = 4;
  std::vector<T> pixels;
  BasicImage() = default;
  BasicImage(int w, int h, int c) : width(w), height(h), channels(c), pixels(size_t(w) * h * c) {}
  T* at(int x, int y) { return &pixels[(size_t(y) * width + x) * channels]; }
  const T* at(int x, int y) const { return &pixels[(size_t(y) * width + x) * channels]; }
};
using Image8 = BasicImage<std::uint8_t>;
using ImageF = BasicImage<float>;

/// Decodes an image file's bytes (PNG, TGA, JPEG...) to RGBA8. nullopt and a diagnostic naming
/// `name` when it cannot; sizes over 16384 are refused.
std::optional<Image8> decodeImage(const std::string& bytes, const std::string& name,
                                  Diagnostics& diagnostics);

/// Reads any image file as float, values of integer files divided by their maximum; PNG and JPEG
/// are left in their display encoding.
std::optional<ImageF> readImage(const std::string& path, Diagnostics& diagnostics);

/// Whether files with this ending keep colours as they are displayed, 8 bits a channel (.png, .jpg); others
/// (.exr, .hdr, .pfm, .tif) can keep linear values.
bool isDisplayFormat(const std::string& path);

/// Writes by extension: .png 8 bit, .exr 32 bit float (integer images as float), .pfm/.hdr/.tif as
/// OpenImageIO does. Written to a temporary file beside `path` and renamed, so no partial file is
/// ever left. Same pixels, same bytes (no time stamps). false and a diagnostic on failure.
bool writeImage(const std::string& path, const Image8& image, Diagnostics& diagnostics);
bool writeImage(const std::string& path, const ImageF& image, Diagnostics& diagnostics);
/// With a name for each channel ("R", "first.R"), which .exr files keep.
bool writeImage(const std::string& path, const ImageF& image,
                const std::vector<std::string>& channelNames, Diagnostics& diagnostics);

}  // namespace orris
