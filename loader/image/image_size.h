// The size of a picture as people write it: "640x360".
#pragma once

#include <optional>
#include <string_view>

namespace orris {

inline constexpr int kMaxSide = 16384;        ///< of pictures in files, too
inline constexpr long kMaxPixels = 1L << 25;  ///< one RGBA16F target of this size is 256 MiB

struct ImageSize {
  int width = 0, height = 0;
  auto operator<=>(const ImageSize&) const = default;
};

/// nullopt for other texts, and for sizes beyond the limits.
std::optional<ImageSize> parseImageSize(std::string_view text);

}  // namespace orris
