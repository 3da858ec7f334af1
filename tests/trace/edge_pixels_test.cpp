// Pixels on which a rasteriser and a ray may differ.
#include <orris/trace/edge_pixels.h>

#include <gtest/gtest.h>

#include <algorithm>

#include "cube_scene.h"

namespace orris::test {
namespace {

/// Down from above, a right angle wide.
TraceCamera downFrom(glm::dvec3 position, int side) {
  TraceCamera camera;
  camera.position = position;
  camera.modelViewInverse = glm::mat4({1, 0, 0, 0}, {0, 0, -1, 0}, {0, 1, 0, 0}, {0, 0, 0, 1});
  camera.width = camera.height = side;
  camera.projectionInverse = glm::mat4(1);
  camera.projectionInverse[2] = {0, 0, 0, 0};
  camera.projectionInverse[3] = {0, 0, -1, 1};
  return camera;
}

// A cube on a floor; its edge at x = 4 is in the middle of the third column of five pixels, in the three
// rows that see the cube. The lines between the blocks of the floor are no edges.
TEST(EdgePixels, are_those_that_another_surface_cuts) {
  Cubes cubes;
  for (int z = 0; z < 9; ++z)
    for (int x = 0; x < 9; ++x) cubes[{x, 0, z}] = {};
  cubes[{4, 1, 4}] = {};
  const TraceScene scene = sceneOf(cubes);
  const auto edges = edgePixels(scene, downFrom({4, 3, 4.5}, 5));
  ASSERT_EQ(edges.size(), 25u);
  for (int y = 0; y < 5; ++y)
    for (int x = 0; x < 5; ++x)
      EXPECT_EQ(edges[std::size_t(y * 5 + x)], x == 2 && y >= 1 && y <= 3) << x << ' ' << y;
  const auto beside = edgePixels(scene, downFrom({4.1, 3, 4.5}, 5));
  EXPECT_EQ(std::count(beside.begin(), beside.end(), 1), 0);
}

}  // namespace
}  // namespace orris::test
