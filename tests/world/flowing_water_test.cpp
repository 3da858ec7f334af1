// The flowing texture of water, on its surface and its sides.
#include <gtest/gtest.h>

#include "resource_helpers.h"

namespace orris {
namespace {

using Corners = std::array<BlockVertex, 4>;

/// Water with textures of its own, still and flowing.
TestPack waterPack() {
  TestPack pack = stonePack();
  pack.texture("block/water_still", pngOf(16, kGreen));
  pack.texture("block/water_flow", pngOf(32, kBlue));
  return pack;
}

std::vector<Corners> waterFaces(const ReadMesh& mesh) {
  std::vector<Corners> faces;
  for (std::size_t i = 0; i < mesh.vertexCount(); i += 4)
    if (mesh.faces[i / 4].fluid == 1) faces.push_back(mesh.quad(i));
  return faces;
}

/// Two blocks of water, of which the eastern one is lower.
ReadMesh flowingWater(TestPack& pack) {
  Scene scene({4, 3, 3});
  scene.fill({0, 0, 0}, {3, 0, 2}, "stone");
  scene.fill({0, 1, 0}, {3, 1, 2}, "stone");
  scene.set({1, 1, 1}, "water");
  scene.set({2, 1, 1}, "water[level=4]");
  return pack.mesh(scene);
}

TEST(flowing_water, water_flows_down_its_steps_with_a_texture_of_its_own) {
  TestPack pack = stonePack();
  pack.texture("block/water_still", pngOf(16, kGreen));
  const auto surfaces = [&] {
    std::vector<Corners> tops;
    const ReadMesh mesh = flowingWater(pack);
    for (const auto& quad : waterFaces(mesh))
      if (quad[0].normal.y > 0) tops.push_back(quad);
    return tops;
  };
  const auto still = surfaces();
  ASSERT_EQ(still.size(), 2u);
  EXPECT_EQ(still[0][0].tangent, glm::vec4(1, 0, 0, 1));
  pack.texture("block/water_flow", pngOf(32, kBlue));
  const auto flowing = surfaces();
  ASSERT_EQ(flowing.size(), 2u);
  const AtlasTile tile = pack.atlas.tile("water_flow");
  for (const auto& quad : flowing) {
    // v grows to the east, u to the north, over half of the texture.
    EXPECT_LT(glm::distance(glm::vec3(quad[0].tangent), glm::vec3(0, 0, -1)), 1e-5f);
    const auto& east = quad[2];
    const auto& west = quad[1];
    EXPECT_EQ(east.position.x - west.position.x, 1);
    EXPECT_NEAR((east.uv - west.uv).y / (tile.max - tile.min).y, 0.5, 1e-5);
    EXPECT_NEAR((east.uv - west.uv).x, 0, 1e-5);
  }
}

TEST(flowing_water, water_flows_to_the_edge_that_it_falls_over) {
  TestPack pack = waterPack();
  Scene scene({4, 3, 3});
  scene.fill({0, 0, 0}, {3, 2, 2}, "stone");
  scene.set({1, 2, 1}, "water");
  scene.set({2, 2, 1}, "air");
  scene.set({2, 1, 1}, "water");
  const ReadMesh mesh = pack.mesh(scene);
  int tops = 0;
  for (const auto& quad : waterFaces(mesh)) {
    if (quad[0].normal.y <= 0 || quad[0].position.y < 2) continue;
    ++tops;
    EXPECT_LT(glm::distance(glm::vec3(quad[0].tangent), glm::vec3(0, 0, -1)), 1e-5f)
        << "to the east";
  }
  EXPECT_EQ(tops, 1);
}

TEST(flowing_water, sides_of_water_wear_a_quarter_of_the_flowing_texture) {
  TestPack pack = waterPack();
  Scene scene({3, 2, 3});
  scene.fill({0, 0, 0}, {2, 0, 2}, "stone");
  scene.set({1, 1, 1}, "water");
  const ReadMesh mesh = pack.mesh(scene);
  const AtlasTile tile = pack.atlas.tile("water_flow");
  const glm::vec2 end = (tile.min + tile.max) * 0.5f;
  int sides = 0;
  for (const auto& quad : waterFaces(mesh)) {
    if (quad[0].normal.y != 0) continue;
    ++sides;
    for (const BlockVertex& vertex : quad) {
      EXPECT_TRUE(glm::all(glm::greaterThanEqual(vertex.uv, tile.min)));
      EXPECT_TRUE(glm::all(glm::lessThanEqual(vertex.uv, end + 1e-6f)));
    }
    EXPECT_NEAR(quad[2].uv.x - quad[1].uv.x, end.x - tile.min.x, 1e-6f);
  }
  EXPECT_EQ(sides, 4);
}

}  // namespace
}  // namespace orris
