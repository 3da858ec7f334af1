// Rain and lightning.
#include <orris/plan/lists/draw_lists.h>

#include <gmock/gmock.h>

#include "plan/list_scene.h"

namespace orris {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

TEST(DrawLists, lightning_is_a_kind_from_the_start_and_drawn_while_it_is_there) {
  SceneData scene = sceneOf(R"("events": [{"frame": 3, "lightning": {"at": [1, 1, 1]}}])");
  EXPECT_EQ(scene.contents().content, bitOf(Geometry::Lightning));
  EXPECT_THAT(buildDrawLists(scene, stateOf(scene)).draws, IsEmpty());
  scene.world.content.bolts = {{{1, 1, 1}, 15}};
  EXPECT_THAT(buildDrawLists(scene, stateOf(scene)).draws, SizeIs(1));
}

TEST(DrawLists, rain_does_not_fall_through_roofs) {
  const std::string rain = R"("environment": {"rain": 1})";
  SceneData scene = sceneOf(rain);
  const auto columns = [&] {
    const DrawLists lists = buildDrawLists(scene, stateOf(scene, {4, 2.5, 4}));
    std::size_t above = 0;
    for (std::size_t i = 0; i < lists.vertices.size(); i += 4) {
      const GpuVertex& v = lists.vertices[i + 1];  // below
      if (v.position[0] > -2 && v.position[0] < 2 && v.position[2] > -2 && v.position[2] < 2)
        above += v.position[1] < 0;
    }
    return above;
  };
  EXPECT_GT(columns(), 4u);
  const std::uint32_t stone = scene.world.blocks.paletteIndex({"minecraft:stone", {}});
  scene.world.blocks.fill({0, 5, 0}, {7, 5, 7}, stone);
  rebuildMesh(scene, {});
  EXPECT_EQ(columns(), 0u);
}

}  // namespace
}  // namespace orris
