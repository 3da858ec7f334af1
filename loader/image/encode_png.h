// PNG files in memory, for files that hold pictures.
#pragma once

#include <optional>
#include <string>

#include <orris/image/image.h>

namespace orris {

using Image16 = BasicImage<std::uint16_t>;

/// The bytes of a PNG of 16 or 8 bits a channel; same pixels, same bytes. nullopt and a diagnostic that names `file` on failure.
std::optional<std::string> encodePng(const Image16& image, const std::string& file,
                                     Diagnostics& diagnostics);
std::optional<std::string> encodePng(const Image8& image, const std::string& file,
                                     Diagnostics& diagnostics);

}  // namespace orris
