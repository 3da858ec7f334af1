// What blocks become in the volume about the camera.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pack_session.h"

namespace orris::test {
namespace {

struct Expected {
  const char* state;
  int code;  // include/voxels/voxel.glsl
};

void PrintTo(const Expected& expected, std::ostream* stream) { *stream << expected.state; }

class BlockVoxel : public testing::TestWithParam<Expected> {};

TEST_P(BlockVoxel, has_the_code_of_its_class) {
  const std::string world = fmt::format(R"({{
    "size": [1, 1, 1],
    "blocks": [{{"box": "{}", "min": [0, 0, 0], "max": [0, 0, 0]}}],
    "cameras": [{{"name": "eye", "position": [0.5, 0.5, 4.5], "yaw": 180}}]
  }})",
                                        GetParam().state);
  PackSession pack(world, {{"VOXEL_SIZE", "32"}});
  pack.renderFrames(1);
  const AtlasLayout layout{32, 32};
  // The atlas is the bottom of the target.
  const CellField voxels = pack.voxels(layout);
  const auto texel = voxels.at(cellOf({0, 0, 0}, {0, 0, 4}, 32));
  EXPECT_EQ(static_cast<int>(texel[3] * 255 + 0.5f), GetParam().code);
}

INSTANTIATE_TEST_SUITE_P(
    volume, BlockVoxel,
    testing::Values(
        Expected{"minecraft:stone", 1}, Expected{"minecraft:oak_slab[type=bottom]", 2},
        Expected{"minecraft:oak_slab[type=top]", 3}, Expected{"minecraft:oak_slab[type=double]", 1},
        Expected{"minecraft:red_stained_glass", 4}, Expected{"minecraft:water", 5},
        Expected{"minecraft:glass", 16 + 6}, Expected{"minecraft:glowstone", 64 + 2 * 16 + 15},
        Expected{"minecraft:glass_pane[north=true]", 24 + 6}, Expected{"minecraft:red_carpet", 48},
        Expected{"minecraft:torch", 32 + 14}, Expected{"minecraft:soul_torch", 32 + 10},
        Expected{"minecraft:dandelion", 0}, Expected{"minecraft:oak_fence_gate", 0},
        Expected{"minecraft:oak_fence", 7}, Expected{"minecraft:stone_brick_wall", 8},
        Expected{"minecraft:chest[facing=east]", 9}, Expected{"minecraft:white_shulker_box", 9},
        Expected{"minecraft:red_bed", 2}, Expected{"minecraft:oak_trapdoor", 12},
        Expected{"minecraft:oak_door[half=lower]", 10}, Expected{"minecraft:oak_sign", 0},
        Expected{"minecraft:white_banner", 0}, Expected{"minecraft:conduit", 32 + 15}));

TEST(VoxelVolume, red_concrete_becomes_a_red_voxel) {
  PackSession pack(R"({
    "size": [1, 1, 1],
    "blocks": [{"box": "red_concrete", "min": [0, 0, 0], "max": [0, 0, 0]}],
    "cameras": [{"name": "eye", "position": [0.5, 0.5, 4.5], "yaw": 180}]
  })",
                   {{"VOXEL_SIZE", "32"}});
  pack.renderFrames(1);
  const auto texel = pack.voxels({32, 32}).at(cellOf({0, 0, 0}, {0, 0, 4}, 32));
  EXPECT_GT(texel[0], 2 * texel[1]);
  EXPECT_GT(texel[0], 2 * texel[2]);
}

// Its lock, of iron, has a top as well.
TEST(VoxelVolume, chest_becomes_a_voxel_of_its_wood) {
  PackSession pack(R"({
    "size": [1, 1, 1],
    "blocks": [{"block": "chest[facing=south]", "at": [0, 0, 0]}],
    "cameras": [{"name": "eye", "position": [0.5, 0.5, 4.5], "yaw": 180}]
  })",
                   {{"VOXEL_SIZE", "32"}});
  pack.renderFrames(1);
  const auto texel = pack.voxels({32, 32}).at(cellOf({0, 0, 0}, {0, 0, 4}, 32));
  EXPECT_GT(texel[0], 1.5 * texel[2]);
}

// Water between water has no faces. The lake lies in stone and a slab stands in it.
TEST(VoxelVolume, lakes_are_filled_down_to_their_bed) {
  PackSession pack(R"({
    "size": [7, 6, 7],
    "blocks": [{"box": "stone", "min": [0, 0, 0], "max": [6, 4, 6]},
               {"box": "water", "min": [1, 1, 1], "max": [5, 4, 5]},
               {"block": "oak_slab[type=bottom]", "at": [2, 1, 3]}],
    "cameras": [{"name": "eye", "position": [3.5, 5.5, 3.5], "yaw": 180}]
  })",
                   {{"VOXEL_SIZE", "32"}});
  pack.renderFrames(2);
  const CellField voxels = pack.voxels({32, 32});
  const auto codeAt = [&](int x, int y, int z) {
    return int(voxels.at(cellOf({x, y, z}, {3, 5, 3}, 32))[3] * 255 + 0.5f);
  };
  EXPECT_EQ(codeAt(3, 5, 3), 0);
  EXPECT_EQ(codeAt(3, 4, 3), 5);
  for (int y = 1; y <= 3; ++y) EXPECT_EQ(codeAt(3, y, 3), 4) << y;
  EXPECT_EQ(codeAt(3, 0, 3), 1);
  EXPECT_EQ(codeAt(3, -1, 3), 0);
  EXPECT_EQ(codeAt(2, 1, 3), 2);
  const auto surface = voxels.at(cellOf({3, 4, 3}, {3, 5, 3}, 32));
  const auto deep = voxels.at(cellOf({3, 2, 3}, {3, 5, 3}, 32));
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(surface[c], deep[c], 1.5 / 255);
}

}  // namespace
}  // namespace orris::test
