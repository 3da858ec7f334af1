// Items that lie, hang in frames or have models of a resource pack.
#include <orris/plan/lists/draw_lists.h>

#include <gmock/gmock.h>

#include "plan/list_scene.h"

namespace orris {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

glm::ivec4 colorOf(const DrawLists& lists, std::size_t draw) {
  const GpuVertex& vertex = lists.vertices[lists.draws[draw].range.firstVertex];
  return {vertex.color[0], vertex.color[1], vertex.color[2], vertex.color[3]};
}

TEST(DrawLists, a_framed_item_is_turned_clockwise) {
  Entity frame = entityOf("minecraft:item_frame", "item_frame");
  frame.item = "minecraft:iron_sword";
  frame.hidden = true;
  const DrawLists straight = listsOf(frame);
  frame.itemTurn = 90;
  const DrawLists turned = listsOf(frame);
  ASSERT_EQ(straight.vertices.size(), 8u) << "the frame itself is not drawn";
  ASSERT_EQ(turned.vertices.size(), 8u);
  const auto corner = [](const DrawLists& lists) {
    const GpuVertex& v = lists.vertices[0];  // top left, seen from the south
    return glm::vec2(v.position[0], v.position[1]);
  };
  EXPECT_LT(corner(straight).x, 0);
  EXPECT_GT(corner(straight).y, -2);
  EXPECT_GT(corner(turned).x, 0) << "the top left corner is now right";
  EXPECT_GT(corner(turned).y, -2);
}

TEST(DrawLists, items_are_drawn_by_the_models_of_a_resource_pack) {
  SceneData scene = sceneOf(R"("environment": {"player": {"mainHand": "iron_sword", "offHand": "torch"}})");
  const ResourceStack resources = packOf({"item/iron_sword"}, 16, 16);
  Diagnostics diagnostics;
  scene.content = buildContent(scene.world, &resources, diagnostics);
  EXPECT_THAT(diagnostics, IsEmpty());
  const DrawLists lists = buildDrawLists(scene, stateOf(scene));
  ASSERT_THAT(lists.draws, SizeIs(2));
  EXPECT_EQ(lists.draws[0].range.quads, 2u + 4u * 1) << "front, back and four edges";
  EXPECT_NE(skinTexel(scene, lists, 0), glm::ivec2(-1));
  EXPECT_EQ(skinTexel(scene, lists, lists.draws[1].range.firstVertex / 4), glm::ivec2(-1));
  EXPECT_NE(scene.content.lookOf("minecraft:iron_sword"), nullptr);
  EXPECT_EQ(scene.content.lookOf("minecraft:torch"), nullptr);
}

TEST(DrawLists, layers_of_an_item_have_their_colours) {
  SceneData scene = sceneOf(R"("environment": {"player": {"mainHand": "leather_boots", "offHand": "iron_sword"}})");
  const ResourceStack resources = packOf({"item/iron_sword", "item/leather_boots"}, 16, 16);
  Diagnostics diagnostics;
  scene.content = buildContent(scene.world, &resources, diagnostics);
  const DrawLists lists = buildDrawLists(scene, stateOf(scene));
  ASSERT_THAT(lists.draws, SizeIs(2));
  EXPECT_EQ(colorOf(lists, 0), glm::ivec4(0xA0, 0x65, 0x40, 255));
  EXPECT_EQ(colorOf(lists, 1), glm::ivec4(255));
}

TEST(DrawLists, what_takes_a_dye_has_it) {
  SceneData scene = sceneOf(
      R"("entities": [{"kind": "item", "item": "leather_boots", "dye": [1, 0, 0.2], "position": [4, 1, 1]},
                      {"kind": "item", "item": "iron_sword", "dye": [1, 0, 0.2], "position": [4, 1, 1]}])");
  const ResourceStack resources = packOf({"item/iron_sword", "item/leather_boots"}, 16, 16);
  Diagnostics diagnostics;
  scene.content = buildContent(scene.world, &resources, diagnostics);
  const DrawLists lists = buildDrawLists(scene, stateOf(scene));
  ASSERT_THAT(lists.draws, SizeIs(2));
  EXPECT_EQ(colorOf(lists, 0), glm::ivec4(255, 0, 51, 255));
  EXPECT_EQ(colorOf(lists, 1), glm::ivec4(255));
}

TEST(DrawLists, dropped_and_framed_items_lie_as_their_models_say) {
  const std::string display = R"("ground": {"rotation": [0, 0, 90], "translation": [0, 8, 0], "scale": [0.25, 2, 1]},
                                 "fixed": {"rotation": [0, 180, 0], "translation": [8, 0, 0], "scale": [1, 0.5, 1]})";
  const auto listsAt = [&](Entity entity) {
    entity.item = "minecraft:iron_sword";
    entity.hidden = true;
    World world = worldOf("");
    world.content.entities = {std::move(entity)};
    return posedLists(std::move(world), display);
  };
  const auto [low, high] = boundsOf(listsAt(entityOf("minecraft:item", "item")));
  EXPECT_NEAR(high.y - low.y, 0.25f, 1e-4f);
  EXPECT_NEAR((high.y + low.y) / 2, -2 + 0.1f + 0.5f + 0.5f, 0.11f) << "it swims up and down";
  Entity frame = entityOf("minecraft:item_frame", "item_frame");
  const auto straight = listsAt(frame);
  const auto [frameLow, frameHigh] = boundsOf(straight);
  expectNear(frameHigh - frameLow, {0.5f, 0.25f, 1 / 32.0f});
  expectNear((frameHigh + frameLow) * 0.5f, {-0.25f, -2, -3 + 1 / 16.0f});
  EXPECT_LT(straight.vertices[0].position[0], straight.vertices[2].position[0]) << "its front is seen";
  frame.itemTurn = 90;
  const auto [turnedLow, turnedHigh] = boundsOf(listsAt(frame));
  expectNear((turnedHigh + turnedLow) * 0.5f, {0, -2 + 0.25f, -3 + 1 / 16.0f});
}

}  // namespace
}  // namespace orris
