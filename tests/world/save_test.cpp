#include <orris/world/saves/save.h>

#include <gtest/gtest.h>

#include <cmath>

#include "region_builder.h"
#include "support/folder_test.h"
#include "world_helpers.h"

namespace orris {
namespace {

namespace fs = std::filesystem;

class Saves : public test::FolderTest {
 protected:
  void SetUp() override { fs::create_directories(folder_ / "region"); }

  void writeLevel(const std::string& members) {
    write("level.dat", gzip(nbtCompound("", nbtCompound("Data", members))));
  }
  /// Chunks (0..4, 0..4) of a region: a floor of stone at y 0 and at y -64.
  static std::string plainRegion() {
    ChunkParts parts;
    parts.sections = {stoneFloor(-4), stoneFloor(0)};
    RegionParts region;
    for (int i = 0; i < 25; ++i) region.add(i % 5, i / 5, parts.tags());
    return region.file();
  }
  std::optional<World> load(const SavePart& part = {}, const std::string& below = "") {
    diagnostics_.clear();
    return loadWorld((below.empty() ? folder_ : folder_ / below).string(), 0, diagnostics_, part);
  }

  Diagnostics diagnostics_;
};

TEST_F(Saves, fences_of_numeric_ids_meet) {
  std::string ids(4096, '\0');
  ids[0] = ids[1] = 85;
  const std::string section =
      closed(nbtByte("Y", 0) + nbtByteArray("Blocks", ids) + nbtByteArray("Data", std::string(2048, '\0')));
  RegionParts region;
  region.add(0, 0, nbtCompound("", nbtCompound("Level", nbtList("Sections", 10, {section}))));
  write("region/r.0.0.mca", region.file());
  const auto world = load({.at = glm::ivec2(8, 8), .radius = 0});
  ASSERT_TRUE(world) << joined(diagnostics_);
  EXPECT_EQ(world->blocks.at({0, 0, 0}).properties.at("east"), "true");
  EXPECT_EQ(world->blocks.at({1, 0, 0}).properties.at("east"), "false");
}

TEST_F(Saves, part_around_the_player_with_time_weather_and_eye) {
  write("region/r.0.0.mca", plainRegion());
  writeLevel(
      nbtString("LevelName", "home") + nbtLong("DayTime", 24000 * 3 + 13000) +
      nbtByte("raining", 1) +
      nbtCompound("Player", nbtDoubles("Pos", {20.5, 1, 40.5}) +
                                nbtList("Rotation", 5,
                                        {bigEndian(std::bit_cast<std::uint32_t>(90.0f), 4),
                                         bigEndian(std::bit_cast<std::uint32_t>(10.0f), 4)}) +
                                nbtString("Dimension", "minecraft:overworld")));
  const auto world = load({.radius = 1});
  ASSERT_TRUE(world) << joined(diagnostics_);
  EXPECT_EQ(joined(diagnostics_), "");
  EXPECT_EQ(world->name, "home");
  EXPECT_EQ(world->environment.time, 13000);
  EXPECT_EQ(world->environment.day, 3);
  EXPECT_EQ(world->environment.rain, 1);
  EXPECT_EQ(world->environment.biome, "minecraft:desert");
  EXPECT_EQ(world->environment.rainfall, 0);
  EXPECT_EQ(world->blocks.origin(), glm::ivec3(0, -64, 16));
  EXPECT_EQ(world->blocks.size(), glm::ivec3(48, 80, 48));
  EXPECT_EQ(world->blocks.at({20, -64, 40}).name, "minecraft:stone");
  EXPECT_EQ(world->blocks.at({20, 1, 40}).name, "minecraft:air");
  ASSERT_GE(world->cameras.size(), 3u);
  EXPECT_EQ(world->cameras[0].name, "player");
  EXPECT_EQ(world->cameras[0].position, glm::dvec3(20.5, 2.62, 40.5));
  EXPECT_EQ(world->cameras[0].yaw, 90);
  EXPECT_EQ(world->cameras[1].name, "surface");
  EXPECT_EQ(world->cameras[1].position, glm::dvec3(20.5, 2.62, 40.5));
}

TEST_F(Saves, without_level_dat_the_middle_of_the_regions_is_taken) {
  write("region/r.-1.0.mca", plainRegion());
  for (const char* below : {"", "region", "region/r.-1.0.mca"}) {
    const auto world = load({.radius = 0}, below);
    ASSERT_TRUE(world) << below << joined(diagnostics_);
    EXPECT_EQ(world->blocks.origin(), glm::ivec3(-32 * 16 + 32, -64, 32)) << below;
  }
}

TEST_F(Saves, chunks_left_out_are_counted_and_named_in_one_warning) {
  ChunkParts parts;
  parts.sections = {stoneFloor(0)};
  RegionParts region;
  region.add(1, 1, parts.tags());
  region.chunks[{2, 1}] = {2, "damaged"};
  parts.status = "minecraft:carvers";
  region.add(0, 1, parts.tags());
  write("region/r.0.0.mca", region.file());
  const auto world = load({.at = glm::ivec2(20, 20), .radius = 1});
  ASSERT_TRUE(world) << joined(diagnostics_);
  ASSERT_EQ(diagnostics_.size(), 1u);
  EXPECT_EQ(diagnostics_[0].id, "chunks-left-out");
  EXPECT_EQ(
      diagnostics_[0].message,
      "8 of 9 chunks are left out: 6 that the save does not hold, 1 that the game has only begun, "
      "1 that cannot be read");
  EXPECT_EQ(diagnostics_[0].notes,
            std::vector<std::string>{"chunk (2, 1): its compressed data is damaged"});
}

TEST_F(Saves, dimensions_lie_in_folders_of_their_own) {
  write("region/r.0.0.mca", plainRegion());
  write("DIM-1/region/r.0.0.mca", plainRegion());
  write("dimensions/mod/deep/region/r.0.0.mca", plainRegion());
  writeLevel(nbtInt("SpawnX", 8) + nbtInt("SpawnY", 70) + nbtInt("SpawnZ", 8));
  auto world = load({.radius = 0, .dimension = "minecraft:the_nether"});
  ASSERT_TRUE(world) << joined(diagnostics_);
  EXPECT_EQ(world->environment.dimension, "minecraft:the_nether");
  EXPECT_TRUE(load({.radius = 0, .dimension = "mod:deep"})) << joined(diagnostics_);
  world = load({.radius = 0}, "DIM-1");
  ASSERT_TRUE(world) << joined(diagnostics_);
  EXPECT_EQ(world->environment.dimension, "minecraft:the_nether");
  EXPECT_FALSE(load({.dimension = "minecraft:the_end"}));
  ASSERT_EQ(diagnostics_.size(), 1u);
  EXPECT_EQ(diagnostics_[0].message,
            "this save has no region files (r.X.Z.mca) of minecraft:the_end");
  EXPECT_EQ(diagnostics_[0].hint, "it has minecraft:overworld, minecraft:the_nether");
}

TEST_F(Saves, a_place_without_chunks_is_an_error_that_names_one_with_them) {
  write("region/r.0.0.mca", plainRegion());
  EXPECT_FALSE(load({.at = glm::ivec2(5000, 5000), .radius = 1}));
  ASSERT_EQ(diagnostics_.size(), 2u);
  EXPECT_EQ(diagnostics_[1].message,
            "no finished chunk lies within 1 chunks of block (5000, 5000)");
  EXPECT_EQ(diagnostics_[1].hint, "the middle of the save is --at 40,40");
}

TEST_F(Saves, damaged_level_dat_is_a_warning) {
  write("region/r.0.0.mca", plainRegion());
  write("level.dat", "damaged");
  EXPECT_TRUE(load({.radius = 0}));
  ASSERT_EQ(diagnostics_.size(), 1u);
  EXPECT_EQ(diagnostics_[0].id, "level-unreadable");
}

TEST_F(Saves, link_that_leaves_the_save_is_not_followed) {
  write("outside.mca", plainRegion());
  fs::create_directories(folder_ / "inner/region");
  fs::create_symlink(folder_ / "outside.mca", folder_ / "inner/region/r.0.0.mca");
  EXPECT_FALSE(load({.at = glm::ivec2(8, 8), .radius = 0}, "inner"));
  ASSERT_FALSE(diagnostics_.empty());
  ASSERT_EQ(diagnostics_[0].notes.size(), 1u);
  EXPECT_NE(diagnostics_[0].notes[0].find("leads out"), std::string::npos)
      << diagnostics_[0].notes[0];
}

std::string cow(double x, double y, double z, const std::string& more = "") {
  return closed(nbtString("id", "minecraft:cow") + nbtDoubles("Pos", {x, y, z}) + more);
}
std::string entityChunk(const std::vector<std::string>& entities) {
  return nbtCompound("", nbtInt("DataVersion", 3465) + nbtList("Entities", 10, entities));
}

TEST_F(Saves, entities_of_games_before_1_17_come_from_the_chunk) {
  ChunkParts parts;
  parts.format = ChunkFormat::Level116;
  parts.sections = {stoneFloor(0)};
  parts.entities = {cow(8.5, 1, 8.5)};
  RegionParts region;
  region.add(0, 0, parts.tags());
  write("region/r.0.0.mca", region.file());
  const auto world = load({.at = glm::ivec2(8, 8), .radius = 0});
  ASSERT_TRUE(world) << joined(diagnostics_);
  EXPECT_EQ(joined(diagnostics_), "");
  ASSERT_EQ(world->content.entities.size(), 1u);
  EXPECT_EQ(world->content.entities[0].kind, "minecraft:cow");
  EXPECT_EQ(world->content.entities[0].position, glm::dvec3(8.5, 1, 8.5));
}

TEST_F(Saves, entities_of_1_17_and_later_come_from_the_folder_beside_the_region) {
  write("region/r.0.0.mca", plainRegion());
  write("level.dat", "");
  RegionParts entities;
  entities.add(1, 1, entityChunk({cow(20, 1, 20)}));
  entities.add(3, 3, entityChunk({cow(50, 1, 50)}));
  fs::create_directories(folder_ / "entities");
  write("entities/r.0.0.mca", entities.file());
  const auto world = load({.at = glm::ivec2(20, 20), .radius = 1});
  ASSERT_TRUE(world) << joined(diagnostics_);
  ASSERT_EQ(world->content.entities.size(), 1u) << "the other stands outside of the part";
  EXPECT_EQ(world->content.entities[0].position, glm::dvec3(20, 1, 20));
  const auto region = load({.at = glm::ivec2(20, 20), .radius = 1}, "region");
  ASSERT_TRUE(region) << joined(diagnostics_);
  EXPECT_TRUE(region->content.entities.empty()) << "they are not below what was named";
}

TEST_F(Saves, entities_behind_a_link_that_leaves_the_save_are_not_read) {
  RegionParts entities;
  entities.add(0, 0, entityChunk({cow(8, 1, 8)}));
  fs::create_directories(folder_ / "outside");
  write("outside/r.0.0.mca", entities.file());
  fs::create_directories(folder_ / "inner/region");
  write("inner/region/r.0.0.mca", plainRegion());
  fs::create_symlink(folder_ / "outside", folder_ / "inner/entities");
  const auto world = load({.at = glm::ivec2(8, 8), .radius = 0}, "inner");
  ASSERT_TRUE(world) << joined(diagnostics_);
  EXPECT_TRUE(world->content.entities.empty());
  ASSERT_EQ(diagnostics_.size(), 1u);
  EXPECT_EQ(diagnostics_[0].id, "entities-left-out");
  ASSERT_EQ(diagnostics_[0].notes.size(), 1u);
  EXPECT_NE(diagnostics_[0].notes[0].find("leads out"), std::string::npos)
      << diagnostics_[0].notes[0];
}

TEST_F(Saves, entities_left_out_are_counted_by_kind_in_one_warning) {
  const auto named = [](const std::string& id, const std::string& more) {
    return closed(nbtString("id", id) + more);
  };
  const std::string place = nbtDoubles("Pos", {8, 1, 8});
  RegionParts region, entities;
  ChunkParts parts;
  parts.sections = {stoneFloor(0)};
  for (int x = 0; x < 2; ++x) region.add(x, 0, parts.tags());
  write("region/r.0.0.mca", region.file());
  std::vector<std::string> list = {named("minecraft:bat", place),
                                   named("minecraft:squid", place),
                                   named("minecraft:bat", place),
                                   named("minecraft:marker", place),
                                   named("minecraft:cow", ""),
                                   named("", place),
                                   named("no name\x1b", place),
                                   cow(std::nan(""), 1, 1),
                                   cow(4.0e8, 1, 1),
                                   cow(200, 1, 8)};
  entities.add(0, 0, entityChunk(list));
  entities.chunks[{1, 0}] = {2, "damaged"};
  fs::create_directories(folder_ / "entities");
  write("entities/r.0.0.mca", entities.file());
  const auto world = load({.at = glm::ivec2(16, 8), .radius = 1});
  ASSERT_TRUE(world) << joined(diagnostics_);
  EXPECT_TRUE(world->content.entities.empty());
  ASSERT_EQ(diagnostics_.size(), 2u);
  EXPECT_EQ(diagnostics_[1].id, "entities-left-out");
  EXPECT_EQ(diagnostics_[1].severity, Severity::Warning);
  EXPECT_EQ(diagnostics_[1].message,
            "entities and signs are left out: 3 that no figure shows, 6 without a sane kind or "
            "place, those of 1 chunks, which cannot be read");
  EXPECT_EQ(diagnostics_[1].notes,
            (std::vector<std::string>{"2 minecraft:bat", "1 minecraft:squid",
                                      "a chunk of entities: its compressed data is damaged"}));
}

TEST_F(Saves, of_more_entities_than_a_world_may_have_the_nearest_are_kept) {
  std::vector<std::string> list;
  for (int i = 0; i < 1500; ++i) list.push_back(cow(47.9 - i * 0.02, 1, 24));
  RegionParts entities;
  entities.add(1, 1, entityChunk(list));
  entities.add(2, 1, entityChunk(list));
  write("region/r.0.0.mca", plainRegion());
  fs::create_directories(folder_ / "entities");
  write("entities/r.0.0.mca", entities.file());
  const auto world = load({.at = glm::ivec2(24, 24), .radius = 1});
  ASSERT_TRUE(world) << joined(diagnostics_);
  ASSERT_EQ(world->content.entities.size(), 1000u);
  for (const Entity& entity : world->content.entities) EXPECT_LT(entity.position.x, 29);
  ASSERT_EQ(diagnostics_.size(), 1u);
  EXPECT_EQ(diagnostics_[0].message, "entities and signs are left out: 2000 behind the 1000 nearest");
}

TEST_F(Saves, lines_of_a_sign_are_texts_on_its_board) {
  ChunkParts parts;
  SectionParts section = stoneFloor(0);
  section.palette.push_back("minecraft:oak_wall_sign[facing=east]");
  section.indices[256 + 3 * 16 + 2] = 2;  // block (2, 1, 3)
  parts.sections = {section};
  const auto sign = [](int x, int y, int z) {
    return closed(nbtString("id", "minecraft:sign") + nbtInt("x", x) + nbtInt("y", y) +
                  nbtInt("z", z) + nbtString("Text2", "HELLO"));
  };
  parts.blockEntities = {sign(2, 1, 3), sign(5, 1, 5), sign(2, 400, 3)};
  RegionParts region;
  region.add(0, 0, parts.tags());
  write("region/r.0.0.mca", region.file());
  const auto world = load({.at = glm::ivec2(8, 8), .radius = 0});
  ASSERT_TRUE(world) << joined(diagnostics_);
  ASSERT_EQ(world->content.texts.size(), 1u) << "no sign stands at the other places";
  const BlockText& text = world->content.texts[0];
  EXPECT_EQ(text.text, "HELLO");
  EXPECT_EQ(text.at, glm::ivec3(2, 1, 3));
  EXPECT_EQ(text.yaw, 270);
}

TEST_F(Saves, parts_of_worlds_that_are_no_saves_are_refused) {
  Diagnostics diagnostics;
  EXPECT_FALSE(loadWorld(ORRIS_SOURCE_DIR "/worlds/cornell", 0, diagnostics, {.radius = 2}));
  ASSERT_EQ(diagnostics.size(), 1u);
  EXPECT_EQ(diagnostics[0].message,
            "this world is drawn whole: --at and --radius choose a part of a save or a Luanti world");
}

TEST(SharedSave, real_region_is_read_whole) {
  const std::string region = ORRIS_SOURCE_DIR "/../shared/worlds/overworld-1.18.2/region/r.0.0.mca";
  if (!fs::exists(region)) GTEST_SKIP() << region << " is not here";
  Diagnostics diagnostics;
  const auto world =
      loadWorld(region, 0, diagnostics, {.at = glm::ivec2(6 * 16, 6 * 16), .radius = 6});
  ASSERT_TRUE(world) << joined(diagnostics);
  EXPECT_EQ(world->exercises, "154 chunks of a save");
  EXPECT_EQ(world->blocks.at({0, -64, 0}).name, "minecraft:bedrock");
}

}  // namespace
}  // namespace orris
