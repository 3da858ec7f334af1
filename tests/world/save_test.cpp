#include <orris/world/saves/save.h>

#include <gtest/gtest.h>

#include "region_builder.h"
#include "support/folder_test.h"
#include "world_helpers.h"

namespace orris {
namespace {

namespace fs = std::filesystem;

std::string nbtDoubles(const std::string& name, const std::vector<double>& values) {
  std::vector<std::string> items;
  for (const double value : values)
    items.push_back(bigEndian(std::bit_cast<std::uint64_t>(value), 8));
  return nbtList(name, 6, items);
}

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

TEST_F(Saves, parts_of_worlds_that_are_no_saves_are_refused) {
  Diagnostics diagnostics;
  EXPECT_FALSE(loadWorld(ORRIS_SOURCE_DIR "/worlds/cornell", 0, diagnostics, {.radius = 2}));
  ASSERT_EQ(diagnostics.size(), 1u);
  EXPECT_EQ(diagnostics[0].message,
            "this world is drawn whole: --at and --radius choose a part of a save");
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
