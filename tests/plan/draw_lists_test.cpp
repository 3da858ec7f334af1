// What a frame has besides blocks: which kinds, and their quads.
#include <orris/plan/lists/draw_lists.h>

#include <gmock/gmock.h>

#include <set>

#include "plan/list_scene.h"

namespace orris {
namespace {

using ::testing::IsEmpty;

std::set<Geometry> drawn(const DrawLists& lists) {
  std::set<Geometry> kinds;
  for (const ContentDraw& draw : lists.draws) kinds.insert(draw.geometry);
  return kinds;
}

TEST(DrawLists, a_world_of_blocks_has_none_and_makes_no_texture) {
  const SceneData scene = sceneOf("");
  EXPECT_EQ(scene.contents().content, 0u);
  EXPECT_EQ(scene.content.atlas.albedo.width, 0);
  const DrawLists lists = buildDrawLists(scene, stateOf(scene));
  EXPECT_THAT(lists.draws, IsEmpty());
  EXPECT_THAT(lists.vertices, IsEmpty());
}

TEST(DrawLists, each_thing_has_its_kinds_and_no_other) {
  using G = Geometry;
  const auto entity = [](const std::string& more) {
    return "\"entities\": [{\"position\": [4, 1, 4], " + more + "}]";
  };
  const auto player = [](const std::string& more) {
    return "\"environment\": {\"player\": {" + more + "}}";
  };
  const std::pair<std::string, std::set<Geometry>> rows[] = {
      {entity(R"("kind": "cow")"), {G::Entities}},
      {entity(R"("kind": "cow", "leash": [1, 1, 1])"), {G::Entities, G::Leash}},
      {entity(R"("kind": "spider")"), {G::Entities, G::Eyes}},
      {entity(R"("kind": "slime")"), {G::Entities, G::EntitiesTranslucent}},
      {entity(R"("kind": "armor_stand", "glint": true)"), {G::Entities, G::Glint}},
      {entity(R"("kind": "cow", "tag": "BESSY")"), {G::Entities, G::EntitiesTranslucent}},
      {player(R"("mainHand": "iron_sword", "glint": true)"), {G::Hand, G::HandGlint}},
      {player(R"("mainHand": "air", "glint": true)"), {G::Hand}},
      {player(R"("mainHand": "red_stained_glass", "glint": true)"), {G::HandTranslucent}},
      {entity(R"("kind": "player", "mainHand": "red_stained_glass")"), {G::Entities, G::EntitiesTranslucent}},
      {entity(R"("kind": "player", "offHand": "torch", "glint": true)"), {G::Entities, G::Glint}},
      {entity(R"("kind": "cow", "mainHand": "red_stained_glass")"), {G::Entities}},
      {entity(R"("kind": "item", "item": "stone")"), {G::Entities}},
      {entity(R"("kind": "item", "item": "red_stained_glass")"), {G::EntitiesTranslucent}},
      {entity(R"("kind": "item", "item": "iron_sword")"), {G::Entities}},
      {R"("particles": [{"kind": "smoke", "position": [4, 2, 4]}])", {G::Particles}},
      {R"("particles": [{"kind": "spark", "position": [4, 2, 4]}])", {G::ParticlesTranslucent}},
      {R"("beams": [{"at": [4, 0, 4]}])", {G::BeamCore, G::BeamGlow}},
      {R"("damaged": [{"at": [4, 0, 4]}])", {G::Cracks}},
      {R"("texts": [{"text": "A", "at": [4, 0, 4], "position": [4, 2, 4]}])", {G::BlockText}},
      {R"("selected": [4, 0, 4])", {G::Outline}},
      {R"("border": {"min": [0, 0], "max": [8, 8]})", {G::Border}},
      {player(R"("mainHand": "torch")"), {G::Hand}},
      {player(R"("offHand": "air")"), {G::Hand}},
      {player(R"("offHand": "glass", "mainHand": "red_stained_glass")"),
       {G::Hand, G::HandTranslucent}},
      {player(R"("mainHand": "torch", "hideGui": true)"), {}},
      {player(R"("body": true)"), {G::PlayerBody}},
      {R"("environment": {"rain": 1})", {G::Rain}},
      {R"("environment": {"rain": 1, "temperature": 0})", {G::Snow}},
      {R"("environment": {"rain": 1, "rainfall": 0})", {}},
      {R"("environment": {"rain": 1, "dimension": "minecraft:the_nether"})", {}}};
  for (const auto& [members, kinds] : rows) {
    const SceneData scene = sceneOf(members);
    GeometrySet bits = 0;
    for (const Geometry kind : kinds) bits |= bitOf(kind);
    EXPECT_EQ(scene.contents().content, bits) << members;
    EXPECT_EQ(drawn(buildDrawLists(scene, stateOf(scene))), kinds) << members;
  }
}

TEST(DrawLists, sides_of_a_model_look_outwards) {
  const SceneData scene =
      sceneOf(R"("entities": [{"kind": "slime", "position": [4, 1, 4], "yaw": 30}])");
  const FrameState state = stateOf(scene);
  const DrawLists lists = buildDrawLists(scene, state);
  ASSERT_FALSE(lists.draws.empty());
  const glm::vec3 middle(glm::dvec3(4, 1.4, 4) - state.cameraPosition);
  for (std::size_t i = 0; i < lists.vertices.size(); i += 4) {
    glm::vec3 corner[4];
    for (int k = 0; k < 4; ++k) {
      const GpuVertex& v = lists.vertices[i + static_cast<std::size_t>(k)];
      corner[k] = {v.position[0], v.position[1], v.position[2]};
    }
    const glm::vec3 out = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
    EXPECT_GT(glm::dot(out, corner[0] - middle), 0) << i;
    const GpuVertex& v = lists.vertices[i];
    EXPECT_GT(glm::dot(out, glm::vec3(v.normal[0], v.normal[1], v.normal[2])), 0) << i;
  }
}

TEST(DrawLists, entities_walk_and_particles_rise_with_time) {
  const SceneData scene = sceneOf(
      R"("entities": [{"kind": "player", "position": [4, 1, 4], "walking": true}],
         "particles": [{"kind": "smoke", "position": [2, 1, 2]}])");
  FrameState state = stateOf(scene);
  const DrawLists first = buildDrawLists(scene, state), again = buildDrawLists(scene, state);
  state.frameTimeCounter += 0.1f;
  const DrawLists later = buildDrawLists(scene, state);
  const auto moved = [&](const DrawLists& other, const ContentDraw& draw) {
    const auto at = [&](const DrawLists& lists, unsigned i) {
      return lists.vertices[draw.range.firstVertex + i].position[1];
    };
    for (unsigned i = 0; i < draw.range.quads * 4; ++i)
      if (at(first, i) != at(other, i)) return true;
    return false;
  };
  for (const ContentDraw& draw : first.draws) {
    EXPECT_FALSE(moved(again, draw));
    EXPECT_TRUE(moved(later, draw));
  }
}

}  // namespace
}  // namespace orris
