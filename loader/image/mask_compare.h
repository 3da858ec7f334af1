// How far a mask of shadows is from the true one, edges apart.
#pragma once

#include <optional>

#include <orris/core/diagnostic.h>
#include <orris/image/image.h>

namespace orris {

/// Pixels of the first channel on different sides of one half. Those where the reference itself
/// changes, within the 3 x 3 around or within the pixel (grey), are edges: there a rounding decides;
/// the others are errors.
struct MaskDifference {
  long long pixels = 0, edge = 0, interior = 0;
  long long lit = 0;  ///< of the reference
  double edgeShare() const { return pixels == 0 ? 0 : double(edge) / double(pixels); }
};

/// nullopt and a diagnostic when the sizes differ.
std::optional<MaskDifference> compareMasks(const ImageF& mask, const ImageF& reference,
                                           Diagnostics& diagnostics);

/// Lit white and dark grey as in `reference`; wrong pixels red inside, yellow on edges. Sizes equal.
ImageF maskDifferenceImage(const ImageF& mask, const ImageF& reference);

}  // namespace orris
