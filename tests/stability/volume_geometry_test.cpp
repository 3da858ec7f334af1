// The geometry of shadow volumes, counted along segments in double precision: no rasteriser.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include <orris/render/scene/shadow_volumes.h>
#include <orris/world/mesh/silhouette.h>

namespace orris {
namespace {

constexpr double kFar = 1e7;      ///< infinity, for points within 12 blocks
constexpr double kBeyond = 1e10;  ///< leaves even what ends there

/// Unit cubes of a cloud without the faces between two of them.
CasterSet cloud(unsigned seed, double density, bool seeThrough = false) {
  constexpr int kSize = 8;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> chance(0, 1);
  bool solid[kSize][kSize][kSize];
  for (auto& plane : solid)
    for (auto& line : plane)
      for (bool& cell : line) cell = chance(random) < density;
  const auto at = [&](glm::ivec3 p) {
    for (int i = 0; i < 3; ++i)
      if (p[i] < 0 || p[i] >= kSize) return false;
    return solid[p.x][p.y][p.z];
  };
  CasterSet set;
  for (int x = 0; x < kSize; ++x)
    for (int y = 0; y < kSize; ++y)
      for (int z = 0; z < kSize; ++z) {
        const glm::ivec3 cell(x, y, z);
        if (!at(cell)) continue;
        for (int axis = 0; axis < 3; ++axis)
          for (const int side : {-1, 1}) {
            glm::ivec3 normal(0);
            normal[axis] = side;
            if (at(cell + normal)) continue;
            glm::vec3 u(0), v(0);
            u[(axis + 1) % 3] = v[(axis + 2) % 3] = 1;
            if (side < 0) std::swap(u, v);
            const glm::vec3 corner = glm::vec3(cell) + glm::vec3(side > 0 ? normal : glm::ivec3(0));
            CasterFace face;
            face.corners = {corner, corner + u, corner + u + v, corner + v};
            face.normal = glm::vec3(normal);
            face.seeThrough = seeThrough;
            set.faces.push_back(face);
          }
      }
  return set;
}

glm::dvec3 finite(const glm::vec4& v) { return v.w != 0 ? glm::dvec3(v) : glm::dvec3(v) * kFar; }

/// +1 for each triangle that the segment meets from its front, -1 from its back.
int crossings(const VolumeMesh& mesh, const glm::dvec3& from, const glm::dvec3& to,
              std::size_t first = 0, std::size_t end = std::size_t(-1)) {
  int count = 0;
  const glm::dvec3 direction = to - from;
  for (std::size_t i = first; i + 2 < std::min(end, mesh.indices.size()); i += 3) {
    glm::dvec3 p[3];
    for (int k = 0; k < 3; ++k) p[k] = finite(mesh.vertices[mesh.indices[i + std::size_t(k)]]);
    const glm::dvec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
    const double slope = glm::dot(normal, direction);
    if (slope == 0) continue;
    const double t = glm::dot(normal, p[0] - from) / slope;
    if (t <= 0 || t >= 1) continue;
    const glm::dvec3 at = from + direction * t;
    bool in = true;
    for (int k = 0; k < 3; ++k)
      in = in && glm::dot(glm::cross(p[(k + 1) % 3] - p[k], at - p[k]), normal) >= 0;
    if (in) count += slope < 0 ? 1 : -1;
  }
  return count;
}

/// Faces that make volumes between a point and the light: what a count must be.
int depthOf(const CasterSet& set, const VolumeLight& light, const glm::dvec3& point) {
  int count = 0;
  const glm::dvec3 direction = light.w == 0 ? glm::dvec3(light) * kFar : glm::dvec3(light) - point;
  for (const CasterFace& face : set.faces) {
    if (!makesVolume(face, light)) continue;
    const double slope = glm::dot(glm::dvec3(face.normal), direction);
    const double t = glm::dot(glm::dvec3(face.normal), glm::dvec3(face.corners[0]) - point) / slope;
    if (t <= 0 || t >= 1) continue;
    const glm::dvec3 at = point + direction * t;
    bool in = true;
    for (std::size_t k = 0; k < 4; ++k)
      in = in && glm::dot(glm::cross(glm::dvec3(face.corners[(k + 1) % 4] - face.corners[k]),
                                     at - glm::dvec3(face.corners[k])),
                          glm::dvec3(face.normal)) >= 0;
    count += in;
  }
  return count;
}

struct Case {
  CasterSet set;
  VolumeLight light;
};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const CasterSet set = cloud(seed, 0.12, seed % 3 == 0);
    all.push_back({set, glm::vec4(glm::normalize(glm::vec3(0.31f, 0.8f, -0.44f)), 0)});
    all.push_back({set, glm::vec4(-3.3f, 14.2f, 5.1f, 1)});
    // Along four of six faces, and in the planes of some.
    all.push_back({set, glm::vec4(0, 1, 0, 0)});
    all.push_back({set, glm::vec4(4, 12, 4, 1)});
  }
  return all;
}

