#include <orris/world/luanti/luanti_world.h>

#include <gtest/gtest.h>

#include <orris/core/limits.h>

#include "luanti_builder.h"
#include "support/folder_test.h"
#include "world_helpers.h"

namespace orris {
namespace {

namespace fs = std::filesystem;

class LuantiWorlds : public test::FolderTest {
 protected:
  using Blocks = std::vector<std::pair<glm::ivec3, std::string>>;

  void writeMap(const Blocks& blocks, MapSchema schema = MapSchema::Columns, const std::string& sql = "") {
    write("world.mt", "gameid = minetest\nbackend = sqlite3\n");
    writeLuantiMap(folder_ / "map.sqlite", schema, blocks, sql);
  }
  std::optional<World> load(const SavePart& part = {}, const std::string& below = "") {
    diagnostics_.clear();
    return loadWorld((below.empty() ? folder_ : folder_ / below).string(), 0, diagnostics_, part);
  }
  std::string failure(const SavePart& part = {}, const std::string& below = "") {
    return load(part, below) || diagnostics_.empty() ? "no error" : diagnostics_.back().message;
  }
  /// A block of stone whose lowest node is something else.
  static std::string marked(const std::string& name, int version = 29) {
    MapBlockParts parts;
    parts.names = {"default:stone"};
    parts.set(0, 0, 0, name);
    return parts.bytes(version);
  }

