#include <orris/world/atlas/mixed_atlas.h>

#include <algorithm>
#include <cmath>

#include <orris/world/atlas/atlas_levels.h>

namespace orris {
namespace {

constexpr int kUnit = 16;  // texels of the smallest tile

int sideOf(const NamedTile& tile) {
  int side = kUnit;
  while (side < tile.images.albedo.width || side < tile.images.albedo.height) side *= 2;
  return side;
}

std::size_t unitsOf(const std::vector<NamedTile>& tiles) {
  std::size_t units = 0;
  for (const NamedTile& tile : tiles)
    units += std::size_t(sideOf(tile) / kUnit) * std::size_t(sideOf(tile) / kUnit);
  return units;
}

void eachImage(TileImages& images, auto&& change) {
  for (Image8* image : {&images.albedo, &images.normal, &images.specular})
    if (image->width > 0) change(*image);
}

void eachImage(NamedTile& tile, auto&& change) {
  eachImage(tile.images, change);
  if (!tile.animation) return;
  for (TileImages& frame : tile.animation->frames) eachImage(frame, change);
}

int largestOf(const std::vector<NamedTile>& tiles) {
  int largest = kUnit;
  for (const NamedTile& tile : tiles) largest = std::max(largest, sideOf(tile));
  return largest;
}

void halveLargest(std::vector<NamedTile>& tiles) {
  const int largest = largestOf(tiles);
  for (NamedTile& tile : tiles) {
    if (sideOf(tile) < largest) continue;
    eachImage(tile, [](Image8& image) { image = atlasLevels(image, 2).back(); });
  }
}

/// Texture coordinates would be in the middle of a coarse level's texel.
void enlarge(NamedTile& tile) {
  const int side = std::max(tile.images.albedo.width, tile.images.albedo.height);
  const int factor = kUnit / side;
  if (factor < 2) return;
  eachImage(tile, [&](Image8& image) {
    Image8 large(image.width * factor, image.height * factor, 4);
    for (int y = 0; y < large.height; ++y)
      for (int x = 0; x < large.width; ++x)
        std::copy_n(image.at(x / factor, y / factor), 4, large.at(x, y));
    image = std::move(large);
  });
}

void fillHoles(Image8& image) {
  std::uint64_t sum[4] = {};
  for (std::size_t i = 0; i + 3 < image.pixels.size(); i += 4) {
    for (std::size_t c = 0; c < 3; ++c) sum[c] += image.pixels[i + c] * image.pixels[i + 3];
    sum[3] += image.pixels[i + 3];
  }
  for (std::size_t i = 0; sum[3] > 0 && i + 3 < image.pixels.size(); i += 4) {
    if (image.pixels[i + 3] != 0) continue;
    for (std::size_t c = 0; c < 3; ++c) image.pixels[i + c] = std::uint8_t(sum[c] / sum[3]);
  }
}

/// The place of unit `index` in Z-order: every run of 4^n units from a multiple of 4^n on is a square.
glm::ivec2 unitPlace(std::size_t index) {
  glm::ivec2 place(0);
  for (int bit = 0; bit < 15; ++bit) {
    place.x |= int(index >> (2 * bit) & 1) << bit;
    place.y |= int(index >> (2 * bit + 1) & 1) << bit;
  }
  return place;
}

/// What lies beside a texture in its square repeats its last texels.
void putClamped(Image8& image, const Image8& tile, glm::ivec2 corner, int side) {
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      std::copy_n(tile.at(std::min(x, tile.width - 1), std::min(y, tile.height - 1)), 4,
                  image.at(corner.x + x, corner.y + y));
}

/// The frames as squares for the tile's place.
TileAnimation placed(TileAnimation animation, glm::ivec2 corner, int side) {
  animation.corner = corner;
  for (TileImages& frame : animation.frames) {
    fillHoles(frame.albedo);
    eachImage(frame, [&](Image8& image) {
      Image8 square(side, side, 4);
      putClamped(square, image, {0, 0}, side);
      image = std::move(square);
    });
  }
  return animation;
}

void makeEmpty(BlockAtlas& atlas, std::size_t units) {
  int columns = 1, rows = 1;
  while (std::size_t(columns) * std::size_t(rows) < units) (columns <= rows ? columns : rows) *= 2;
  const Image8 empty(columns * kUnit, rows * kUnit, 4);
  atlas.albedo = atlas.normal = atlas.specular = empty;
  for (std::size_t i = 0; i < atlas.normal.pixels.size(); ++i)
    atlas.normal.pixels[i] = i % 4 < 2 ? 127 : 255;
}

}  // namespace

bool packTiles(std::vector<NamedTile> tiles, BlockAtlas& atlas, std::size_t mostTexels) {
  const std::size_t mostUnits = mostTexels / (kUnit * kUnit);
  for (NamedTile& tile : tiles) enlarge(tile);
  bool whole = true;
  for (; unitsOf(tiles) > mostUnits && largestOf(tiles) > kUnit; whole = false) halveLargest(tiles);
  std::sort(tiles.begin(), tiles.end(), [](const NamedTile& a, const NamedTile& b) {
    const int sideA = sideOf(a), sideB = sideOf(b);
    return sideA != sideB ? sideA > sideB : a.name < b.name;
  });
  makeEmpty(atlas, unitsOf(tiles));
  const glm::vec2 size(atlas.albedo.width, atlas.albedo.height);
  std::size_t next = 0;
  TileAnimations animations;
  for (NamedTile& tile : tiles) {
    const int side = sideOf(tile);
    const glm::ivec2 corner = unitPlace(next) * kUnit;
    next += std::size_t(side / kUnit) * std::size_t(side / kUnit);
    fillHoles(tile.images.albedo);
    putClamped(atlas.albedo, tile.images.albedo, corner, side);
    putClamped(atlas.normal, tile.images.normal, corner, side);
    putClamped(atlas.specular, tile.images.specular, corner, side);
    const glm::vec2 texels(tile.images.albedo.width, tile.images.albedo.height);
    atlas.tiles[tile.name] = {glm::vec2(corner) / size, (glm::vec2(corner) + texels) / size};
    if (tile.animation) animations.push_back(placed(*std::move(tile.animation), corner, side));
  }
  if (!animations.empty())
    atlas.animations = std::make_shared<const TileAnimations>(std::move(animations));
  return whole;
}

}  // namespace orris
