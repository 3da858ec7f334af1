// What the player holds.
#include <orris/plan/lists/draw_lists.h>

#include <gmock/gmock.h>

#include "plan/list_scene.h"

namespace orris {
namespace {

TEST(DrawLists, the_glint_of_the_hand_lies_on_its_item) {
  const SceneData scene = sceneOf(R"("environment": {"player": {"mainHand": "torch", "glint": true}})");
  const DrawLists lists = buildDrawLists(scene, stateOf(scene));
  const auto placesOf = [&](Geometry kind) {
    std::vector<glm::vec3> places;
    for (const ContentDraw& draw : lists.draws)
      for (unsigned i = 0; draw.geometry == kind && i < draw.range.quads * 4; ++i) {
        const float* p = lists.vertices[draw.range.firstVertex + i].position;
        places.emplace_back(p[0], p[1], p[2]);
      }
    return places;
  };
  EXPECT_FALSE(placesOf(Geometry::Hand).empty());
  EXPECT_EQ(placesOf(Geometry::HandGlint), placesOf(Geometry::Hand));
}

TEST(DrawLists, a_hand_holds_an_item_as_its_model_says) {
  const std::string display = R"("firstperson_righthand": {"translation": [16, 0, 0], "scale": [0.5, 0.25, 1]})";
  for (const bool left : {false, true}) {
    const auto [low, high] = boundsOf(posedLists(
        worldOf(std::string(R"("environment": {"player": {")") + (left ? "offHand" : "mainHand") + R"(": "iron_sword"}})"),
        display));
    expectNear(high - low, {0.5f, 0.25f, 1 / 16.0f});
    expectNear((high + low) * 0.5f, {left ? -1.56f : 1.56f, -0.52f, -0.72f});
  }
}

}  // namespace
}  // namespace orris
