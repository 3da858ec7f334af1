#include <orris/world/world.h>

#include <gtest/gtest.h>

#include <filesystem>

#include "support/folder_test.h"
#include <orris/world/standing_camera.h>
#include <orris/world/world_summary.h>
#include "nbt_builder.h"
#include "world_helpers.h"

namespace orris {
namespace {

namespace fs = std::filesystem;

glm::vec3 directionOf(const Camera& camera) {
  const float yaw = glm::radians(camera.yaw), pitch = glm::radians(camera.pitch);
  return {-std::sin(yaw) * std::cos(pitch), -std::sin(pitch), std::cos(yaw) * std::cos(pitch)};
}

class OwnWorlds : public testing::TestWithParam<const char*> {};

TEST_P(OwnWorlds, load_without_unknown_blocks_and_with_free_cameras) {
  Diagnostics diagnostics;
  const std::string folder = std::string(ORRIS_SOURCE_DIR "/worlds/") + GetParam();
  const auto world = loadWorld(folder, 0, diagnostics);
  ASSERT_TRUE(world) << joined(diagnostics);
  EXPECT_EQ(world->name, GetParam());
  EXPECT_FALSE(world->exercises.empty());
  EXPECT_FALSE(world->cameras.empty());
  const std::vector<BlockFacts> facts = factsOfPalette(BlockTable(), world->blocks, diagnostics);
  EXPECT_EQ(joined(diagnostics), "");
  for (const Camera& camera : world->cameras) {
    const BlockFacts& around = facts[world->blocks.indexAt(glm::ivec3(glm::floor(camera.position)))];
    EXPECT_TRUE(around.air || around.fluid) << camera.name << " stands in a block";
  }
}

INSTANTIATE_TEST_SUITE_P(All, OwnWorlds,
                         testing::Values("cornell", "corridor", "h1_room", "h2_box", "h3_corridor",
                                         "h4_house", "h5_two_rooms", "h6_hall", "lamps", "pillars",
                                         "rooms", "hills", "terrain", "village"));

/// The first block that is not air from the camera through the point of the picture at (x, y) in
/// -1..1, aspect 1.
std::string blockSeen(const World& world, const Camera& camera, float x, float y) {
  const glm::vec3 forward = directionOf(camera);
  const glm::vec3 right = glm::normalize(glm::cross(forward, glm::vec3(0, 1, 0)));
  const glm::vec3 up = glm::cross(right, forward);
  const float half = std::tan(glm::radians(camera.fov) / 2);
  const glm::dvec3 step(glm::normalize(forward + (right * x + up * y) * half) * 0.02f);
  glm::dvec3 p = camera.position;
  for (int i = 0; i < 5000; ++i, p += step) {
    const BlockState& state = world.blocks.at(glm::ivec3(glm::floor(p)));
    if (state.name != "minecraft:air") return state.name;
  }
  return "sky";
}

TEST(Worlds, a_camera_outside_is_as_near_as_what_is_there_allows) {
  BlockWorld wide({0, 0, 0}, {64, 64, 64}), narrow({20, 24, 28}, {8, 8, 8});
  for (BlockWorld* blocks : {&wide, &narrow})
    blocks->fill({20, 24, 28}, {27, 31, 35}, blocks->paletteIndex(blockState("stone")));
  EXPECT_EQ(outsideCamera(wide, "a").position, outsideCamera(narrow, "a").position);
}

TEST(Worlds, cornell_camera_sees_both_walls_the_blocks_and_the_lamp) {
  Diagnostics diagnostics;
  const auto world = loadWorld(ORRIS_SOURCE_DIR "/worlds/cornell", 0, diagnostics);
  ASSERT_TRUE(world) << joined(diagnostics);
  std::map<std::string, int> seen;
  for (int i = 0; i < 64 * 64; ++i) {
    ++seen[blockSeen(*world, world->cameras[0], float(i % 64) / 32 - 1, float(i / 64) / 32 - 1)];
  }
  EXPECT_GT(seen["minecraft:red_concrete"], 200);
  EXPECT_GT(seen["minecraft:lime_concrete"], 200);
  EXPECT_GT(seen["minecraft:sea_lantern"], 10);
  EXPECT_GT(seen["minecraft:white_concrete"], 1000);
  EXPECT_EQ(seen["sky"], 0);
}

TEST(Worlds, cornell_has_no_sky_light_inside) {
  Diagnostics diagnostics;
  const auto world = loadWorld(ORRIS_SOURCE_DIR "/worlds/cornell", 0, diagnostics);
  ASSERT_TRUE(world);
  const auto facts = factsOfPalette(BlockTable(), world->blocks, diagnostics);
  const LightLevels light(world->blocks, facts);
  for (int x = 1; x < 15; ++x) {
    for (int z = 1; z < 26; ++z) EXPECT_EQ(light.sky({x, 5, z}), 0);
  }
  EXPECT_EQ(light.block({7, 9, 6}), 14);
}

TEST(Worlds, corridor_hides_its_lamp_from_the_corner_camera) {
  Diagnostics diagnostics;
  const auto world = loadWorld(ORRIS_SOURCE_DIR "/worlds/corridor", 0, diagnostics);
  ASSERT_TRUE(world) << joined(diagnostics);
  for (int i = 0; i < 64 * 64; ++i) {
    EXPECT_NE(blockSeen(*world, world->cameras[0], float(i % 64) / 32 - 1, float(i / 64) / 32 - 1),
              "minecraft:sea_lantern");
  }
}

TEST(Worlds, folder_file_and_schematic_are_distinguished) {
  Diagnostics diagnostics;
  EXPECT_TRUE(loadWorld(ORRIS_SOURCE_DIR "/worlds/cornell/world.json", 0, diagnostics));
  EXPECT_EQ(joined(diagnostics), "");
  EXPECT_FALSE(loadWorld("no/such/world", 0, diagnostics));
  EXPECT_EQ(joined(diagnostics),
            "no/such/world: error: no such file or folder\n"
            "  hint: WORLD is a folder with world.json, a world.json, a schematic (.schem, .schematic, "
            ".litematic, .nbt), a save, a region file (.mca), or a Luanti world or its map.sqlite");
}

class WorldFiles : public test::FolderTest {};

TEST_F(WorldFiles, link_that_leaves_the_folder_is_not_followed) {
  write("secret.schem", "x");
  fs::create_directories(folder_ / "inner");
  fs::create_symlink(folder_ / "secret.schem", folder_ / "inner/house.schem");
  write("inner/world.json", R"({"from": "house.schem"})");
  Diagnostics diagnostics;
  EXPECT_FALSE(loadWorld((folder_ / "inner").string(), 0, diagnostics));
  ASSERT_EQ(diagnostics.size(), 1u);
  EXPECT_EQ(diagnostics[0].message, "cannot read \"house.schem\"");
}

TEST_F(WorldFiles, schematics_lie_under_the_clouds_of_the_game) {
  Diagnostics diagnostics;
  const auto world = loadWorld(write("house.schem", SchematicParts().file()), 0, diagnostics);
  ASSERT_TRUE(world) << joined(diagnostics);
  EXPECT_EQ(world->environment.clouds, Clouds::Fancy);
}

TEST_F(WorldFiles, palette_holds_what_events_set_and_the_water_of_waterlogged_blocks) {
  write("inner/world.json", R"({"size": [1, 1, 1],
    "blocks": [{"block": "oak_fence[waterlogged=true]", "at": [0, 0, 0]}],
    "events": [{"frame": 3, "set": {"block": "torch", "at": [0, 0, 0]}}]})");
  Diagnostics diagnostics;
  auto world = loadWorld((folder_ / "inner").string(), 0, diagnostics);
  ASSERT_TRUE(world) << joined(diagnostics);
  const std::size_t size = world->blocks.palette().size();
  world->blocks.paletteIndex(blockState("torch"));
  world->blocks.paletteIndex(blockState("water"));
  EXPECT_EQ(world->blocks.palette().size(), size);
}

TEST(Worlds, default_cameras_see_the_whole_box) {
  for (const glm::ivec3 size : {glm::ivec3(3, 3, 3), glm::ivec3(40, 5, 10), glm::ivec3(4, 60, 4)}) {
    const BlockWorld blocks({5, -3, 9}, size);
    const Camera camera = defaultCameras(blocks).at(0);
    const glm::vec3 forward = directionOf(camera);
    const glm::vec3 right = glm::normalize(glm::cross(forward, glm::vec3(0, 1, 0)));
    const glm::vec3 up = glm::cross(right, forward);
    const float slope = std::tan(glm::radians(camera.fov) / 2);
    float widest = 0;
    for (int i = 0; i < 8; ++i) {
      const glm::ivec3 corner = blocks.origin() + size * glm::ivec3(i & 1, i >> 1 & 1, i >> 2);
      const glm::vec3 d(glm::dvec3(corner) - camera.position);
      const float depth = glm::dot(d, forward);
      ASSERT_GT(depth, 0);
      widest = std::max({widest, std::abs(glm::dot(d, right)) / depth / slope,
                         std::abs(glm::dot(d, up)) / depth / slope});
    }
    EXPECT_LT(widest, 1) << "all corners are in a square picture";
    EXPECT_GT(widest, 0.9f) << "and fill it";
  }
}

TEST(Worlds, inside_camera_looks_along_the_longest_view) {
  Scene scene({5, 4, 9});
  scene.fill({0, 0, 0}, {4, 3, 8}, "stone");
  scene.fill({2, 1, 1}, {2, 2, 5}, "air");
  const std::vector<Camera> cameras = defaultCameras(scene.blocks);
  ASSERT_EQ(cameras.size(), 2u);
  EXPECT_EQ(cameras[1].position, glm::dvec3(2.5, 2.62, 4.5));
  EXPECT_EQ(cameras[1].yaw, 180);
}

TEST(Worlds, summary_counts_blocks_faces_and_lights) {
  Scene scene({3, 1, 3});
  scene.fill({0, 0, 0}, {2, 0, 1}, "stone");
  scene.set({0, 0, 2}, "glowstone");
  scene.set({1, 0, 2}, "mod:thing");
  scene.set({2, 0, 2}, "red_stained_glass");
  const WorldSummary summary = summarize(scene.blocks, scene.facts(), scene.mesh());
  EXPECT_EQ(summary.size, glm::ivec3(3, 1, 3));
  EXPECT_EQ(summary.blocks, 9);
  EXPECT_EQ(summary.lights, 1);
  EXPECT_EQ(summary.unknown, std::vector<std::string>{"mod:thing"});
  ASSERT_EQ(summary.states.size(), 4u);
  EXPECT_EQ(summary.states[0].state.name, "minecraft:stone");
  EXPECT_EQ(summary.states[0].count, 6);
  EXPECT_EQ(summary.states[1].emission, 15);
  // Glass shows five sides: the solid blocks beside it hide the others of its own.
  EXPECT_EQ(summary.faces[int(RenderLayer::Translucent)], 4);
}

}  // namespace
}  // namespace orris
