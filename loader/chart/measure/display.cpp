#include <orris/chart/measure/display.h>

#include <algorithm>
#include <cmath>

#include <orris/chart/measure/statistics.h>
#include <orris/image/image_compare.h>

namespace orris {
namespace {

constexpr double kBright = 0.95;
constexpr double kFullColour = 0.5;

float toSrgb(float value) {
  const float v = std::isfinite(value) ? std::clamp(value, 0.0f, 1.0f) : 0.0f;
  return v <= 0.0031308f ? 12.92f * v : 1.055f * std::pow(v, 1 / 2.4f) - 0.055f;
}

ImageF encoded(const ImageF& linear, float exposure) {
  ImageF result = linear;
  for (float& value : result.pixels) value = toSrgb(value * exposure);
  return result;
}

}  // namespace

float displayExposure(const ReferencePicture& reference) {
  std::vector<double> luminance;
  for (std::size_t i = 0; i + 2 < reference.mean.pixels.size(); i += 3)
    luminance.push_back(luminanceOf(&reference.mean.pixels[i]));
  const double bright = quantile(std::move(luminance), kBright);
  return bright > 1 ? static_cast<float>(1 / bright) : 1.0f;
}

Image8 displayed(const ImageF& linear, float exposure) {
  Image8 result(linear.width, linear.height, linear.channels);
  for (std::size_t i = 0; i < result.pixels.size(); ++i)
    result.pixels[i] =
        static_cast<std::uint8_t>(std::lround(toSrgb(linear.pixels[i] * exposure) * 255));
  return result;
}

double displayedSimilarity(const ImageF& image, const ImageF& reference, float exposure) {
  Diagnostics ignored;  // sizes are equal
  const auto difference =
      compareImages(encoded(image, exposure), encoded(reference, exposure), 0, ignored);
  return difference ? difference->ssim : 0;
}

Image8 signedDifference(const ImageF& image, const ImageF& reference) {
  Image8 result(image.width, image.height, 3);
  const double dark = kDarkShare * meanLuminance(reference);
  for (std::size_t i = 0; i + 2 < result.pixels.size(); i += 3) {
    const double r = luminanceOf(&reference.pixels[i]), scale = r + dark;
    const double error = scale > 0 ? (luminanceOf(&image.pixels[i]) - r) / scale : 0;
    const double share = std::isfinite(error) ? std::clamp(error / kFullColour, -1.0, 1.0) : 1;
    const auto faded = static_cast<std::uint8_t>(std::lround(255 * (1 - std::abs(share))));
    result.pixels[i] = share < 0 ? faded : 255;
    result.pixels[i + 1] = faded;
    result.pixels[i + 2] = share > 0 ? faded : 255;
  }
  return result;
}

}  // namespace orris
