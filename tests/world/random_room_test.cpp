#include <orris/world/random_room.h>

#include <gtest/gtest.h>

#include <set>

#include <orris/world/blocks/block_facts.h>

namespace orris {
namespace {

/// FNV-1a of all blocks, the camera and the time.
std::uint64_t digestOf(const World& world) {
  std::uint64_t value = 0xcbf29ce484222325u;
  const auto add = [&](std::string_view text) {
    for (const char c : text) value = (value ^ std::uint8_t(c)) * 0x100000001b3u;
  };
  const glm::ivec3 from = world.blocks.origin(), end = from + world.blocks.size();
  for (int y = from.y; y < end.y; ++y)
    for (int z = from.z; z < end.z; ++z)
      for (int x = from.x; x < end.x; ++x) add(world.blocks.at({x, y, z}).toString());
  const glm::dvec3 eye = world.cameras.at(0).position;
  for (const double number : {eye.x, eye.y, eye.z, double(world.cameras[0].yaw)})
    add(std::to_string(int(number * 100)));
  add(std::to_string(world.environment.time));
  return value;
}

TEST(RandomRoom, a_seed_gives_the_same_room_everywhere) {
  EXPECT_EQ(digestOf(randomRoom(1)), 16807746832650456012u);
  EXPECT_EQ(digestOf(randomRoom(4294967295u)), 10794187131044213345u);
  std::set<std::uint64_t> rooms;
  for (std::uint32_t seed = 0; seed < 50; ++seed) rooms.insert(digestOf(randomRoom(seed)));
  EXPECT_EQ(rooms.size(), 50u);
}

TEST(RandomRoom, is_known_lit_and_has_room_for_the_eye) {
  const BlockTable table;
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    const World world = randomRoom(seed);
    const BlockWorld& blocks = world.blocks;
    const glm::ivec3 eye(glm::floor(world.cameras.at(0).position));
    EXPECT_EQ(blocks.indexAt(eye), 0u) << seed;
    EXPECT_NE(blocks.indexAt(eye - glm::ivec3(0, 2, 0)), 0u) << seed;
    bool lamp = false;
    for (const BlockState& state : blocks.palette()) {
      const BlockFacts facts = table.factsOf(state);
      EXPECT_TRUE(facts.known) << state.toString();
      lamp |= facts.emission > 0;
    }
    const bool sky = world.environment.time != 18000;
    EXPECT_TRUE(lamp || sky) << seed;
  }
}

TEST(RandomRoom, names_are_read_strictly) {
  EXPECT_EQ(randomRoomSeed("random:17"), 17u);
  for (const char* name : {"random:", "random:x", "random:-1", "random:4294967296", "random:1 ", "room:1"})
    EXPECT_FALSE(randomRoomSeed(name)) << name;
  Diagnostics diagnostics;
  EXPECT_FALSE(loadWorld("random:x", 0, diagnostics));
  ASSERT_EQ(diagnostics.size(), 1u);
  EXPECT_EQ(diagnostics[0].id, "world-unreadable");
  EXPECT_EQ(loadWorld("random:17", 0, diagnostics)->name, "random:17");
}

}  // namespace
}  // namespace orris
