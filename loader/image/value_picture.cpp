#include <orris/image/value_picture.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace orris {
namespace {

constexpr std::array<std::uint8_t, 3> kNan{255, 0, 255}, kInfinite{0, 255, 255}, kNegative{0, 200, 60};
// Lighter from step to step, so that a print without colour has the same order.
constexpr float kRamp[][3] = {{8, 8, 60}, {90, 20, 140}, {200, 50, 90}, {250, 150, 40}, {255, 250, 190}};
constexpr int kRampSteps = int(std::size(kRamp)) - 1;
constexpr std::size_t kSamples = 1 << 16;
constexpr std::size_t kCutOneOf = 200;

/// The channels of a texel that are painted.
struct Shown {
  int first, count;
};

Shown shownOf(const ImageF& image, int channel) {
  if (channel < 0) return {0, std::min(image.channels, 3)};
  return {std::min(channel, image.channels - 1), 1};
}

std::pair<float, float> rangeOf(const ImageF& image, const Shown& shown) {
  const std::size_t texels = image.pixels.size() / std::size_t(image.channels);
  const std::size_t stride = texels / kSamples + 1;
  std::vector<float> values;
  for (std::size_t i = 0; i < texels; i += stride)
    for (int c = 0; c < shown.count; ++c) {
      const float value = image.pixels[i * std::size_t(image.channels) + std::size_t(shown.first + c)];
      if (std::isfinite(value)) values.push_back(value);
    }
  if (values.empty()) return {0, 1};
  const std::size_t cut = values.size() / kCutOneOf;
  const auto at = [&](std::size_t index) {
    const auto place = values.begin() + std::ptrdiff_t(index);
    std::nth_element(values.begin(), place, values.end());
    return *place;
  };
  const float low = at(cut), high = at(values.size() - 1 - cut);
  // One value everywhere, as after a clear: dark where it is 0, else as bright as it is.
  return low < high ? std::pair(low, high) : std::pair(std::min(low, 0.0f), std::max(high, 1.0f));
}

const std::array<std::uint8_t, 3>* markOf(const float* texel, const Shown& shown, bool negative) {
  const auto any = [&](auto is) { return std::any_of(texel, texel + shown.count, is); };
  if (any([](float v) { return std::isnan(v); })) return &kNan;
  if (any([](float v) { return std::isinf(v); })) return &kInfinite;
  return negative && any([](float v) { return v < 0; }) ? &kNegative : nullptr;
}

std::uint8_t byteOf(float share) { return std::uint8_t(std::lround(std::clamp(share, 0.0f, 1.0f) * 255)); }

}  // namespace

std::array<std::uint8_t, 3> falseColor(float share) {
  const float at = std::clamp(share, 0.0f, 1.0f) * kRampSteps;
  const int step = std::min(int(at), kRampSteps - 1);
  std::array<std::uint8_t, 3> color{};
  for (std::size_t c = 0; c < 3; ++c) {
    const float from = kRamp[step][c], to = kRamp[step + 1][c];
    color[c] = std::uint8_t(std::lround(from + (to - from) * (at - float(step))));
  }
  return color;
}

ValueFacts valueFacts(const ImageF& image) {
  ValueFacts facts{.channels = std::min(image.channels, 4)};
  constexpr float kMost = std::numeric_limits<float>::infinity();
  facts.low.fill(kMost);
  facts.high.fill(-kMost);
  for (std::size_t i = 0; i + std::size_t(image.channels) <= image.pixels.size();
       i += std::size_t(image.channels)) {
    bool nan = false, infinite = false, negative = false;
    for (std::size_t c = 0; c < std::size_t(facts.channels); ++c) {
      const float value = image.pixels[i + c];
      nan |= std::isnan(value);
      infinite |= std::isinf(value);
      negative |= value < 0;
      if (!std::isfinite(value)) continue;
      facts.low[c] = std::min(facts.low[c], value);
      facts.high[c] = std::max(facts.high[c], value);
    }
    facts.nan += nan;
    facts.infinite += infinite;
    facts.negative += negative;
  }
  for (std::size_t c = 0; c < 4; ++c)
    if (facts.low[c] > facts.high[c]) facts.low[c] = facts.high[c] = 0;
  return facts;
}

std::pair<float, float> paintedRange(const ImageF& image, const ValuePaint& paint) {
  if (paint.range) return *paint.range;
  if (image.channels < 1 || image.pixels.empty()) return {0, 1};
  return rangeOf(image, shownOf(image, paint.channel));
}

Image8 paintValues(const ImageF& image, const ValuePaint& paint) {
  Image8 result(image.width, image.height, 3);
  if (image.channels < 1 || image.pixels.empty()) return result;
  const Shown shown = shownOf(image, paint.channel);
  const auto [low, high] = paintedRange(image, paint);
  const float least = low, width = high - low;
  const auto share = [&](float value) { return width == 0 ? 0 : (value - least) / width; };
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const float* texel = image.at(x, y) + shown.first;
      std::uint8_t* pixel = result.at(x, y);
      if (const auto* mark = markOf(texel, shown, paint.markNegative)) {
        std::copy_n(mark->begin(), 3, pixel);
      } else if (paint.falseColor) {
        float sum = 0;
        for (int c = 0; c < shown.count; ++c) sum += texel[c];
        const auto color = falseColor(share(sum / float(shown.count)));
        std::copy_n(color.begin(), 3, pixel);
      } else {
        // Of two channels blue is none, one is grey.
        for (int c = 0; c < 3; ++c)
          pixel[c] = shown.count == 1 ? byteOf(share(texel[0])) : c < shown.count ? byteOf(share(texel[c])) : 0;
      }
    }
  return result;
}

}  // namespace orris
