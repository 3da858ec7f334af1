#include <orris/world/atlas/block_atlas.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include <orris/world/atlas/texture_canvas.h>
#include <orris/world/content/entity_models.h>
#include <orris/world/blocks/block_data.h>
#include <orris/world/blocks/block_facts.h>

namespace orris {
namespace {

const std::vector<std::string>& allNames() {
  static const BlockTable table;
  return table.textureNames();
}

/// Texel rectangle of a tile: left and top.
glm::ivec2 cornerOf(const BlockAtlas& atlas, const std::string& name) {
  const AtlasTile tile = atlas.tile(name);
  return {int(tile.min.x * float(atlas.albedo.width)),
          int(tile.min.y * float(atlas.albedo.height))};
}

const BlockAtlas& wholeAtlas() {
  static const BlockAtlas atlas = buildAtlas(allNames());
  return atlas;
}

std::uint64_t hashOf(const Image8& image) {
  std::uint64_t hash = 14695981039346656037u;
  for (const std::uint8_t byte : image.pixels) hash = (hash ^ byte) * 1099511628211u;
  return hash;
}

TEST(BlockAtlas, two_builds_are_equal_whatever_the_order_of_names) {
  std::vector<std::string> names = allNames();
  const BlockAtlas& first = wholeAtlas();
  std::reverse(names.begin(), names.end());
  names.push_back(names.front());
  const BlockAtlas second = buildAtlas(names);
  EXPECT_EQ(hashOf(first.albedo), hashOf(second.albedo));
  EXPECT_EQ(hashOf(first.normal), hashOf(second.normal));
  EXPECT_EQ(hashOf(first.specular), hashOf(second.specular));
}

TEST(BlockAtlas, tile_looks_the_same_in_every_atlas) {
  const BlockAtlas small = buildAtlas({"stone", "oak_planks"});
  const glm::ivec2 a = cornerOf(small, "stone"), b = cornerOf(wholeAtlas(), "stone");
  for (int i = 0; i < 256; ++i) {
    const int x = i % 16, y = i / 16;
    EXPECT_TRUE(std::equal(small.albedo.at(a.x + x, a.y + y), small.albedo.at(a.x + x, a.y + y) + 4,
                           wholeAtlas().albedo.at(b.x + x, b.y + y)));
  }
}

TEST(BlockAtlas, size_is_the_smallest_power_of_two_that_fits) {
  EXPECT_EQ(buildAtlas({}).albedo.width, 16);
  EXPECT_EQ(buildAtlas({}).albedo.height, 16);
  const BlockAtlas two = buildAtlas({"stone"});
  EXPECT_EQ(two.albedo.width * two.albedo.height, 2 * 256);
  const BlockAtlas four = buildAtlas({"stone", "dirt", "sand"});
  EXPECT_EQ(four.albedo.width, 32);
  EXPECT_EQ(four.albedo.height, 32);
  const BlockAtlas five = buildAtlas({"stone", "dirt", "sand", "gravel"});
  EXPECT_EQ(five.albedo.width * five.albedo.height, 8 * 256);
}

TEST(BlockAtlas, tiles_do_not_overlap_and_lie_on_the_grid) {
  std::set<std::pair<int, int>> corners;
  for (const auto& [name, tile] : wholeAtlas().tiles) {
    const glm::ivec2 corner = cornerOf(wholeAtlas(), name);
    EXPECT_EQ(corner.x % 16, 0);
    EXPECT_EQ(corner.y % 16, 0);
    EXPECT_FLOAT_EQ((tile.max.x - tile.min.x) * float(wholeAtlas().albedo.width), 16);
    EXPECT_FLOAT_EQ((tile.max.y - tile.min.y) * float(wholeAtlas().albedo.height), 16);
    EXPECT_TRUE(corners.emplace(corner.x, corner.y).second) << name;
  }
}

TEST(BlockAtlas, unknown_texture_is_the_magenta_checker) {
  const BlockAtlas atlas = buildAtlas({"no_such_texture"});
  for (const char* name : {"missing", "no_such_texture", "not_asked_for"}) {
    const glm::ivec2 corner = cornerOf(atlas, name);
    const std::uint8_t* light = atlas.albedo.at(corner.x, corner.y);
    const std::uint8_t* dark = atlas.albedo.at(corner.x + 8, corner.y);
    EXPECT_EQ(std::vector<int>(light, light + 4), (std::vector<int>{255, 0, 255, 255})) << name;
    EXPECT_EQ(std::vector<int>(dark, dark + 4), (std::vector<int>{0, 0, 0, 255})) << name;
  }
}

TEST(BlockAtlas, every_texture_of_the_blocks_is_drawn_by_a_known_recipe) {
  for (const std::string& name : allNames()) {
    const std::string plain = name.ends_with("@90") ? name.substr(0, name.size() - 3) : name;
    if (plain == "missing") continue;
    const auto found = blockData().textures.find(plain);
    ASSERT_NE(found, blockData().textures.end()) << plain;
    const std::string& recipe = found->second.recipe;
    EXPECT_TRUE(findMaterialRecipe(recipe) || findObjectRecipe(recipe)) << plain << " " << recipe;
  }
}

TEST(BlockAtlas, every_texture_defined_is_used) {
  const auto& names = allNames();
  std::set<std::string> used(names.begin(), names.end());
  for (const std::string& name : contentTextureNames()) used.insert(name);
  for (const auto& [name, definition] : blockData().textures) used.insert(definition.base);
  for (const auto& [name, definition] : blockData().textures) {
    EXPECT_TRUE(used.count(name)) << name;
  }
}

TEST(BlockAtlas, no_tile_is_empty) {
  for (const auto& [name, tile] : wholeAtlas().tiles) {
    const glm::ivec2 corner = cornerOf(wholeAtlas(), name);
    int visible = 0;
    for (int i = 0; i < 256; ++i) {
      visible += wholeAtlas().albedo.at(corner.x + i % 16, corner.y + i / 16)[3] > 0;
    }
    EXPECT_GT(visible, 8) << name;
  }
}

TEST(BlockAtlas, empty_texels_have_the_colour_of_the_rest) {
  const BlockAtlas atlas = buildAtlas({"cherry_leaves"});
  const glm::ivec2 corner = cornerOf(atlas, "cherry_leaves");
  int holes = 0;
  for (int i = 0; i < 256; ++i) {
    const std::uint8_t* texel = atlas.albedo.at(corner.x + i % 16, corner.y + i / 16);
    if (texel[3] != 0) continue;
    ++holes;
    EXPECT_GT(texel[0], 150);
    EXPECT_GT(texel[0], texel[1]);
  }
  EXPECT_GT(holes, 0);
}

TEST(BlockAtlas, smallest_safe_mipmap_level_has_one_texel_a_tile) {
  EXPECT_EQ(BlockAtlas().tileSize >> BlockAtlas::kMipLevels, 1);
}

TEST(BlockAtlas, turned_texture_is_a_quarter_turn_clockwise) {
  const TextureCanvas plain = drawTexture("oak_planks"), quarter = drawTexture("oak_planks@90");
  EXPECT_EQ(quarter.at(15, 0).colour, plain.at(0, 0).colour);
  EXPECT_EQ(quarter.at(15, 15).colour, plain.at(15, 0).colour);
  EXPECT_EQ(quarter.at(4, 3).colour, plain.at(3, 11).colour);
}

TEST(BlockAtlas, normals_lean_away_from_the_higher_texel) {
  // The seam of a plank lies lower than the boards above and below it.
  const BlockAtlas atlas = buildAtlas({"oak_planks"});
  const glm::ivec2 corner = cornerOf(atlas, "oak_planks");
  const auto green = [&](int y) { return int(atlas.normal.at(corner.x + 1, corner.y + y)[1]); };
  EXPECT_GT(green(2), 140) << "the board's lower edge faces down the tile";
  EXPECT_LT(green(4), 115) << "the next board's upper edge faces up";
  const std::uint8_t* seam = atlas.normal.at(corner.x + 1, corner.y + 3);
  const std::uint8_t* board = atlas.normal.at(corner.x + 1, corner.y + 1);
  EXPECT_LT(seam[2], board[2]) << "occlusion";
  EXPECT_LT(seam[3], board[3]) << "height";
}

TEST(BlockAtlas, specular_follows_labpbr) {
  const BlockAtlas atlas = buildAtlas({"glowstone", "stone", "gold_block", "torch"});
  const auto texel = [&](const char* name, int x, int y) {
    const glm::ivec2 corner = cornerOf(atlas, name);
    return atlas.specular.at(corner.x + x, corner.y + y);
  };
  EXPECT_EQ(texel("gold_block", 8, 8)[1], 231) << "the metal's code";
  EXPECT_EQ(texel("stone", 8, 8)[3], 0) << "no emission";
  EXPECT_EQ(texel("torch", 7, 6)[3], 254) << "the torch's tip";
  EXPECT_EQ(texel("torch", 7, 12)[3], 0) << "its stick";
  for (int i = 0; i < 256; ++i) {
    const int emission = texel("glowstone", i % 16, i / 16)[3];
    EXPECT_GT(emission, 60);
    EXPECT_LT(emission, 255) << "255 means none";
  }
}

TEST(BlockAtlas, dyes_are_distinguished) {
  const char* const kDyes[] = {"white", "orange", "magenta",    "light_blue", "yellow", "lime",
                               "pink",  "gray",   "light_gray", "cyan",       "purple", "blue",
                               "brown", "green",  "red",        "black"};
  for (const char* family : {"_wool", "_concrete", "_stained_glass"}) {
    std::vector<glm::vec3> means;
    for (const char* dye : kDyes) {
      glm::vec3 mean(0);
      for (const Texel& texel : drawTexture(dye + std::string(family)).texels) {
        mean += glm::vec3(texel.colour) / 256.0f;
      }
      for (const glm::vec3& other : means) EXPECT_GT(glm::distance(mean, other), 0.05f) << dye;
      means.push_back(mean);
    }
  }
}

}  // namespace
}  // namespace orris
