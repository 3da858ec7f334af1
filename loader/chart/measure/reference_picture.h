// What pictures are measured against, and how sure it is itself.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <orris/core/diagnostic.h>
#include <orris/image/image.h>

namespace orris {

/// Linear light, three channels. The halves share no random number, so that a product of two errors,
/// one against each, holds no noise of the reference.
struct ReferencePicture {
  ImageF mean, first, second;
  bool hasHalves = false;  ///< false: both are `mean`, its noise is unknown
  /// 1 for pixels that lie on an edge, whose reference is one surface or the other: they are no error.
  /// Empty: not known.
  std::vector<std::uint8_t> edges{};
};

/// Relative errors of luminance are to r + this share of the mean of r.
inline constexpr double kDarkShare = 0.02;

/// Standard error of the mean of the halves over the pixels, as a share of the mean luminance: the
/// `relative` of orris trace. 0 without halves.
double noiseFloor(const ReferencePicture& reference);
std::uint64_t fingerprint(const ReferencePicture& reference);

/// Rec. 709.
inline double luminanceOf(const float* rgb) {
  return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
}
double meanLuminance(const ImageF& image);

/// The first three channels; a single one three times.
ImageF toRgb(const ImageF& image);

/// A picture of `orris trace` (the mean, its two halves, and pixels on edges), or any other linear
/// picture. nullopt and a diagnostic for what cannot be read or is not finite.
std::optional<ReferencePicture> readReference(const std::string& path, Diagnostics& diagnostics);
/// Written as orris trace writes its own.
bool writeReference(const std::string& path, const ReferencePicture& reference,
                    Diagnostics& diagnostics);

}  // namespace orris
