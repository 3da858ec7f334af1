#include <orris/image/mask_compare.h>

#include <fmt/format.h>

#include <algorithm>

#include <orris/core/add_diagnostic.h>

namespace orris {
namespace {

bool litAt(const ImageF& mask, int x, int y) {
  return mask.at(std::clamp(x, 0, mask.width - 1), std::clamp(y, 0, mask.height - 1))[0] > 0.5f;
}

bool isEdge(const ImageF& reference, int x, int y) {
  const float value = reference.at(x, y)[0];
  if (value > 0.1f && value < 0.9f) return true;
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx)
      if (litAt(reference, x + dx, y + dy) != litAt(reference, x, y)) return true;
  return false;
}

}  // namespace

std::optional<MaskDifference> compareMasks(const ImageF& mask, const ImageF& reference,
                                           Diagnostics& diagnostics) {
  if (mask.width != reference.width || mask.height != reference.height) {
    addError(diagnostics, "compare-size", {},
             fmt::format("the masks differ in size: {}x{} and {}x{}", mask.width, mask.height,
                         reference.width, reference.height));
    return std::nullopt;
  }
  MaskDifference difference;
  for (int y = 0; y < mask.height; ++y)
    for (int x = 0; x < mask.width; ++x) {
      ++difference.pixels;
      difference.lit += litAt(reference, x, y);
      if (litAt(mask, x, y) == litAt(reference, x, y)) continue;
      ++(isEdge(reference, x, y) ? difference.edge : difference.interior);
    }
  return difference;
}

ImageF maskDifferenceImage(const ImageF& mask, const ImageF& reference) {
  ImageF picture(mask.width, mask.height, 3);
  for (int y = 0; y < mask.height; ++y)
    for (int x = 0; x < mask.width; ++x) {
      const bool lit = litAt(reference, x, y), wrong = litAt(mask, x, y) != lit;
      const float grey = lit ? 0.8f : 0.2f;
      float* pixel = picture.at(x, y);
      pixel[0] = wrong ? 1 : grey;
      pixel[1] = wrong ? (isEdge(reference, x, y) ? 1.0f : 0.0f) : grey;
      pixel[2] = wrong ? 0 : grey;
    }
  return picture;
}

}  // namespace orris
