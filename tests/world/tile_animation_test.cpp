// Textures whose frames follow each other.
#include <orris/world/atlas/tile_animation.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "resource_helpers.h"
#include <orris/world/resources/texture_meta.h>

namespace orris {
namespace {

using testing::HasSubstr;

TEST(tile_animation, an_animation_begins_with_its_first_frame) {
  TestPack pack = stonePack();
  const Texel8 frames[] = {kRed, kGreen, kBlue};
  pack.texture("block/stone", pngOf(16, 48, [&](int, int y) { return frames[y / 16]; }));
  const std::string meta = "/minecraft/textures/block/stone.png.mcmeta";
  const auto color = [&](const std::string& json) {
    pack.files[meta] = json;
    pack.look(oneBlock("stone"));
    return texelAt(pack.atlas.albedo, pack.atlas, "minecraft:block/stone", {0.5f, 0.5f});
  };
  EXPECT_EQ(color(R"({"animation": {}})"), kRed);
  EXPECT_EQ(color(R"({"animation": {"frametime": 4, "frames": [2, 0, 1]}})"), kBlue);
  EXPECT_EQ(color(R"({"animation": {"interpolate": true, "frames": [{"index": 1, "time": 9}]}})"),
            kGreen);
  EXPECT_EQ(pack.errors, "");
  color(R"({"animation": {"frames": [7]}})");
  EXPECT_THAT(
      pack.errors,
      HasSubstr("pack/assets/minecraft/textures/block/stone.png.mcmeta:1:15: warning: the "
                "animation has a frame 7 of 16x16 texels, but the texture has 16x48"));
}

TEST(tile_animation, the_frames_of_an_animation_are_kept_once_each) {
  TestPack pack = stonePack();
  const Texel8 frames[] = {kRed, kGreen, kBlue};
  const auto strip = pngOf(16, 48, [&](int, int y) { return frames[y / 16]; });
  pack.texture("block/stone", strip);
  pack.files["/minecraft/textures/block/stone.png.mcmeta"] =
      R"({"animation": {"frametime": 3, "frames": [1, {"index": 2, "time": 5}, 1]}})";
  pack.look(oneBlock("stone"));
  ASSERT_TRUE(pack.atlas.animations);
  ASSERT_EQ(pack.atlas.animations->size(), 1u);
  const TileAnimation& animation = pack.atlas.animations->front();
  ASSERT_EQ(animation.frames.size(), 2u);
  ASSERT_EQ(animation.steps.size(), 3u);
  EXPECT_EQ(animation.steps[1].ticks, 5);
  EXPECT_EQ(animation.frames[0].normal.width, 0) << "no pack has maps of it";
  const AtlasTile tile = pack.atlas.tile("minecraft:block/stone");
  EXPECT_EQ(glm::vec2(animation.corner),
            tile.min * glm::vec2(pack.atlas.albedo.width, pack.atlas.albedo.height));
  const auto colour = [&](long tick) {
    const Image8& image = animation.frames[std::size_t(momentOf(animation, tick).frame)].albedo;
    return Texel8{image.at(8, 8)[0], image.at(8, 8)[1], image.at(8, 8)[2], image.at(8, 8)[3]};
  };
  EXPECT_EQ(colour(0), kGreen);
  EXPECT_EQ(colour(2), kGreen);
  EXPECT_EQ(colour(3), kBlue);
  EXPECT_EQ(colour(7), kBlue);
  EXPECT_EQ(colour(8), kGreen);
  EXPECT_EQ(colour(11 + 3), kBlue) << "again";
  pack.files["/minecraft/textures/block/stone.png.mcmeta"] = R"({"animation": {"frames": [1]}})";
  pack.look(oneBlock("stone"));
  EXPECT_FALSE(pack.atlas.animations) << "one frame does not move";
}

TEST(tile_animation, an_animation_may_have_frames_that_are_no_squares) {
  const auto metaOf = [](const std::string& size) {
    Diagnostics diagnostics;
    auto meta = parseTextureMeta({"{\"animation\": {" + size + "}}", "stone.png.mcmeta"}, {32, 64}, diagnostics);
    EXPECT_TRUE(diagnostics.empty());
    return meta.value_or(TextureMeta());
  };
  const TextureMeta square = metaOf(""), flat = metaOf(R"("width": 32, "height": 16)"),
                    low = metaOf(R"("height": 16)"), narrow = metaOf(R"("width": 16)");
  EXPECT_EQ(glm::ivec3(square.width, square.height, square.steps.size()), glm::ivec3(32, 32, 2));
  EXPECT_EQ(glm::ivec3(flat.width, flat.height, flat.steps.size()), glm::ivec3(32, 16, 4));
  EXPECT_EQ(glm::ivec3(low.width, low.height, low.steps.size()), glm::ivec3(32, 16, 4));
  EXPECT_EQ(glm::ivec3(narrow.width, narrow.height, narrow.steps.size()), glm::ivec3(16, 64, 2));
}

TEST(tile_animation, an_interpolated_animation_is_between_its_frames) {
  TileAnimation animation;
  animation.frames.resize(2);
  animation.steps = {{0, 4}, {1, 4}};
  animation.interpolate = true;
  EXPECT_EQ(momentOf(animation, 1), (AnimationMoment{0, 1, 0.25f}));
  EXPECT_EQ(momentOf(animation, 6), (AnimationMoment{1, 0, 0.5f}));
  Image8 dark(1, 1, 4), light(1, 1, 4);
  dark.pixels = {0, 100, 255, 10};
  light.pixels = {200, 100, 55, 90};
  EXPECT_EQ(mixed(dark, light, 0.25f).pixels, (std::vector<std::uint8_t>{50, 100, 205, 10}));
}

}  // namespace
}  // namespace orris
