// Masks of shadows beside a search through all quads.
#include <orris/trace/shadow_mask.h>

#include <gtest/gtest.h>

#include <cmath>

#include "block_scene.h"

namespace orris {
namespace {

using test::BlockScene;

constexpr int kMaskSide = 48;
const glm::dvec3 kMaskEye(4.5, 4, 4.5);
const glm::dvec4 kMaskSun(glm::normalize(glm::dvec3(0.31, 1, 0.17)), 0);
const glm::dvec4 kMaskLamp(5.5, 7.5, 4.5, 1), kPlaceInAir(3.5, 7.5, 4.5, 1);

/// A floor, a roof of one block four blocks above it, and a torch below stones above that.
BlockScene below(const std::string& roof) {
  return test::blockScene(R"({"size": [9, 9, 9], "blocks": [{"box": "white_concrete", "min": [0,0,0], "max": [8,0,8]},
    {"box": ")" + roof + R"(", "min": [0,5,0], "max": [8,5,8]}, {"block": "torch", "at": [5,7,4]},
    {"box": "stone", "min": [3,8,4], "max": [5,8,4]}],
    "cameras": [{"name": "a", "position": [4, 4, 4], "yaw": 0, "pitch": 90}]})",
                          {}, {});
}

/// From below the roof straight down: a pixel is an eighth of a block of the floor.
TraceCamera down() {
  TraceCamera camera;
  camera.width = camera.height = kMaskSide;
  camera.position = kMaskEye;
  camera.modelViewInverse = glm::mat4(1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1);
  camera.projectionInverse = glm::mat4(0);
  camera.projectionInverse[0][0] = camera.projectionInverse[1][1] = 1;
  camera.projectionInverse[3] = glm::vec4(0, 0, -1, 1);
  return camera;
}

glm::dvec3 floorAt(int x, int y) {
  return {kMaskEye.x + 6 * ((x + 0.5) / kMaskSide - 0.5), 1, kMaskEye.z + 6 * ((y + 0.5) / kMaskSide - 0.5)};
}

/// Is there texture, which is no glass, where a line meets the quad?
bool stops(const VoxelGrid& grid, const TraceQuad& quad, const glm::dvec3& from, const glm::dvec3& to) {
  const glm::dvec3 u(quad.edgeU), v(quad.edgeV), normal = glm::cross(u, v);
  const double slope = glm::dot(to, normal);
  if (quad.translucent || std::abs(slope) < 1e-9) return false;
  const double t = glm::dot(glm::dvec3(quad.corner) - from, normal) / slope;
  if (t < 1e-4 || t >= 1) return false;
  const glm::dvec3 on = from + to * t - glm::dvec3(quad.corner);
  const glm::vec2 at(glm::dot(on, u) / glm::dot(u, u), glm::dot(on, v) / glm::dot(v, v));
  if (at.x < 0 || at.x > 1 || at.y < 0 || at.y > 1) return false;
  return !quad.alphaTested || grid.texel(quad, at).w >= kAlphaTest;
}

/// By all quads in turn, but those of the light's own block.
bool isLit(const TraceScene& scene, const glm::dvec3& from, const glm::dvec4& light) {
  const glm::dvec3 to = light.w == 0 ? 100.0 * glm::dvec3(light) : glm::dvec3(light) - from;
  const glm::dvec3 start = from - glm::dvec3(scene.origin);
  for (const TraceQuad& quad : scene.grid.quads()) {
    const glm::dvec3 middle = glm::dvec3(quad.corner) + 0.5 * glm::dvec3(quad.edgeU + quad.edgeV) + glm::dvec3(scene.origin);
    const glm::dvec3 off = glm::abs(middle - glm::dvec3(light));
    const bool own = light.w != 0 && std::max(off.x, std::max(off.y, off.z)) < 0.51;
    if (!own && stops(scene.grid, quad, start, to)) return false;
  }
  return true;
}

struct Roof {
  const char* block;
  double least, most;  ///< share of the floor that the light reaches
  friend std::ostream& operator<<(std::ostream& out, const Roof& roof) { return out << roof.block; }
};

class ShadowMask : public testing::TestWithParam<Roof> {};

TEST_P(ShadowMask, has_the_holes_of_what_is_above_and_lets_light_through_glass) {
  const BlockScene scene = below(GetParam().block);
  for (const glm::dvec4& light : {kMaskSun, kMaskLamp, kPlaceInAir}) {
    const ImageF mask = shadowMask(scene.scene, down(), stoppedByBlocks(scene.scene), light);
    int lit = 0, decided = 0, wrong = 0;
    for (int y = 0; y < kMaskSide; ++y)
      for (int x = 0; x < kMaskSide; ++x) {
        const float value = mask.at(x, y)[0];
        lit += value > 0.5f;
        if (value != 0 && value != 1) continue;
        ++decided;
        wrong += (value == 1) != isLit(scene.scene, floorAt(x, y), light);
      }
    EXPECT_EQ(wrong, 0) << "light " << light.w;
    EXPECT_GT(decided, kMaskSide * kMaskSide / 4);
    const double share = lit / double(kMaskSide * kMaskSide);
    EXPECT_GE(share, GetParam().least) << "light " << light.w;
    EXPECT_LE(share, GetParam().most) << "light " << light.w;
  }
}

INSTANTIATE_TEST_SUITE_P(Roofs, ShadowMask,
                         testing::Values(Roof{"air", 0.9, 1}, Roof{"stone", 0, 0}, Roof{"red_stained_glass", 0.9, 1},
                                         Roof{"water", 0.9, 1}, Roof{"glass", 0.4, 0.8}, Roof{"oak_leaves", 0, 0.4},
                                         Roof{"oak_fence[east=true,west=true]", 0.4, 0.95},
                                         Roof{"oak_slab[type=top]", 0, 0}));

// A fern from its dark side, before the shaded side of a wall. Its own planes do not stop the light that they let through.
TEST(ShadowMaskOfPlants, light_from_behind_comes_to_a_fern) {
  const BlockScene scene = test::blockScene(
      R"({"size": [9, 9, 9], "blocks": [{"box": "stone", "min": [0,0,0], "max": [8,0,8]},
        {"box": "stone", "min": [0,1,0], "max": [8,3,0]}, {"block": "fern", "at": [4,1,4]}],
        "cameras": [{"name": "a", "position": [4, 1, 7], "yaw": 180, "pitch": 0}]})",
      {{"minecraft:fern", 10}}, {});
  TraceCamera camera = down();
  camera.position = {4.5, 1.5, 7.5};
  camera.modelViewInverse = glm::mat4(1);  // to the north
  camera.projectionInverse[0][0] = camera.projectionInverse[1][1] = 0.3f;
  const glm::dvec4 behind(glm::normalize(glm::dvec3(0.1, 1.2, -1)), 0);
  const ImageF mask = shadowMask(scene.scene, camera, stoppedByBlocks(scene.scene), behind);
  int lit = 0;  // above the horizon, where there are the fern and the wall
  for (int y = 0; y < kMaskSide / 2; ++y)
    for (int x = 0; x < kMaskSide; ++x) lit += mask.at(x, y)[0] > 0.5f;
  EXPECT_GT(lit, 10);
}

}  // namespace
}  // namespace orris
