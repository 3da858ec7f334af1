// How a mesh is divided over buffers.
#include <orris/render/scene/terrain_parts.h>

#include <gtest/gtest.h>

namespace orris {
namespace {

std::vector<MeshSection> sectionsOf(const std::vector<std::uint32_t>& counts) {
  std::vector<MeshSection> sections;
  std::uint32_t first = 0;
  for (const std::uint32_t count : counts) {
    sections.push_back({glm::ivec3(0), RenderLayer::Solid, first, count});
    first += count;
  }
  return sections;
}

TEST(TerrainParts, sections_stay_whole_and_in_order) {
  const std::vector<MeshSection> sections = sectionsOf({40, 60, 4, 100, 200, 8, 8});
  const std::vector<TerrainPart> parts = terrainParts(sections, 104);
  const std::uint32_t wanted[][2] = {{0, 104}, {104, 100}, {204, 200}, {404, 16}};
  ASSERT_EQ(parts.size(), 4u);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    EXPECT_EQ(parts[i].first, wanted[i][0]) << i;
    EXPECT_EQ(parts[i].count, wanted[i][1]) << i;
  }
  const std::size_t places[] = {0, 0, 0, 1, 2, 3, 3};
  for (std::size_t i = 0; i < sections.size(); ++i) EXPECT_EQ(partOf(parts, sections[i]), places[i]) << i;
}

TEST(TerrainParts, an_empty_mesh_has_one_part) {
  const std::vector<TerrainPart> parts = terrainParts({}, 104);
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts[0].count, 0u);
}

}  // namespace
}  // namespace orris
