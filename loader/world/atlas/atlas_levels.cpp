#include <orris/world/atlas/atlas_levels.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace orris {
namespace {

constexpr float kGamma = 2.2f;

std::array<float, 256> lightOfBytes() {
  std::array<float, 256> light{};
  for (int i = 0; i < 256; ++i) light[std::size_t(i)] = std::pow(float(i) / 255, kGamma);
  return light;
}

using FourBytes = std::array<std::uint8_t, 4>;

std::uint8_t plainMean(const FourBytes& four) {
  return std::uint8_t((four[0] + four[1] + four[2] + four[3] + 2) / 4);
}

/// `mean` of the four bytes of a channel.
Image8 halved(const Image8& image, auto&& mean) {
  Image8 half(std::max(1, image.width / 2), std::max(1, image.height / 2), 4);
  for (int y = 0; y < half.height; ++y)
    for (int x = 0; x < half.width; ++x) {
      const int x1 = std::min(2 * x + 1, image.width - 1);
      const int y1 = std::min(2 * y + 1, image.height - 1);
      const std::uint8_t* four[4] = {image.at(2 * x, 2 * y), image.at(x1, 2 * y),
                                     image.at(2 * x, y1), image.at(x1, y1)};
      for (int c = 0; c < 3; ++c)
        half.at(x, y)[c] = mean(std::array{four[0][c], four[1][c], four[2][c], four[3][c]});
      half.at(x, y)[3] = plainMean({four[0][3], four[1][3], four[2][3], four[3][3]});
    }
  return half;
}

std::vector<Image8> levelsOf(const Image8& image, int levels, auto&& mean) {
  std::vector<Image8> made{image};
  while (int(made.size()) < levels) made.push_back(halved(made.back(), mean));
  return made;
}

}  // namespace

std::vector<Image8> atlasLevels(const Image8& image, int levels) {
  const std::array<float, 256> light = lightOfBytes();
  return levelsOf(image, levels, [&](const FourBytes& four) {
    float sum = 0;
    for (const std::uint8_t byte : four) sum += light[byte];
    return std::uint8_t(std::lround(std::pow(sum / 4, 1 / kGamma) * 255));
  });
}

std::vector<Image8> dataLevels(const Image8& image, int levels) {
  return levelsOf(image, levels, plainMean);
}

}  // namespace orris
