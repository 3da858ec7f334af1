#include <orris/plan/scene/snow_sheet.h>

#include <algorithm>

#include <orris/plan/scene/shapes.h>
#include <orris/world/atlas/block_atlas.h>

namespace orris {
namespace {

constexpr int kSnowTexels = 64;
constexpr std::uint32_t kDrawnFlakes = 10;  // of so many of the texture's flakes one falls

}  // namespace

Image8 snowSheet() {
  const Image8 flakes = textureImage("snow_flakes");
  Image8 sheet(kSnowTexels, kSnowTexels, 4);
  for (int y = 0; y < kSnowTexels; ++y)
    for (int x = 0; x < kSnowTexels; ++x) {
      const auto place = static_cast<std::uint32_t>(y * kSnowTexels + x);
      if (mixBits(place + 1) % kDrawnFlakes != 0) continue;
      std::copy_n(flakes.at(x % flakes.width, y % flakes.height), 4, sheet.at(x, y));
    }
  return sheet;
}

}  // namespace orris