  Diagnostics diagnostics_;
};

TEST_F(LuantiWorlds, every_format_and_both_schemas_give_the_same_blocks) {
  MapBlockParts parts;
  parts.set(1, 2, 3, "default:stone");
  parts.set(15, 0, 0, "default:tree", 12);
  for (const MapSchema schema : {MapSchema::Number, MapSchema::Columns}) {
    for (int version = 22; version <= 29; ++version) {
      for (const int firstId : {0, 0x800}) {
        if (firstId == 0 && version > 24) continue;
        parts.firstId = firstId;
        writeMap({{{0, 0, 0}, parts.bytes(version)}}, schema);
        const auto world = load({.radius = 0});
        ASSERT_TRUE(world) << version << joined(diagnostics_);
        EXPECT_EQ(joined(diagnostics_), "") << version;
        EXPECT_EQ(world->blocks.origin(), glm::ivec3(0, 0, -16)) << version;
        EXPECT_EQ(world->blocks.size(), glm::ivec3(16)) << version;
        EXPECT_EQ(world->blocks.at({1, 2, -4}).name, "minecraft:stone") << version;
        // With long numbers the formats before 24 keep a part of them in param2.
        if (firstId == 0) {
          EXPECT_EQ(world->blocks.at({15, 0, -1}).toString(), "minecraft:oak_log[axis=x]") << version;
        }
        EXPECT_EQ(world->blocks.at({1, 2, -13}).name, "minecraft:air") << "not mirrored";
      }
    }
  }
}

TEST_F(LuantiWorlds, fences_join_across_map_blocks) {
  MapBlockParts west, east;
  west.set(15, 0, 0, "default:fence_wood");
  east.set(0, 0, 0, "default:stone");
  writeMap({{{0, 0, 0}, west.bytes(29)}, {{1, 0, 0}, east.bytes(29)}});
  const auto world = load({.at = glm::ivec2(15, 0), .radius = 1});
  ASSERT_TRUE(world) << joined(diagnostics_);
  EXPECT_EQ(world->blocks.at({15, 0, -1}).property("east"), "true");
  EXPECT_EQ(world->blocks.at({15, 0, -1}).property("west"), "false");
}

TEST_F(LuantiWorlds, north_is_minus_z) {
  MapBlockParts south, north;
  south.set(3, 0, 2, "default:cobble");
  north.set(3, 0, 2, "default:brick");
  writeMap({{{0, 0, -1}, south.bytes(29)}, {{0, 0, 1}, north.bytes(28)}}, MapSchema::Number);
  const auto world = load({.at = glm::ivec2(0, 0), .radius = 1});
  ASSERT_TRUE(world) << joined(diagnostics_);
  EXPECT_EQ(world->blocks.at({3, 0, -1 - (-16 + 2)}).name, "minecraft:cobblestone");
  EXPECT_EQ(world->blocks.at({3, 0, -1 - (16 + 2)}).name, "minecraft:bricks");
}

TEST_F(LuantiWorlds, only_the_columns_around_the_place_are_read) {
  Blocks blocks;
  for (int z = -3; z <= 3; ++z)
    for (int x = -3; x <= 3; ++x)
      for (int y : {-2, 0, 5}) blocks.push_back({{x, y, z}, marked("default:dirt")});
  for (const MapSchema schema : {MapSchema::Number, MapSchema::Columns}) {
    writeMap(blocks, schema);
    // As Luanti shows it: in the column (1, 2).
    const auto world = load({.at = glm::ivec2(20, 40), .radius = 1});
    ASSERT_TRUE(world) << joined(diagnostics_);
    EXPECT_EQ(joined(diagnostics_), "");
    EXPECT_EQ(world->blocks.origin(), glm::ivec3(0, -32, -64));
    EXPECT_EQ(world->blocks.size(), glm::ivec3(48, 128, 48));
    EXPECT_EQ(world->exercises, "9 columns of a Luanti world");
    for (int x : {0, 16, 32}) EXPECT_EQ(world->blocks.at({x, 80, -17 - x}).name, "minecraft:dirt") << x;
    EXPECT_EQ(world->environment.renderDistance, 16);
    EXPECT_EQ(world->cameras.front().name, "surface");
    EXPECT_NEAR(world->cameras.front().position.z, -41 + 0.5, 8);
  }
}

TEST_F(LuantiWorlds, the_rim_of_the_map_is_read) {
  for (const MapSchema schema : {MapSchema::Number, MapSchema::Columns}) {
    writeMap({{{2047, 2047, 2047}, marked("default:dirt")}, {{-2048, -2048, -2048}, marked("default:sand")}}, schema);
    auto world = load({.at = glm::ivec2(32767, 32767), .radius = 2});
    ASSERT_TRUE(world) << joined(diagnostics_);
    EXPECT_EQ(world->blocks.at({32752, 32752, -32753}).name, "minecraft:dirt");
    world = load({.at = glm::ivec2(-32768, -32768), .radius = 2});
    ASSERT_TRUE(world) << joined(diagnostics_);
    EXPECT_EQ(world->blocks.at({-32768, -32768, 32767}).name, "minecraft:sand");
    EXPECT_EQ(failure({.at = glm::ivec2(1000000, -1000000), .radius = 2}),
              "nothing that can be drawn lies within 2 map blocks of node (1000000, -1000000)");
  }
}

TEST_F(LuantiWorlds, without_a_place_the_middle_of_the_map_is_taken) {
  writeMap({{{40, 0, 50}, marked("default:dirt")}, {{41, 0, 50}, marked("default:dirt")}, {{42, 0, 50}, marked("default:dirt")}});
  auto world = load({.radius = 0});
  ASSERT_TRUE(world) << joined(diagnostics_);
  EXPECT_EQ(world->blocks.origin(), glm::ivec3(41 * 16, 0, -51 * 16));
  EXPECT_EQ(failure({.at = glm::ivec2(5, 5), .radius = 0}), "nothing that can be drawn lies within 0 map blocks of node (5, 5)");
  EXPECT_EQ(diagnostics_.back().hint, "the middle of the map is --at 664,808");
  writeMap({{{40, 0, 50}, marked("default:dirt")}, {{41, 0, 50}, marked("default:dirt")}, {{0, 0, 0}, marked("default:dirt")}});
  world = load({.radius = 0});
  ASSERT_TRUE(world) << joined(diagnostics_);
  EXPECT_EQ(world->blocks.origin(), glm::ivec3(0, 0, -16));
  writeMap({});
  EXPECT_EQ(failure(), "this world has no map blocks");
}

TEST_F(LuantiWorlds, of_great_heights_those_around_the_sea_are_drawn) {
  writeMap({{{0, -902, 0}, marked("default:dirt")}, {{0, -901, 0}, marked("default:dirt")}, {{0, -900, 0}, marked("default:dirt")},
            {{0, -1, 0}, marked("default:sand")}});
  auto world = load({.radius = 0});
  ASSERT_TRUE(world) << joined(diagnostics_);
  EXPECT_EQ(world->blocks.at({0, -16, -1}).name, "minecraft:sand");
  writeMap({{{0, -900, 0}, marked("default:dirt")}, {{0, 890, 0}, marked("default:sand")}, {{0, 900, 0}, marked("default:dirt")}});
  world = load({.radius = 0});
  ASSERT_TRUE(world) << joined(diagnostics_);
  EXPECT_EQ(world->blocks.at({0, 890 * 16, -1}).name, "minecraft:sand");
}

TEST_F(LuantiWorlds, files_beside_the_map_give_name_and_time) {
  writeMap({{{0, 0, 0}, marked("default:dirt")}});
  write("world.mt", "backend = sqlite3\r\nworld_name = Sol III\n");
  write("env_meta.txt", "game_time = 100\ntime_of_day = 19118\nday_count = 4\nEnvArgsEnd\n");
  for (const char* below : {"", "map.sqlite", "world.mt"}) {
    const auto world = load({.radius = 0}, below);
    ASSERT_TRUE(world) << below << joined(diagnostics_);
    EXPECT_EQ(world->name, "Sol III");
    EXPECT_EQ(world->environment.time, 13118);
    EXPECT_EQ(world->environment.day, 4);
  }
}

TEST_F(LuantiWorlds, nodes_without_a_block_are_cubes_and_counted_in_one_warning) {
  MapBlockParts parts;
  for (int i = 0; i < 3; ++i) parts.set(i, 0, 0, "homedecor:table");
  parts.set(5, 0, 0, "lamp:\x1b[31m");
  parts.set(6, 0, 0, "ignore");
  writeMap({{{0, 0, 0}, parts.bytes(29)}});
  const auto world = load({.radius = 0});
  ASSERT_TRUE(world);
  EXPECT_EQ(world->blocks.at({1, 0, -1}).name, "minecraft:light_gray_concrete");
  EXPECT_EQ(world->blocks.at({6, 0, -1}).name, "minecraft:air");
  ASSERT_EQ(diagnostics_.size(), 1u) << joined(diagnostics_);
  EXPECT_EQ(diagnostics_[0].id, "nodes-unknown");
  EXPECT_EQ(diagnostics_[0].message, "4 nodes of 2 kinds are drawn as plain cubes, most often homedecor:table");
  ASSERT_EQ(diagnostics_[0].notes.size(), 2u);
  EXPECT_EQ(diagnostics_[0].notes[0], "3 homedecor:table");
  EXPECT_EQ(diagnostics_[0].notes[1].find('\x1b'), std::string::npos);
}

TEST_F(LuantiWorlds, doors_have_an_upper_half_across_map_blocks_too) {
  MapBlockParts lower, upper;
  lower.set(4, 3, 0, "doors:door_wood_a", 1);
  lower.set(4, 4, 0, "doors:hidden");
  lower.set(7, 15, 0, "doors:door_steel_b", 2);
  lower.set(9, 9, 0, "doors:hidden");
  upper.set(7, 0, 0, "doors:hidden");
  writeMap({{{0, 0, 0}, lower.bytes(29)}, {{0, 1, 0}, upper.bytes(29)}});
  const auto world = load({.radius = 0});
  ASSERT_TRUE(world) << joined(diagnostics_);
  EXPECT_EQ(world->blocks.at({4, 4, -1}).toString(), "minecraft:oak_door[facing=east,half=upper]");
  EXPECT_EQ(world->blocks.at({7, 16, -1}).toString(), "minecraft:iron_door[facing=south,half=upper]");
  EXPECT_EQ(world->blocks.at({9, 9, -1}).name, "minecraft:air");
}

TEST_F(LuantiWorlds, damaged_map_blocks_are_counted_and_named_with_their_place) {
  const std::string whole = marked("default:dirt");
  writeMap({{{0, 0, 0}, whole}, {{0, 1, 0}, whole.substr(0, 40)}, {{0, 2, 0}, ""}, {{0, 3, 0}, "\x15old"}, {{1, 0, 0}, "\x1d zzzz"}});
  const auto world = load({.at = glm::ivec2(0, 0), .radius = 1});
  ASSERT_TRUE(world) << joined(diagnostics_);
  ASSERT_EQ(diagnostics_.size(), 1u);
  EXPECT_EQ(diagnostics_[0].id, "chunks-left-out");
  EXPECT_EQ(diagnostics_[0].message,
            "left out: 7 of 9 columns that the map does not hold, 4 of 5 map blocks that cannot be read");
  EXPECT_EQ(diagnostics_[0].notes,
            (std::vector<std::string>{"map block (0, 2, 0): it is empty", "map block (0, 1, 0): its compressed data is cut off",
                                      "map block (0, 3, 0): its format is 21: expected 22 to 29",
                                      "map block (1, 0, 0): its compressed data is damaged"}));
}

TEST_F(LuantiWorlds, what_is_no_map_is_refused) {
  write("world.mt", "backend = leveldb\n");
  EXPECT_EQ(failure(), "the map of this world is kept by leveldb: expected sqlite3");
  write("world.mt", "blocksize = 32\n");
  EXPECT_EQ(failure(), "map blocks of this world have 32 nodes along an edge: expected 16");
  write("world.mt", "");
  EXPECT_EQ(failure(), "this world has no map.sqlite");
  write("map.sqlite", std::string(5000, 'x'));
  EXPECT_EQ(failure(), "its database: file is not a database");
  write("map.sqlite", "");
  EXPECT_EQ(failure(), "its database has no table \"blocks\"");
  EXPECT_EQ(failure({}, "map.sqlite"), "its database has no table \"blocks\"");
}

TEST_F(LuantiWorlds, link_that_leaves_the_folder_is_not_followed) {
  writeMap({{{0, 0, 0}, marked("default:dirt")}});
  fs::create_directories(folder_ / "inner");
  fs::create_symlink(folder_ / "map.sqlite", folder_ / "inner/map.sqlite");
  EXPECT_NE(failure({}, "inner").find("leads out"), std::string::npos) << failure({}, "inner");
}

// Databases that a stranger made to take time or memory.
TEST_F(LuantiWorlds, a_view_or_a_virtual_table_is_no_map) {
  for (const char* sql :
       {"DROP TABLE blocks; CREATE VIEW blocks AS WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i+1 FROM n) "
        "SELECT i AS x, i AS y, i AS z, zeroblob(1000000) AS data FROM n",
        "DROP TABLE blocks; CREATE VIRTUAL TABLE blocks USING fts4(x, y, z, data)"}) {
    writeMap({}, MapSchema::Columns, sql);
    EXPECT_EQ(failure(), "its database has no table \"blocks\"");
  }
}

TEST_F(LuantiWorlds, columns_that_call_functions_are_not_computed) {
  writeMap({}, MapSchema::Columns,
           "DROP TABLE blocks; CREATE TABLE blocks (x INT, y INT, z INT, data AS (zeroblob(1000000000)));"
           "INSERT INTO blocks VALUES (0, 0, 0)");
  EXPECT_EQ(failure(), "the table \"blocks\" of its database has computed columns");
}

TEST_F(LuantiWorlds, blobs_beyond_the_limit_are_not_read) {
  writeMap({{{0, 0, 0}, marked("default:dirt")}, {{0, 1, 0}, std::string(limits::kMapBlockBytes + 1, '\x1d')}});
  EXPECT_TRUE(load({.radius = 0}));
  ASSERT_EQ(diagnostics_.size(), 1u) << joined(diagnostics_);
  EXPECT_EQ(diagnostics_[0].notes, std::vector<std::string>{"map block (0, 1, 0): it has more than 4194304 bytes"});
}

TEST_F(LuantiWorlds, a_table_without_its_key_is_given_up) {
  // Each question reads the whole table: 4225 columns of 200000 rows.
  writeMap({}, MapSchema::Columns,
           "DROP TABLE blocks; CREATE TABLE blocks (x INT, y INT, z INT, data BLOB);"
           "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i+1 FROM n LIMIT 200000) "
           "INSERT INTO blocks SELECT i, 0, 9, x'00' FROM n");
  load({.at = glm::ivec2(0, 0), .radius = 32});
  ASSERT_FALSE(diagnostics_.empty());
  EXPECT_NE(joined(diagnostics_).find("its database takes too much time or memory to read"), std::string::npos)
      << joined(diagnostics_);
}

TEST_F(LuantiWorlds, places_that_are_no_numbers_are_left_out) {
  for (const MapSchema schema : {MapSchema::Number, MapSchema::Columns}) {
    const bool number = schema == MapSchema::Number;
    writeMap({{{0, 0, 0}, marked("default:dirt")}}, schema,
             number ? "INSERT INTO blocks VALUES ('text', x'1d'), (1e300, x'1d'), (x'00', x'1d'), (0.5, x'1d')"
                    : "INSERT INTO blocks VALUES (0, 'text', 0, x'1d'), (0, 1e300, 0, x'1d'), (0, 99999, 0, x'1d')");
    const auto world = load({.at = glm::ivec2(0, 0), .radius = 0});
    ASSERT_TRUE(world) << joined(diagnostics_);
    EXPECT_EQ(world->blocks.at({0, 0, -1}).name, "minecraft:dirt");
  }
}

TEST_F(LuantiWorlds, damaged_databases_never_crash) {
  Blocks blocks;
  for (int i = 0; i < 60; ++i) blocks.push_back({{i % 5, i % 3, i / 15}, marked("default:dirt", 28)});
  writeMap(blocks, MapSchema::Number);
  std::ifstream file(folder_ / "map.sqlite", std::ios::binary);
  const std::string whole((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  unsigned random = 1;
  for (int round = 0; round < 200; ++round) {
    std::string damaged = whole;
    for (int i = 0; i < 20; ++i) {
      random = random * 1664525u + 1013904223u;
      damaged[100 + (random >> 8) % (damaged.size() - 100)] = char(random >> 3);
    }
    if (round % 4 == 0) damaged.resize(damaged.size() * unsigned(round + 1) / 201);
    write("map.sqlite", damaged);
    const bool loaded = load({.at = glm::ivec2(0, 0), .radius = 4}).has_value();
    EXPECT_TRUE(loaded || !diagnostics_.empty());
  }
}

}  // namespace
}  // namespace orris