class Points {
 public:
  glm::dvec3 next() { return {at_(random_), at_(random_), at_(random_)}; }

 private:
  std::mt19937 random_{7};
  std::uniform_real_distribution<double> at_{-4.0, 12.0};
};

// Row D1 of docs/failure-modes.md.
TEST(ShadowVolumeCounts, crossings_and_the_depth_of_the_eye_add_up_to_the_depth_of_a_point) {
  Points points;
  for (const Case& c : cases()) {
    const VolumeMesh closed = buildVolumes(c.set, c.light, {.closed = true});
    for (int i = 0; i < 60; ++i) {
      const glm::dvec3 eye = points.next(), point = points.next();
      EXPECT_EQ(depthOf(c.set, c.light, eye) + crossings(closed, eye, point),
                depthOf(c.set, c.light, point));
      // Beyond the point: z-fail.
      EXPECT_EQ(-crossings(closed, point, eye + (point - eye) * kBeyond),
                depthOf(c.set, c.light, point));
    }
  }
}

// Row D2 of docs/failure-modes.md.
TEST(ShadowVolumeCounts, caps_and_infinity_are_needed_beyond_the_point) {
  Points points;
  int shadowed = 0, withoutCaps = 0, nearFar = 0;
  for (const Case& c : cases()) {
    const VolumeMesh closed = buildVolumes(c.set, c.light, {.closed = true});
    VolumeMesh finiteFar = closed;
    for (glm::vec4& v : finiteFar.vertices)
      if (v.w == 0)
        v = glm::vec4(glm::vec3(4) + glm::vec3(v) / glm::length(glm::vec3(v)) * 9.0f, 1);
    for (int i = 0; i < 60; ++i) {
      const glm::dvec3 eye = points.next(), point = points.next();
      const int depth = depthOf(c.set, c.light, point);
      if (depth == 0) continue;
      ++shadowed;
      const glm::dvec3 beyond = eye + (point - eye) * kBeyond;
      withoutCaps += -crossings(closed, point, beyond, 0, closed.sideIndices) != depth;
      nearFar += -crossings(finiteFar, point, beyond) != depth;
    }
  }
  EXPECT_GT(shadowed, 200);
  EXPECT_GT(withoutCaps, shadowed / 50);
  EXPECT_GT(nearFar, shadowed / 50);
}

// Row D6 of docs/failure-modes.md.
TEST(ShadowVolumeShapes, edges_of_four_faces_cancel) {
  // Two cubes that touch in an edge.
  CasterSet both = cloud(1, 0);
  for (const glm::vec3 at : {glm::vec3(0), glm::vec3(1, 1, 0)})
    for (const CasterFace& face : cloud(1, 1.1).faces) {
      // The sides of the first cell of a full cloud, moved; the rest of its faces are elsewhere.
      CasterFace moved = face;
      bool first = true;
      for (glm::vec3& corner : moved.corners) {
        first = first && corner.x <= 1 && corner.y <= 1 && corner.z <= 1;
        corner += at;
      }
      if (first) both.faces.push_back(moved);
    }
  ASSERT_EQ(both.faces.size(), 6u) << "three sides of each";
  const VolumeLight light(glm::normalize(glm::vec3(0.3f, 0.5f, 0.7f)), 0);
  const VolumeMesh mesh = buildVolumes(both, light, {});
  // A run is a triangle of two corners of its own and the common one at infinity.
  EXPECT_EQ(mesh.vertices.size(), 1 + mesh.indices.size() / 3 * 2);
}

