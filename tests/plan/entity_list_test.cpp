// Figures: their models, skins, armour, name tags and what they hold.
#include <orris/plan/lists/draw_lists.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "plan/list_scene.h"

namespace orris {
namespace {

using ::testing::ElementsAre;
using ::testing::ElementsAreArray;
using ::testing::IsEmpty;
using ::testing::SizeIs;

TEST(DrawLists, a_name_tag_faces_the_eye_over_the_head) {
  const SceneData scene = sceneOf(
      R"("entities": [{"kind": "player", "position": [4, 1, 1], "tag": "L", "hurt": true}])");
  const FrameState state = stateOf(scene);
  const DrawLists lists = buildDrawLists(scene, state);
  ASSERT_THAT(lists.draws, SizeIs(2));
  const ContentDraw& tag = lists.draws[1];
  EXPECT_EQ(tag.entityColor, glm::vec4(0)) << "the name is not red";
  EXPECT_EQ(tag.range.quads, 1u + 7u) << "a board and the squares of an L";
  const GpuVertex& corner = lists.vertices[tag.range.firstVertex];
  EXPECT_NEAR(corner.position[1] + state.cameraPosition.y, 1 + 32 * 0.9375 / 16 + 0.5, 0.2);
  EXPECT_EQ(corner.color[3], 64) << "the board is seen through";
  EXPECT_GT(glm::dot(glm::vec3(corner.normal[0], corner.normal[1], corner.normal[2]),
                     glm::vec3(state.gbufferModelViewInverse[2])),
            120);
}

TEST(DrawLists, a_tag_is_a_name_tag_to_the_pack) {
  const SceneData scene = sceneOf(R"("entities": [{"kind": "cow", "position": [4, 1, 1], "tag": "L"}])");
  const DrawLists lists = buildDrawLists(scene, stateOf(scene));
  ASSERT_THAT(lists.draws, SizeIs(2));
  EXPECT_EQ(lists.draws[0].entity, "minecraft:cow");
  EXPECT_EQ(lists.draws[1].entity, "minecraft:name_tag");
}

TEST(DrawLists, letters_of_a_tag_are_read_in_front_of_its_board) {
  const SceneData scene = sceneOf(R"("entities": [{"kind": "player", "position": [4, 1, 1], "tag": "L7"}])");
  const FrameState state = stateOf(scene);
  const DrawLists lists = buildDrawLists(scene, state);
  ASSERT_THAT(lists.draws, SizeIs(2));
  const QuadRange range = lists.draws[1].range;
  // Middles of the quads as the eye sees them: x to the right, y up, z towards the eye.
  std::vector<glm::vec3> middles;
  for (unsigned quad = 0; quad < range.quads; ++quad) {
    glm::vec3 middle(0);
    for (unsigned i = 0; i < 4; ++i) {
      const float* p = lists.vertices[range.firstVertex + quad * 4 + i].position;
      middle += glm::vec3(p[0], p[1], p[2]) * 0.25f;
    }
    middles.push_back(glm::vec3(state.gbufferModelView * glm::vec4(middle, 1)));
  }
  ASSERT_EQ(middles.size(), 1u + 7u + 7u);
  glm::vec2 corner(middles[1]);
  for (std::size_t i = 1; i < middles.size(); ++i) {
    EXPECT_GT(middles[i].z, middles[0].z) << "in front of the board";
    corner = {std::min(corner.x, middles[i].x), std::max(corner.y, middles[i].y)};
  }
  constexpr float kLetterSquare = 0.175f / 5;
  std::vector<std::string> rows(5, "       ");
  for (std::size_t i = 1; i < middles.size(); ++i) {
    const auto column = std::size_t(std::lround((middles[i].x - corner.x) / kLetterSquare));
    const auto row = std::size_t(std::lround((corner.y - middles[i].y) / kLetterSquare));
    rows.at(row).at(column) = '#';
  }
  EXPECT_THAT(rows, ElementsAre("#   ###",  //
                                "#     #",  //
                                "#    # ",  //
                                "#    # ",  //
                                "###  # "));
}

TEST(DrawLists, what_is_hurt_is_red_and_what_is_carried_has_its_name) {
  const SceneData scene = sceneOf(
      R"("entities": [{"kind": "cow", "position": [4, 1, 4], "hurt": true},
                      {"kind": "item_frame", "position": [2, 2, 1], "item": "stone"}])");
  const DrawLists lists = buildDrawLists(scene, stateOf(scene));
  ASSERT_THAT(lists.draws, SizeIs(3));
  EXPECT_EQ(lists.draws[0].entity, "minecraft:cow");
  EXPECT_EQ(lists.draws[0].entityColor, glm::vec4(1, 0, 0, 0.302f));
  EXPECT_EQ(lists.draws[1].entity, "minecraft:item_frame");
  EXPECT_EQ(lists.draws[1].item, "");
  EXPECT_EQ(lists.draws[2].item, "minecraft:stone");
  EXPECT_EQ(lists.draws[2].entityColor, glm::vec4(0));
}

TEST(DrawLists, an_entity_is_drawn_as_its_model_under_its_own_kind) {
  const DrawLists pig = listsOf(entityOf("minecraft:pig", "cow"));
  ASSERT_THAT(pig.draws, SizeIs(1));
  EXPECT_EQ(pig.draws[0].entity, "minecraft:pig");
  EXPECT_EQ(pig.vertices.size(), listsOf(entityOf("minecraft:cow", "cow")).vertices.size());
}

TEST(DrawLists, entities_have_sizes_and_lie_on_their_backs) {
  Entity frame = entityOf("minecraft:item_frame", "item_frame");
  const auto [wallLow, wallHigh] = boundsOf(listsOf(frame));
  EXPECT_NEAR(wallHigh.y - wallLow.y, 0.75f, 1e-4f);
  frame.pitch = -90;  // it looks up
  const auto [low, high] = boundsOf(listsOf(frame));
  EXPECT_NEAR(high.y - low.y, 1 / 16.0f, 1e-4f);
  EXPECT_NEAR(high.y, 1 / 16.0f - 2, 1e-4f) << "its back on the floor, two blocks below the eye";
  Entity slime = entityOf("minecraft:slime", "slime");
  slime.scale = 2;
  const auto [slimeLow, slimeHigh] = boundsOf(listsOf(slime));
  EXPECT_NEAR(slimeHigh.y - slimeLow.y, 1.5f, 1e-4f);
}

TEST(DrawLists, what_is_hidden_still_wears_its_armour) {
  Entity stand = entityOf("minecraft:armor_stand", "armor_stand");
  stand.armour = {"minecraft:iron_helmet", "minecraft:iron_chestplate"};
  const std::size_t all = listsOf(stand).vertices.size();
  stand.armour.clear();
  const std::size_t bare = listsOf(stand).vertices.size();
  stand.armour = {"minecraft:iron_helmet", "minecraft:iron_chestplate"};
  stand.hidden = true;
  const std::size_t worn = listsOf(stand).vertices.size();
  EXPECT_GT(bare, 0u);
  EXPECT_EQ(worn, 4u * 6 * 4) << "four plates";
  EXPECT_EQ(bare + worn, all);
  stand.armour.clear();
  EXPECT_THAT(listsOf(stand).vertices, IsEmpty());
  stand.glint = true;
  EXPECT_THAT(listsOf(stand).vertices, IsEmpty()) << "no glint of armour that is not there";
}

TEST(DrawLists, each_piece_of_armour_is_a_draw_with_its_item) {
  Entity zombie = entityOf("minecraft:zombie", "player");
  const std::size_t bare = listsOf(zombie).vertices.size();
  zombie.armour = {"minecraft:golden_helmet", "minecraft:leather_chestplate", "minecraft:iron_leggings", "minecraft:iron_boots"};
  zombie.dye = glm::vec3(0, 0.5f, 1);
  const DrawLists lists = listsOf(zombie);
  std::vector<std::string> items;
  std::vector<unsigned> sides;
  for (const ContentDraw& draw : lists.draws)
    if (!draw.item.empty()) {
      items.push_back(draw.item);
      sides.push_back(draw.range.quads);
      EXPECT_EQ(draw.entity, "minecraft:zombie");
      EXPECT_EQ(draw.geometry, Geometry::Entities);
    }
  EXPECT_THAT(items, ElementsAreArray(zombie.armour));
  EXPECT_THAT(sides, ElementsAre(6, 18, 18, 12)) << "a helmet, a plate and two sleeves, hips and two legs, two feet";
  EXPECT_EQ(lists.vertices.size(), bare + 4u * 54);
  const auto colorOf = [&](const std::string& item) {
    for (const ContentDraw& draw : lists.draws)
      if (draw.item == item) {
        const GpuVertex& v = lists.vertices[draw.range.firstVertex];
        return glm::ivec3(v.color[0], v.color[1], v.color[2]);
      }
    return glm::ivec3(-1);
  };
  EXPECT_LT(colorOf("minecraft:golden_helmet").b, 100) << "gold is yellow";
  EXPECT_EQ(colorOf("minecraft:leather_chestplate"), glm::ivec3(0, 128, 255)) << "leather takes the dye";
  EXPECT_EQ(colorOf("minecraft:iron_boots"), glm::ivec3(255));
}

TEST(DrawLists, what_has_no_shape_for_armour_wears_none) {
  Entity cow = entityOf("minecraft:cow", "cow");
  const std::size_t bare = listsOf(cow).vertices.size();
  cow.armour = {"minecraft:iron_helmet"};
  cow.glint = true;
  EXPECT_EQ(listsOf(cow).vertices.size(), bare);
}

TEST(DrawLists, a_figure_wears_the_skin_of_a_resource_pack) {
  SceneData scene = sceneOf(R"("entities": [{"kind": "player", "position": [4, 1, 1]}])");
  const std::size_t own = buildDrawLists(scene, stateOf(scene)).vertices.size();
  EXPECT_EQ(own, 6u * 6 * 4) << "no outer layer without a skin";
  const ResourceStack resources = packOf({"entity/player/wide/steve"}, 64, 64);
  Diagnostics diagnostics;
  scene.content = buildContent(scene.world, &resources, diagnostics);
  const DrawLists lists = buildDrawLists(scene, stateOf(scene));
  EXPECT_EQ(lists.vertices.size(), 2 * own);
  constexpr unsigned kHead = 5, kSouth = 3, kWest = 4;
  EXPECT_EQ(skinTexel(scene, lists, kHead * 6 + kSouth), glm::ivec2(12, 12)) << "the face";
  EXPECT_EQ(skinTexel(scene, lists, kHead * 6 + kWest), glm::ivec2(4, 12)) << "its right side";
  EXPECT_EQ(skinTexel(scene, lists, 11 * 6 + kSouth), glm::ivec2(44, 12)) << "the hat";
}

TEST(DrawLists, a_skin_of_more_texels_lies_alike_and_other_figures_keep_theirs) {
  SceneData scene = sceneOf(
      R"("entities": [{"kind": "cow", "position": [4, 1, 1]}, {"kind": "slime", "position": [1, 1, 1]}])");
  const ResourceStack resources = packOf({"entity/cow/cow"}, 128, 64);
  Diagnostics diagnostics;
  scene.content = buildContent(scene.world, &resources, diagnostics);
  const DrawLists lists = buildDrawLists(scene, stateOf(scene));
  ASSERT_THAT(lists.draws, SizeIs(3)) << "cow, slime, its skin";
  constexpr unsigned kHead = 5, kSouth = 3;
  EXPECT_EQ(skinTexel(scene, lists, kHead * 6 + kSouth), glm::ivec2(20, 20)) << "twice (10, 10)";
  EXPECT_EQ(skinTexel(scene, lists, lists.draws[1].range.firstVertex / 4), glm::ivec2(-1));
  EXPECT_EQ(lists.draws[1].range.quads, 6u) << "eyes of a slime are seen with its skin alone";
}

// By the game's numbers: the hand hangs 10/16 below the shoulder, 5/16 beside the middle, an item 2/16 before it.
TEST(DrawLists, a_figure_holds_items_in_both_hands) {
  const auto held = [](const std::string& hand, const std::string& display, const std::string& more = "") {
    const DrawLists lists = posedLists(
        worldOf(R"("entities": [{"kind": "player", "position": [4, 1, 4], ")" + hand + R"(": "iron_sword")" + more + "}]"),
        display);
    EXPECT_THAT(lists.draws, SizeIs(2)) << hand;
    EXPECT_EQ(lists.draws[1].item, "minecraft:iron_sword");
    DrawLists item;
    const QuadRange& range = lists.draws[1].range;
    item.vertices.assign(lists.vertices.begin() + range.firstVertex,
                         lists.vertices.begin() + range.firstVertex + range.quads * 4);
    return boundsOf(item);
  };
  constexpr float kScale = 0.9375f;
  const std::string display = R"("thirdperson_righthand": {"scale": [0.5, 0.25, 1]})";
  for (const bool left : {false, true}) {
    const auto [low, high] = held(left ? "offHand" : "mainHand", display);
    // The item's up is the figure's front.
    expectNear(high - low, glm::vec3(0.5f, 1 / 16.0f, 0.25f) * kScale);
    const glm::vec3 feet = glm::vec3(4, 1, 4) - glm::vec3(4, 3, 7);
    expectNear((high + low) * 0.5f, feet + glm::vec3(left ? 6 : -6, 22 - 10, 2) / 16.0f * kScale);
  }
  const auto [low, high] = held("mainHand", display, R"(, "yaw": 90)");
  EXPECT_LT((high + low).x * 0.5f, 0) << "towards west";
}

}  // namespace
}  // namespace orris
