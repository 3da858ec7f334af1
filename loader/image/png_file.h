// PNG files in memory, without the module of codecs: most runs read and write no other picture.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <orris/image/image.h>

namespace orris {

/// What the header states; nothing of it is checked yet. Channels are those of decodePng(), bits those of one
/// channel in the file.
struct PngHeader {
  int width = 0, height = 0, channels = 0, bits = 8;
};
/// nullopt and the reason where there is no whole header.
std::optional<PngHeader> readPngHeader(const std::string& bytes, std::string& reason);

/// All pixels as they are stored, colour not multiplied by alpha: 16 bits a channel are rounded to 8, fewer
/// bits and palettes are expanded, a transparent colour becomes alpha. nullopt and the reason where the file
/// is damaged.
std::optional<Image8> decodePng(const std::string& bytes, std::string& reason);

/// A file of 1 to 4 channels; same pixels, same bytes. nullopt and the reason where it cannot be one.
std::optional<std::string> pngOf(const Image8& image, std::string& reason);
std::optional<std::string> pngOf(const BasicImage<std::uint16_t>& image, std::string& reason);

}  // namespace orris
