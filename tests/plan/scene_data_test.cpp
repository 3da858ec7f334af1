#include <orris/plan/scene/scene_data.h>

#include <gtest/gtest.h>

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

TEST(SceneData, ids_see_the_properties_that_a_state_has_by_default) {
  ShaderPack pack;
  Diagnostics diagnostics;
  const std::string lines = "block.336=end_rod:facing=up\nblock.346=end_rod:facing=north\n";
  pack.blockIds = parseBlockProperties("/block.properties", lines, lines, diagnostics);
  BlockWorld blocks({0, 0, 0}, {1, 1, 1});
  const auto idOf = [&](const char* state) {
    return blockIdsOf(pack, blocks)[blocks.paletteIndex(*parseBlockState(state))];
  };
  blocks.paletteIndex(*parseBlockState("end_rod[facing=north]"));
  blocks.paletteIndex(*parseBlockState("end_rod"));
  EXPECT_EQ(idOf("end_rod"), 336);
  EXPECT_EQ(idOf("end_rod[facing=north]"), 346);
}

TEST(SceneData, feet_stand_in_water_below_the_eye) {
  World world;
  world.blocks = BlockWorld({0, 0, 0}, {1, 4, 1});
  world.blocks.set({0, 1, 0}, world.blocks.paletteIndex(*parseBlockState("water")));
  Diagnostics diagnostics;
  const SceneData scene = buildScene(world, {}, diagnostics);
  EXPECT_TRUE(scene.surroundings({0.5, 3.2, 0.5}).feetInWater);
  EXPECT_FALSE(scene.surroundings({0.5, 1.5, 0.5}).feetInWater);
  const auto feetOf = [&](const glm::dvec3& eye) {
    return nextFrameState({.width = 4, .height = 4, .eye = scene.surroundings(eye)}, {}, nullptr)
        .feetInWater;
  };
  EXPECT_TRUE(feetOf({0.5, 2.7, 0.5}));
  world.blocks.set({0, 2, 0}, world.blocks.paletteIndex(*parseBlockState("water")));
  const SceneData deep = buildScene(world, {}, diagnostics);
  // Water over the eye is no shallow water.
  EXPECT_FALSE(nextFrameState({.width = 4, .height = 4, .eye = deep.surroundings({0.5, 2.7, 0.5})},
                              {}, nullptr)
                   .feetInWater);
}

}  // namespace
}  // namespace orris
