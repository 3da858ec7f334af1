// How far an image is from a reference.
#pragma once

#include <optional>

#include <orris/core/diagnostic.h>
#include <orris/image/image.h>

namespace orris {

/// Over the colour channels (the first three at most, alpha is ignored), values as stored: compare
/// linear files for rmse and relMse, display files for ssim.
struct ImageDifference {
  double rmse = 0;           ///< root of the mean squared difference
  double relMse = 0;         ///< mean of (x-r)^2 / (r^2 + 0.01), r the reference
  double maxAbsolute = 0;    ///< largest difference of one channel
  double fractionAbove = 0;  ///< share of pixels, 0..1, with a channel over the threshold
  double ssim = 1;           ///< Wang et al. 2004 on luma clamped to 0..1: 11x11 Gaussian of sigma
                             ///< 1.5; mean over whole windows, 1 is equal
};

/// nullopt and a diagnostic when the sizes or the numbers of colour channels differ. A pair with a
/// NaN or an infinity gives infinite errors and ssim 0.
std::optional<ImageDifference> compareImages(const ImageF& image, const ImageF& reference,
                                             float threshold, Diagnostics& diagnostics);

/// |image - reference| * gain by channel, alpha 1; sizes must be equal.
ImageF differenceImage(const ImageF& image, const ImageF& reference, float gain);

}  // namespace orris
