// What blocks become in the volume about the camera.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pack_session.h"

namespace orris::test {
namespace {

// They stand apart, so that none hides or fills another.
TEST(VoxelVolume, blocks_have_the_code_of_their_class) {
  struct Expected {
    const char* state;
    int code;  // include/voxels/voxel.glsl
  };
  const Expected all[] = {
      {"stone", 1}, {"oak_slab[type=bottom]", 2}, {"oak_slab[type=top]", 3}, {"oak_slab[type=double]", 1},
      {"red_stained_glass", 4}, {"water", 5}, {"glass", 16}, {"glowstone", 64 + 2 * 16 + 15},
      {"glass_pane[north=true]", 17}, {"red_carpet", 48}, {"torch", 32 + 14}, {"soul_torch", 32 + 10},
      {"dandelion", 52}, {"wheat", 0}, {"oak_leaves", 51}, {"oak_fence_gate", 0}, {"oak_fence", 7}, {"stone_brick_wall", 8},
      {"chest[facing=east]", 9}, {"white_shulker_box", 9}, {"red_bed", 2}, {"oak_trapdoor", 12},
      {"oak_door[half=lower]", 10}, {"oak_sign", 0}, {"white_banner", 0}, {"conduit", 32 + 15}};
  const auto place = [](int i) { return glm::ivec3(i % 6 * 2, 0, i / 6 * 2); };
  std::string blocks;
  for (int i = 0; i < int(std::size(all)); ++i)
    blocks += fmt::format(R"({}{{"block": "{}", "at": [{}, 0, {}]}})", i > 0 ? "," : "", all[i].state, place(i).x,
                          place(i).z);
  PackSession pack(R"({"size": [12, 1, 10], "blocks": [)" + blocks + R"(],
      "cameras": [{"name": "eye", "position": [5.5, 0.5, 9.5], "yaw": 180}]})",
                   {{"VOXEL_SIZE", "32"}});
  pack.renderFrames(1);
  const CellField voxels = pack.voxels({32, 32});
  for (int i = 0; i < int(std::size(all)); ++i) {
    const int code = int(voxels.at(cellOf(place(i), {5, 0, 9}, 32))[3] * 255 + 0.5f);
    EXPECT_EQ(code >= 52 && code < 60 ? 52 : code, all[i].code) << all[i].state;  // plants: by chance
  }
}

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
