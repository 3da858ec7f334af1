#include <orris/world/mesh/section_links.h>

#include <gmock/gmock.h>

#include <functional>

#include "world_helpers.h"
#include <orris/world/mesh/block_mesh.h>

namespace orris {
namespace {

using ::testing::Each;

SectionLinks links(const std::function<bool(glm::ivec3)>& isOpen) {
  OpaqueCells opaque;
  for (int i = 0; i < 16 * 16 * 16; ++i) {
    const glm::ivec3 cell(i % 16, i / 256, i / 16 % 16);
    if (!isOpen(cell)) opaque.set(indexOfCell(cell));
  }
  return linksOf(opaque);
}

std::uint8_t bits(std::initializer_list<FaceDirection> sides) {
  std::uint8_t mask = 0;
  for (const FaceDirection side : sides) mask |= std::uint8_t(1 << int(side));
  return mask;
}

std::uint8_t from(const SectionLinks& links, FaceDirection side) { return links.from[std::size_t(side)]; }

using F = FaceDirection;

TEST(SectionLinks, air_links_all_sides_and_rock_none) {
  EXPECT_EQ(links([](glm::ivec3) { return true; }), SectionLinks());
  EXPECT_THAT(links([](glm::ivec3) { return false; }).from, Each(0));
}

TEST(SectionLinks, a_tunnel_links_its_two_ends) {
  const SectionLinks tunnel = links([](glm::ivec3 c) { return c.y == 5 && c.z == 9; });
  EXPECT_EQ(from(tunnel, F::West), bits({F::West, F::East}));
  EXPECT_EQ(from(tunnel, F::East), bits({F::West, F::East}));
  for (const F side : {F::Up, F::Down, F::North, F::South}) EXPECT_EQ(from(tunnel, side), 0) << int(side);
}

TEST(SectionLinks, tunnels_that_pass_each_other_are_apart) {
  const SectionLinks two = links([](glm::ivec3 c) { return (c.y == 5 && c.z == 9) || (c.y == 7 && c.x == 3); });
  EXPECT_EQ(from(two, F::West), bits({F::West, F::East}));
  EXPECT_EQ(from(two, F::North), bits({F::North, F::South}));
  const SectionLinks crossing = links([](glm::ivec3 c) { return c.y == 5 && (c.z == 9 || c.x == 3); });
  EXPECT_EQ(from(crossing, F::West), bits({F::West, F::East, F::North, F::South}));
}

TEST(SectionLinks, a_side_is_linked_by_all_that_begin_at_it) {
  const SectionLinks both = links([](glm::ivec3 c) { return (c.y == 2 && c.z == 9) || (c.z == 3 && ((c.y == 7 && c.x <= 4) || (c.x == 4 && c.y >= 7))); });
  EXPECT_EQ(from(both, F::West), bits({F::West, F::East, F::Up}));
  EXPECT_EQ(from(both, F::East), bits({F::West, F::East}));
}

TEST(SectionLinks, a_tunnel_that_bends_links_what_it_reaches) {
  const SectionLinks bend = links([](glm::ivec3 c) { return c.z == 9 && ((c.y == 5 && c.x <= 4) || (c.x == 4 && c.y >= 5)); });
  EXPECT_EQ(from(bend, F::West), bits({F::West, F::Up}));
}

TEST(SectionLinks, corners_do_not_join_cells) {
  const SectionLinks gap = links([](glm::ivec3 c) { return c.z == 9 && (c.x < 8 ? c.y == 5 : c.y == 6); });
  EXPECT_EQ(from(gap, F::West), bits({F::West}));
}

TEST(SectionLinks, a_cave_without_an_exit_links_nothing) {
  EXPECT_THAT(links([](glm::ivec3 c) { return c.x > 2 && c.x < 9 && c.y > 2 && c.y < 9 && c.z > 2 && c.z < 9; }).from, Each(0));
}

TEST(SectionLinks, of_a_mesh_are_those_of_its_blocks) {
  Scene scene({32, 32, 16}, {0, -16, 0});
  scene.fill({0, -16, 0}, {15, -1, 15}, "stone");
  scene.fill({16, -16, 0}, {31, -1, 15}, "glass");
  scene.fill({0, 0, 0}, {31, 0, 15}, "stone");
  const BlockMesh mesh = scene.mesh();
  EXPECT_EQ(mesh.grid.origin, glm::ivec3(0, -16, 0));
  EXPECT_EQ(mesh.grid.size, glm::ivec3(2, 2, 1));
  ASSERT_EQ(mesh.grid.links.size(), 4u);
  EXPECT_THAT(mesh.grid.links[0].from, Each(0)) << "stone";
  EXPECT_EQ(from(mesh.grid.links[1], F::Down), 0) << "a floor of stone";
  EXPECT_EQ(from(mesh.grid.links[1], F::Up), bits({F::Up, F::West, F::East, F::North, F::South}));
  EXPECT_EQ(mesh.grid.links[2], SectionLinks()) << "glass";
}

}  // namespace
}  // namespace orris
