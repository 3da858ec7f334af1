#include <orris/chart/measure/reference_picture.h>

#include <algorithm>
#include <cmath>

#include <orris/chart/study/digest.h>
#include <orris/core/add_diagnostic.h>

namespace orris {
namespace {

constexpr int kTraceChannels = 9;
constexpr int kEdgeChannel = 9;  // of ten

ImageF channelsFrom(const ImageF& image, int first) {
  ImageF result(image.width, image.height, 3);
  for (std::size_t i = 0; i < result.pixels.size() / 3; ++i)
    std::copy_n(&image.pixels[i * std::size_t(image.channels) + std::size_t(first)], 3,
                &result.pixels[i * 3]);
  return result;
}

/// Nine channels, or ten, may be anything: only a mean of two halves is the mean of two halves.
bool isMeanOfHalves(const ImageF& image) {
  if (image.channels != kTraceChannels && image.channels != kEdgeChannel + 1) return false;
  for (std::size_t i = 0; i < image.pixels.size(); i += std::size_t(image.channels)) {
    for (std::size_t c = i; c < i + 3; ++c) {
      const float mean = image.pixels[c], halves = (image.pixels[c + 3] + image.pixels[c + 6]) / 2;
      if (std::abs(mean - halves) > 1e-4f * (std::abs(mean) + std::abs(halves)) + 1e-6f)
        return false;
    }
  }
  return true;
}

}  // namespace

double meanLuminance(const ImageF& image) {
  const std::size_t count = image.pixels.size() / std::size_t(image.channels);
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i)
    sum += luminanceOf(&image.pixels[i * std::size_t(image.channels)]);
  return count == 0 ? 0 : sum / double(count);
}

double noiseFloor(const ReferencePicture& reference) {
  if (!reference.hasHalves) return 0;
  double sum = 0;
  const std::size_t count = reference.mean.pixels.size() / 3;
  for (std::size_t i = 0; i < count; ++i) {
    const double a = luminanceOf(&reference.first.pixels[i * 3]);
    const double b = luminanceOf(&reference.second.pixels[i * 3]);
    sum += (a - b) * (a - b) / 4;
  }
  const double mean = meanLuminance(reference.mean);
  return mean > 0 ? std::sqrt(sum / double(count)) / mean : 0;
}

std::uint64_t fingerprint(const ReferencePicture& reference) {
  Digest digest;
  digest.add(reference.mean.width).add(reference.hasHalves);
  for (const ImageF* image : {&reference.mean, &reference.first, &reference.second})
    digest.addBytes(image->pixels.data(), image->pixels.size() * sizeof(float));
  digest.addBytes(reference.edges.data(), reference.edges.size());
  return digest.value();
}

ImageF toRgb(const ImageF& image) {
  if (image.channels >= 3) return channelsFrom(image, 0);
  ImageF result(image.width, image.height, 3);
  for (std::size_t i = 0; i < result.pixels.size(); ++i)
    result.pixels[i] = image.pixels[i / 3 * std::size_t(image.channels)];
  return result;
}

std::optional<ReferencePicture> readReference(const std::string& path, Diagnostics& diagnostics) {
  const std::optional<ImageF> image = readImage(path, diagnostics);
  if (!image) return std::nullopt;
  if (!std::all_of(image->pixels.begin(), image->pixels.end(),
                   [](float value) { return std::isfinite(value); })) {
    addError(diagnostics, "reference-not-finite", {path}, "holds a value that is no number",
             "trace the reference again");
    return std::nullopt;
  }
  ReferencePicture result;
  result.hasHalves = isMeanOfHalves(*image);
  result.mean = toRgb(*image);
  result.first = result.hasHalves ? channelsFrom(*image, 3) : result.mean;
  result.second = result.hasHalves ? channelsFrom(*image, 6) : result.mean;
  if (result.hasHalves && image->channels > kEdgeChannel)
    for (std::size_t i = kEdgeChannel; i < image->pixels.size(); i += std::size_t(image->channels))
      result.edges.push_back(image->pixels[i] > 0.5f ? 1 : 0);
  return result;
}

bool writeReference(const std::string& path, const ReferencePicture& reference,
                    Diagnostics& diagnostics) {
  static const std::vector<std::string> kNames = {
      "R", "G", "B", "first.R", "first.G", "first.B", "second.R", "second.G", "second.B"};
  ImageF image(reference.mean.width, reference.mean.height, kTraceChannels);
  for (std::size_t i = 0; i < reference.mean.pixels.size() / 3; ++i) {
    float* to = &image.pixels[i * kTraceChannels];
    std::copy_n(&reference.mean.pixels[i * 3], 3, to);
    std::copy_n(&reference.first.pixels[i * 3], 3, to + 3);
    std::copy_n(&reference.second.pixels[i * 3], 3, to + 6);
  }
  return writeImage(path, image, kNames, diagnostics);
}

}  // namespace orris
