#include <orris/world/atlas/block_atlas.h>

#include <algorithm>
#include <cmath>
#include <set>

#include <orris/world/atlas/texture_canvas.h>

namespace orris {
namespace {

std::uint8_t toByte(float value) {
  return std::uint8_t(std::lround(std::clamp(value, 0.0f, 1.0f) * 255));
}

void put(Image8& image, int x, int y, const glm::ivec4& value) {
  for (int c = 0; c < 4; ++c) image.at(x, y)[c] = std::uint8_t(std::clamp(value[c], 0, 255));
}

/// LabPBR: x and y of the normal, green growing down the tile, ambient occlusion, height. Height is
/// measured from the tile's highest texel, half of the format's depth at most.
glm::ivec4 normalTexel(const TextureCanvas& canvas, int x, int y, float highest) {
  constexpr float kSteepness = 1.6f;
  const auto height = [&](int dx, int dy) { return canvas.at(x + dx, y + dy).height; };
  const glm::vec2 slope(height(1, 0) - height(-1, 0), height(0, 1) - height(0, -1));
  const glm::vec3 normal = glm::normalize(glm::vec3(-slope * kSteepness, 1));
  const float around = (height(1, 0) + height(-1, 0) + height(0, 1) + height(0, -1)) / 4;
  const float occlusion = 1 - std::clamp(around - height(0, 0), 0.0f, 0.5f);
  return {std::lround(127 + normal.x * 127), std::lround(127 + normal.y * 127), toByte(occlusion),
          toByte(1 - (highest - height(0, 0)) * 0.5f)};
}

/// LabPBR: smoothness, reflectance or metal, porosity or subsurface, emission (255 would mean none;
/// 0 means the same and survives filtering).
glm::ivec4 specularTexel(const Texel& texel) {
  return {toByte(texel.smoothness), texel.reflectance, texel.porosity,
          int(std::lround(std::clamp(texel.emission, 0.0f, 1.0f) * 254))};
}

glm::vec3 meanColour(const TextureCanvas& canvas) {
  glm::vec4 sum(0);
  for (const Texel& texel : canvas.texels) {
    sum += glm::vec4(glm::vec3(texel.colour), 1) * texel.colour.a;
  }
  return sum.w > 0 ? glm::vec3(sum) / sum.w : glm::vec3(0);
}

void putTile(Image8& image, const Image8& tile, int left, int top) {
  for (int y = 0; y < tile.height; ++y)
    std::copy_n(tile.at(0, y), std::size_t(tile.width) * 4, image.at(left, top + y));
}

}  // namespace

AtlasTile BlockAtlas::tile(const std::string& name) const {
  const auto found = tiles.find(name);
  if (found != tiles.end()) return found->second;
  const auto missing = tiles.find("missing");
  return missing != tiles.end() ? missing->second : AtlasTile{};
}

TileImages drawnTile(const std::string& name) {
  const TextureCanvas canvas = drawTexture(name);
  const glm::vec3 mean = meanColour(canvas);
  float highest = 0;
  for (const Texel& texel : canvas.texels) highest = std::max(highest, texel.height);
  const Image8 empty(kTextureSize, kTextureSize, 4);
  TileImages tile{empty, empty, empty};
  for (int y = 0; y < kTextureSize; ++y) {
    for (int x = 0; x < kTextureSize; ++x) {
      const Texel& texel = canvas.at(x, y);
      const glm::vec4 c = texel.colour.a > 0 ? texel.colour : glm::vec4(mean, 0);
      put(tile.albedo, x, y, {toByte(c.r), toByte(c.g), toByte(c.b), toByte(c.a)});
      put(tile.normal, x, y, normalTexel(canvas, x, y, highest));
      put(tile.specular, x, y, specularTexel(texel));
    }
  }
  return tile;
}

Image8 textureImage(const std::string& name) {
  const TextureCanvas canvas = drawTexture(name);
  Image8 image(kTextureSize, kTextureSize, 4);
  for (int y = 0; y < kTextureSize; ++y)
    for (int x = 0; x < kTextureSize; ++x) {
      const glm::vec4& c = canvas.at(x, y).colour;
      put(image, x, y, {toByte(c.r), toByte(c.g), toByte(c.b), toByte(c.a)});
    }
  return image;
}

BlockAtlas buildAtlas(const std::vector<std::string>& textureNames) {
  std::set<std::string> names(textureNames.begin(), textureNames.end());
  names.insert("missing");
  names.erase("");
  int columns = 1, rows = 1;
  while (size_t(columns) * size_t(rows) < names.size()) (columns <= rows ? columns : rows) *= 2;

  BlockAtlas atlas;
  const int width = columns * kTextureSize, height = rows * kTextureSize;
  atlas.tileSize = kTextureSize;
  atlas.albedo = Image8(width, height, 4);
  atlas.normal = Image8(width, height, 4);
  atlas.specular = Image8(width, height, 4);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) put(atlas.normal, x, y, {127, 127, 255, 255});
  }
  int index = 0;
  for (const std::string& name : names) {
    const int column = index % columns, row = index / columns;
    const TileImages tile = drawnTile(name);
    const int left = column * kTextureSize, top = row * kTextureSize;
    putTile(atlas.albedo, tile.albedo, left, top);
    putTile(atlas.normal, tile.normal, left, top);
    putTile(atlas.specular, tile.specular, left, top);
    const glm::vec2 size(1.0f / float(columns), 1.0f / float(rows));
    const glm::vec2 corner = glm::vec2(column, row) * size;
    atlas.tiles[name] = {corner, corner + size};
    ++index;
  }
  return atlas;
}

}  // namespace orris
