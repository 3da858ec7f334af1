// What a frame has besides blocks: which kinds, and their quads.
#include <orris/plan/lists/draw_lists.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <set>

#include <orris/core/files/file_source.h>
#include <orris/image/encode_png.h>
#include <orris/world/files/world_json.h>

namespace orris {
namespace {

using ::testing::ElementsAre;
using ::testing::ElementsAreArray;
using ::testing::IsEmpty;
using ::testing::SizeIs;

World worldOf(const std::string& members) {
  Diagnostics diagnostics;
  auto world = parseWorldJson({"{\"size\": [8, 8, 8], \"blocks\": [{\"box\": \"stone\", \"min\": "
                               "[0, 0, 0], \"max\": [7, 0, 7]}]" +
                                   (members.empty() ? "" : ", " + members) + "}",
                               "world.json", "test", 0, nullptr},
                              diagnostics);
  for (const Diagnostic& d : diagnostics) ADD_FAILURE() << formatDiagnostic(d);
  return std::move(world).value();
}

SceneData sceneOf(const std::string& members) {
  Diagnostics diagnostics;
  SceneData scene = buildScene(worldOf(members), {}, diagnostics);
  for (const Diagnostic& d : diagnostics) ADD_FAILURE() << formatDiagnostic(d);
  return scene;
}

FrameState stateOf(const SceneData& scene, glm::dvec3 eye = {4, 3, 7}) {
  FrameInput input;
  input.width = 64;
  input.height = 48;
  input.environment = scene.world.environment;
  input.camera.position = eye;
  return nextFrameState(input, {}, nullptr);
}

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

TEST(DrawLists, lightning_is_a_kind_from_the_start_and_drawn_while_it_is_there) {
  SceneData scene = sceneOf(R"("events": [{"frame": 3, "lightning": {"at": [1, 1, 1]}}])");
  EXPECT_EQ(scene.contents().content, bitOf(Geometry::Lightning));
  EXPECT_THAT(buildDrawLists(scene, stateOf(scene)).draws, IsEmpty());
  scene.world.content.bolts = {{{1, 1, 1}, 15}};
  EXPECT_THAT(buildDrawLists(scene, stateOf(scene)).draws, SizeIs(1));
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

/// The lowest and highest corner of what is drawn.
std::pair<glm::vec3, glm::vec3> boundsOf(const DrawLists& lists) {
  glm::vec3 low(1e9f), high(-1e9f);
  for (const GpuVertex& vertex : lists.vertices) {
    const glm::vec3 at(vertex.position[0], vertex.position[1], vertex.position[2]);
    low = glm::min(low, at);
    high = glm::max(high, at);
  }
  return {low, high};
}

DrawLists listsOf(const Entity& entity) {
  World world = worldOf("");
  world.content.entities = {entity};
  Diagnostics diagnostics;
  const SceneData scene = buildScene(std::move(world), {}, diagnostics);
  return buildDrawLists(scene, stateOf(scene));
}

Entity entityOf(const std::string& kind, const std::string& model) {
  Entity entity;
  entity.kind = kind;
  entity.model = model;
  entity.position = {4, 1, 4};
  return entity;
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

/// A resource pack whose textures have another colour in each texel.
ResourceStack packOf(const std::vector<std::string>& textures, int width, int height) {
  std::map<std::string, std::string> files;
  Image16 image(width, height, 4);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (std::size_t c = 0; c < 4; ++c)
        image.at(x, y)[c] = std::uint16_t((c == 0 ? x : c == 1 ? y : c == 2 ? 7 : 255) * 257);
  Diagnostics diagnostics;
  for (const std::string& name : textures)
    files["/minecraft/textures/" + name + ".png"] = encodePng(image, name, diagnostics).value();
  ResourceStack resources;
  resources.add("pack", memorySource(std::move(files)));
  return resources;
}

/// The texel of the skin in the middle of a quad; (-1, -1) where it wears none.
glm::ivec2 skinTexel(const SceneData& scene, const DrawLists& lists, unsigned quad) {
  const float* uv = lists.vertices[quad * 4].midUv;
  const Image8& atlas = scene.content.atlas.albedo;
  const std::uint8_t* texel = atlas.at(int(uv[0] * float(atlas.width)), int(uv[1] * float(atlas.height)));
  return texel[2] == 7 ? glm::ivec2(texel[0], texel[1]) : glm::ivec2(-1);
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
  const auto color = [&](int draw) {
    const GpuVertex& vertex = lists.vertices[lists.draws[std::size_t(draw)].range.firstVertex];
    return glm::ivec4(vertex.color[0], vertex.color[1], vertex.color[2], vertex.color[3]);
  };
  EXPECT_EQ(color(0), glm::ivec4(0xA0, 0x65, 0x40, 255));
  EXPECT_EQ(color(1), glm::ivec4(255));
}

/// An iron sword of a full square of texels, whose model has these poses.
DrawLists posedLists(World world, const std::string& display) {
  Diagnostics diagnostics;
  std::map<std::string, std::string> files;
  files["/minecraft/textures/item/a.png"] = encodePng(Image16(1, 1, 3), "a", diagnostics).value();
  files["/minecraft/models/item/iron_sword.json"] =
      R"({"parent": "builtin/generated", "textures": {"layer0": "item/a"}, "display": {)" + display + "}}";
  ResourceStack resources;
  resources.add("pack", memorySource(std::move(files)));
  SceneData scene = buildScene(std::move(world), {}, diagnostics);
  scene.content = buildContent(scene.world, &resources, diagnostics);
  for (const Diagnostic& d : diagnostics) ADD_FAILURE() << formatDiagnostic(d);
  return buildDrawLists(scene, stateOf(scene));
}

void expectNear(const glm::vec3& value, const glm::vec3& expected) {
  EXPECT_LT(glm::length(value - expected), 1e-4f) << value.x << " " << value.y << " " << value.z;
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

TEST(DrawLists, what_takes_a_dye_has_it) {
  SceneData scene = sceneOf(
      R"("entities": [{"kind": "item", "item": "leather_boots", "dye": [1, 0, 0.2], "position": [4, 1, 1]},
                      {"kind": "item", "item": "iron_sword", "dye": [1, 0, 0.2], "position": [4, 1, 1]}])");
  const ResourceStack resources = packOf({"item/iron_sword", "item/leather_boots"}, 16, 16);
  Diagnostics diagnostics;
  scene.content = buildContent(scene.world, &resources, diagnostics);
  const DrawLists lists = buildDrawLists(scene, stateOf(scene));
  ASSERT_THAT(lists.draws, SizeIs(2));
  const auto color = [&](int draw) {
    const GpuVertex& vertex = lists.vertices[lists.draws[std::size_t(draw)].range.firstVertex];
    return glm::ivec3(vertex.color[0], vertex.color[1], vertex.color[2]);
  };
  EXPECT_EQ(color(0), glm::ivec3(255, 0, 51));
  EXPECT_EQ(color(1), glm::ivec3(255));
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
