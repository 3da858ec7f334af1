// Linear pictures as people look at them.
#pragma once

#include <orris/chart/measure/reference_picture.h>

namespace orris {

/// Factor that brings the bright parts of a reference (95th percentile of luminance) just below white;
/// never above 1, so that pictures within 0..1 stay as they are.
float displayExposure(const ReferencePicture& reference);

/// Times the exposure, cut to 0..1, encoded as sRGB.
Image8 displayed(const ImageF& linear, float exposure);

/// Structural similarity (image/image_compare.h) of two linear pictures as displayed.
double displayedSimilarity(const ImageF& image, const ImageF& reference, float exposure);

/// Where a picture is too bright (red) and too dark (blue): the luminance error relative to
/// r + 0.02 * mean, in full colour from a half on.
Image8 signedDifference(const ImageF& image, const ImageF& reference);

}  // namespace orris
