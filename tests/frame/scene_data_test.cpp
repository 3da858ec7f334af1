#include <gtest/gtest.h>

#include "frame/gpu_scene.h"

namespace orris {
namespace {

TEST(SceneData, a_pack_moves_blocks_between_render_layers) {
  World world;
  world.blocks = BlockWorld({0, 0, 0}, {2, 2, 2});
  const std::uint32_t glass = world.blocks.paletteIndex(*parseBlockState("glass"));
  world.blocks.set({0, 0, 0}, glass);
  Diagnostics diagnostics;
  SceneData scene = buildScene(world, {}, diagnostics);
  EXPECT_TRUE(scene.contents().cutout);
  EXPECT_FALSE(scene.contents().translucent);
  rebuildMesh(scene, {.renderLayers = {{"minecraft:glass", "translucent"}}});
  EXPECT_FALSE(scene.contents().cutout);
  EXPECT_TRUE(scene.contents().translucent);
  rebuildMesh(scene, {});
  EXPECT_TRUE(scene.contents().cutout);
}

}  // namespace
}  // namespace orris
