// The leaps through the grid against a search through all quads.
#include <gtest/gtest.h>

#include "cube_scene.h"

namespace orris {
namespace {

test::Cubes scattered(std::uint64_t seed, glm::ivec3 size, float share) {
  test::Cubes cubes;
  SampleRandom random(seed, 0, 0);
  for (int y = 0; y < size.y; ++y)
    for (int z = 0; z < size.z; ++z)
      for (int x = 0; x < size.x; ++x)
        if (random.one() < share) cubes[{x, y, z}] = {glm::vec3(0.5f), glm::vec3(0)};
  cubes[size - 1] = cubes[glm::ivec3(0)] = {glm::vec3(0.5f), glm::vec3(0)};
  return cubes;
}

float nearestByFar(const VoxelGrid& grid, const Ray& ray) {
  float nearest = std::numeric_limits<float>::infinity();
  for (std::uint32_t i = 1; i < grid.quads().size(); ++i) {
    const TraceQuad& q = grid.quad(i);
    const float slope = glm::dot(q.normal, ray.direction);
    if (slope >= 0) continue;
    const float t = glm::dot(q.normal, q.corner - ray.origin) / slope;
    const glm::vec3 from = ray.origin + ray.direction * t - q.corner;
    const float u = glm::dot(from, q.edgeU), v = glm::dot(from, q.edgeV);
    if (t > 0 && t < nearest && u >= 0 && u <= 1 && v >= 0 && v <= 1) nearest = t;
  }
  return nearest;
}

TEST(VoxelGrid, meets_what_a_search_through_all_quads_finds) {
  for (const float share : {0.003f, 0.03f, 0.3f}) {
    const glm::ivec3 size(23, 40, 17);
    const test::Cubes cubes = scattered(4, size, share);
    const TraceScene scene = test::sceneOf(cubes);
    SampleRandom random(11, 0, 0);
    int met = 0, left = 0, wrong = 0, hidden = 0;
    const int rays = share > 0.1f ? 2500 : 8000;  // the search takes as long as there are quads
    for (int i = 0; i < rays; ++i) {
      const glm::vec2 a = random.pair(), b = random.pair(), c = random.pair();
      Ray ray;
      ray.origin = glm::vec3(size) * (glm::vec3(a, b.x) * 3.0f - 1.0f);
      const float z = 2 * c.x - 1, r = std::sqrt(1 - z * z);
      const glm::vec3 out(r * std::cos(6.2831853f * c.y), z, r * std::sin(6.2831853f * c.y));
      ray.direction = withoutZeros(out);
      ray.cell = glm::ivec3(glm::floor(ray.origin));
      const bool inside = scene.grid.contains(ray.cell);
      if (cubes.count(ray.cell) != 0) continue;
      const float expected = nearestByFar(scene.grid, ray);
      const glm::vec3 start = ray.origin;
      if (!inside && !scene.grid.enter(ray)) {
        wrong += std::isfinite(expected);
        continue;
      }
      const RayHit hit = scene.grid.intersect(ray);
      const float found = hit.distance + glm::distance(start, ray.origin);
      hidden += hit.quad == kHiddenQuad;
      (std::isfinite(expected) ? met : left) += 1;
      wrong += std::isfinite(expected) != std::isfinite(found) ||
               (std::isfinite(expected) && std::abs(expected - found) > 1e-2f);
    }
    EXPECT_GT(met, 50);
    EXPECT_GT(left, 20);
    EXPECT_EQ(hidden, 0);
    EXPECT_LE(wrong, rays / 1000) << "more than grazed edges; share " << share;
  }
}

TEST(VoxelGrid, a_texture_beside_a_ray_along_its_plane_is_read_in_the_coarsest_level) {
  const TraceScene scene = test::sceneOf({{{1, 1, 1}, {glm::vec3(0.5f), glm::vec3(0)}}});
  const auto level = [&](const glm::vec3& first, const glm::vec3& right, const glm::vec3& lower) {
    const PixelFootprint footprint{{0.5f, 3, 0.5f}, {first, right, lower}};
    for (std::uint32_t i = 1; i < scene.grid.quads().size(); ++i)
      if (scene.grid.quad(i).normal.y > 0) return scene.grid.textureLevel(i, &footprint);
    return TextureLevel{-1, 0};
  };
  const glm::vec3 down(0.3f, -1, 0.3f), along(1, 0, 0.1f), beside(1, 0, 0.2f);
  EXPECT_EQ(level(down, down, down).level, 0);
  for (const TextureLevel& found : {level(along, beside, down), level(down, along, down), level(down, down, along)}) {
    EXPECT_EQ(found.level, TraceTexture::kLevels - 1);
    EXPECT_EQ(found.next, 0);
  }
}

}  // namespace
}  // namespace orris