// Row D7 of docs/failure-modes.md.
TEST(ShadowVolumeShapes, sides_end_where_corners_lie) {
  const CasterSet set = cloud(1, 1.1);  // one cube of 8
  const VolumeLight light(glm::normalize(glm::vec3(0.3f, 0.5f, 0.7f)), 0);
  EXPECT_EQ(buildVolumes(set, light, {}).indices.size() / 3, 6u * 8) << "the outline";
  const VolumeMesh closed = buildVolumes(set, light, {.closed = true});
  EXPECT_EQ(closed.sideIndices / 3, 6u * 8);
  EXPECT_EQ((closed.indices.size() - closed.sideIndices) / 3, 3u * 64 * 2);
}

// Row D5 of docs/failure-modes.md.
// A leaf is two faces, one to each side: whichever the light sees makes the volume.
TEST(ShadowVolumeShapes, a_lone_quad_shades_what_lies_behind_it_from_either_side) {
  CasterFace up;
  up.corners = {glm::vec3(0, 0, 0), {0, 0, 1}, {1, 0, 1}, {1, 0, 0}};
  up.normal = {0, 1, 0};
  up.seeThrough = true;
  CasterFace down = up;
  std::swap(down.corners[1], down.corners[3]);
  down.normal = -up.normal;
  CasterSet leaf;
  leaf.faces = {up, down};
  for (const float side : {1.0f, -1.0f}) {
    const VolumeLight light(0.5f, side * 4, 0.5f, 1);
    const VolumeMesh mesh = buildVolumes(leaf, light, {.closed = true});
    const auto countAt = [&](double x, double y) {
      return -crossings(mesh, {x, y * side, 0.47}, {x * 3e9, side * 1e9, 7e9});
    };
    EXPECT_EQ(countAt(0.43, 2), 0) << "before it";
    EXPECT_EQ(countAt(0.43, -2), 1) << "behind it";
    EXPECT_EQ(countAt(1.2, -4), 1) << "its shadow is twice as wide there";
    EXPECT_EQ(countAt(1.53, -4), 0) << "beside it";
    EXPECT_EQ(countAt(-0.51, -4), 0) << "beside it";
  }
}

// Row D9 of docs/failure-modes.md.
TEST(ShadowVolumeChoice, a_face_that_the_test_leaves_out_does_not_hold_the_eye) {
  Points points;
  int reached = 0, safe = 0;
  for (const Case& c : cases()) {
    for (int i = 0; i < 30; ++i) {
      const glm::dvec3 eye = points.next();
      EyePyramid pyramid{eye, eye, eye, eye, eye};
      for (std::size_t k = 1; k < 5; ++k)
        pyramid[k] += glm::dvec3(k & 1 ? 0.06 : -0.06, k & 2 ? 0.04 : -0.04, 0.05);
      for (const CasterFace& face : c.set.faces) {
        if (!makesVolume(face, c.light)) continue;
        CasterSet one;
        one.faces = {face};
        const bool reaches = reachesEye(face, c.light, pyramid);
        (reaches ? reached : safe) += 1;
        if (reaches) continue;
        for (const glm::dvec3& p : pyramid) EXPECT_EQ(depthOf(one, c.light, p), 0);
      }
    }
  }
  EXPECT_GT(reached, 100);
  EXPECT_GT(safe, 20 * reached);
}

}  // namespace
}  // namespace orris
