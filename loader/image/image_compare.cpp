#include <orris/image/image_compare.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

#include <orris/core/add_diagnostic.h>

namespace orris {
namespace {

constexpr int kWindow = 11;
constexpr double kSigma = 1.5;
constexpr double kC1 = 0.01 * 0.01;
constexpr double kC2 = 0.03 * 0.03;

int colourChannels(const ImageF& image) {
  return image.channels == 2 ? 1 : std::min(image.channels, 3);
}

bool allFinite(const ImageF& image) {
  return std::all_of(image.pixels.begin(), image.pixels.end(),
                     [](float value) { return std::isfinite(value); });
}

ImageF colourOnly(const ImageF& image) {
  const int channels = colourChannels(image);
  ImageF result(image.width, image.height, channels);
  const size_t count = size_t(image.width) * image.height;
  for (size_t i = 0; i < count; ++i) {
    std::copy_n(&image.pixels[i * image.channels], channels, &result.pixels[i * channels]);
  }
  return result;
}

/// All but ssim. Both have the same size and channels and at least one pixel.
ImageDifference differenceOf(const ImageF& image, const ImageF& reference, float threshold) {
  double squared = 0, relative = 0, maximum = 0;
  std::size_t pixelsAbove = 0;
  const auto channels = std::size_t(image.channels);
  for (std::size_t begin = 0; begin < image.pixels.size(); begin += channels) {
    double ofPixel = 0;
    for (std::size_t i = begin; i < begin + channels; ++i) {
      const double r = reference.pixels[i], difference = image.pixels[i] - r;
      squared += difference * difference;
      relative += difference * difference / (r * r + 0.01);
      ofPixel = std::max(ofPixel, std::abs(difference));
    }
    maximum = std::max(maximum, ofPixel);
    pixelsAbove += ofPixel > threshold;
  }
  const auto values = double(image.pixels.size());
  return {.rmse = std::sqrt(squared / values),
          .relMse = relative / values,
          .maxAbsolute = maximum,
          .fractionAbove = double(pixelsAbove) * double(channels) / values};
}

/// One value a pixel, row-major.
struct Plane {
  int width = 0, height = 0;
  std::vector<double> values;
};

/// Rec. 709 luma clamped to 0..1.
Plane lumaOf(const ImageF& image) {
  Plane plane{image.width, image.height, std::vector<double>(size_t(image.width) * image.height)};
  for (size_t i = 0; i < plane.values.size(); ++i) {
    const float* p = &image.pixels[i * image.channels];
    const double luma = image.channels < 3 ? p[0] : 0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2];
    plane.values[i] = std::clamp(luma, 0.0, 1.0);
  }
  return plane;
}

std::vector<double> gaussian(int taps) {
  std::vector<double> weights(taps);
  double sum = 0;
  for (int i = 0; i < taps; ++i) {
    const double x = i - (taps - 1) / 2.0;
    sum += weights[i] = std::exp(-x * x / (2 * kSigma * kSigma));
  }
  for (double& weight : weights) weight /= sum;
  return weights;
}

/// Weighted mean over each whole window; a side shorter than the window is one window.
Plane windowMeans(const Plane& plane) {
  const std::vector<double> across = gaussian(std::min(kWindow, plane.width));
  const std::vector<double> down = gaussian(std::min(kWindow, plane.height));
  const int width = plane.width - int(across.size()) + 1;
  const int height = plane.height - int(down.size()) + 1;
  Plane rows{width, plane.height, std::vector<double>(size_t(width) * plane.height)};
  for (int y = 0; y < plane.height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double* from = &plane.values[size_t(y) * plane.width + x];
      double sum = 0;
      for (size_t i = 0; i < across.size(); ++i) sum += across[i] * from[i];
      rows.values[size_t(y) * width + x] = sum;
    }
  }
  Plane result{width, height, std::vector<double>(size_t(width) * height)};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      double sum = 0;
      for (size_t i = 0; i < down.size(); ++i) sum += down[i] * rows.values[(y + i) * width + x];
      result.values[size_t(y) * width + x] = sum;
    }
  }
  return result;
}

Plane product(const Plane& a, const Plane& b) {
  Plane result = a;
  for (size_t i = 0; i < result.values.size(); ++i) result.values[i] *= b.values[i];
  return result;
}

double structuralSimilarity(const ImageF& image, const ImageF& reference) {
  const Plane a = lumaOf(image), b = lumaOf(reference);
  const Plane meanA = windowMeans(a), meanB = windowMeans(b);
  const Plane aa = windowMeans(product(a, a)), bb = windowMeans(product(b, b));
  const Plane ab = windowMeans(product(a, b));
  double sum = 0;
  for (size_t i = 0; i < meanA.values.size(); ++i) {
    const double ma = meanA.values[i], mb = meanB.values[i];
    const double varianceA = aa.values[i] - ma * ma, varianceB = bb.values[i] - mb * mb;
    const double covariance = ab.values[i] - ma * mb;
    sum += (2 * ma * mb + kC1) * (2 * covariance + kC2) /
           ((ma * ma + mb * mb + kC1) * (varianceA + varianceB + kC2));
  }
  return sum / double(meanA.values.size());
}

std::string describe(const ImageF& image) {
  return fmt::format("{}x{} with {} colour channels", image.width, image.height,
                     colourChannels(image));
}

}  // namespace

std::optional<ImageDifference> compareImages(const ImageF& image, const ImageF& reference,
                                             float threshold, Diagnostics& diagnostics) {
  const bool comparable = image.width == reference.width && image.height == reference.height &&
                          colourChannels(image) == colourChannels(reference) &&
                          !image.pixels.empty();
  if (!comparable) {
    addError(diagnostics, "compare-size", {},
             fmt::format("the images cannot be compared: {} against {}", describe(image),
                         describe(reference)),
             "compare images of one size");
    return std::nullopt;
  }
  const ImageF a = colourOnly(image), b = colourOnly(reference);
  if (!allFinite(a) || !allFinite(b)) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    return ImageDifference{kInfinity, kInfinity, kInfinity, 1, 0};
  }
  ImageDifference result = differenceOf(a, b, threshold);
  result.ssim = structuralSimilarity(a, b);
  return result;
}

ImageF differenceImage(const ImageF& image, const ImageF& reference, float gain) {
  assert(image.width == reference.width && image.height == reference.height);
  const ImageF a = colourOnly(image), b = colourOnly(reference);
  ImageF result(a.width, a.height, 4);
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      float* to = result.at(x, y);
      for (int c = 0; c < 3; ++c) {
        const float difference =
            a.at(x, y)[std::min(c, a.channels - 1)] - b.at(x, y)[std::min(c, b.channels - 1)];
        to[c] = std::abs(difference) * gain;
      }
      to[3] = 1;
    }
  }
  return result;
}

}  // namespace orris
