#include <orris/world/atlas/mixed_atlas.h>

#include <gtest/gtest.h>

namespace orris {
namespace {

NamedTile tileOf(const std::string& name, int width, int height, std::uint8_t grey) {
  Image8 image(width, height, 4);
  std::fill(image.pixels.begin(), image.pixels.end(), grey);
  return {name, {image, image, image}};
}

glm::ivec4 texelsOf(const BlockAtlas& atlas, const std::string& name) {
  const AtlasTile tile = atlas.tiles.at(name);
  const glm::vec2 size(atlas.albedo.width, atlas.albedo.height);
  return {glm::ivec2(tile.min * size + 0.5f), glm::ivec2(tile.max * size + 0.5f)};
}

TEST(mixed_atlas, tiles_lie_at_multiples_of_their_size_and_apart) {
  std::vector<NamedTile> tiles;
  const int sides[] = {16, 64, 16, 32, 128, 16, 64, 32, 16, 16};
  for (int i = 0; i < 10; ++i)
    tiles.push_back(
        tileOf(std::string(1, char('a' + i)), sides[i], sides[i], std::uint8_t(20 * i + 20)));
  BlockAtlas atlas;
  EXPECT_TRUE(packTiles(tiles, atlas));
  for (int i = 0; i < 10; ++i) {
    const glm::ivec4 place = texelsOf(atlas, tiles[std::size_t(i)].name);
    EXPECT_EQ(place.x % sides[i], 0);
    EXPECT_EQ(place.y % sides[i], 0);
    EXPECT_EQ(place.z - place.x, sides[i]);
    for (int y = place.y; y < place.w; ++y)
      for (int x = place.x; x < place.z; ++x) ASSERT_EQ(atlas.specular.at(x, y)[0], 20 * i + 20);
  }
}

TEST(mixed_atlas, an_oblong_texture_repeats_its_last_row_and_a_small_one_is_enlarged) {
  BlockAtlas atlas;
  EXPECT_TRUE(packTiles({tileOf("long", 32, 16, 70), tileOf("tiny", 4, 4, 90)}, atlas));
  const glm::ivec4 place = texelsOf(atlas, "long"), tiny = texelsOf(atlas, "tiny");
  EXPECT_EQ(glm::ivec2(place.z, place.w) - glm::ivec2(place.x, place.y), glm::ivec2(32, 16));
  EXPECT_EQ(atlas.albedo.at(place.x + 5, place.w + 3)[1], 70);
  EXPECT_EQ(tiny.z - tiny.x, 16);
}

TEST(mixed_atlas, what_does_not_fit_is_halved) {
  std::vector<NamedTile> tiles;
  for (int i = 0; i < 5; ++i) tiles.push_back(tileOf(std::string(1, char('a' + i)), 256, 256, 50));
  tiles.push_back(tileOf("small", 16, 16, 60));
  BlockAtlas atlas;
  constexpr std::size_t kMost = 512 * 512;
  EXPECT_FALSE(packTiles(std::move(tiles), atlas, kMost));
  EXPECT_LE(std::size_t(atlas.albedo.width) * std::size_t(atlas.albedo.height), kMost);
  const glm::ivec4 place = texelsOf(atlas, "a");
  EXPECT_EQ(place.z - place.x, 128);
  EXPECT_EQ(texelsOf(atlas, "small").z - texelsOf(atlas, "small").x, 16);
}

}  // namespace
}  // namespace orris
