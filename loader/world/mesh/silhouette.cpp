#include <orris/world/mesh/silhouette.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace orris {
namespace {

/// A straight piece of boundary; the volume's face lies to the left of from -> to, seen from the light.
struct Run {
  glm::vec3 from{0}, to{0};
};

/// Where boundary begins or ends along a line parallel to an axis.
struct Crossing {
  std::uint64_t line = 0;  ///< its place, keyOf() the other two coordinates in order of axis
  float at = 0;
  int change = 0;  ///< of the number of edges in the direction of the axis
  bool operator<(const Crossing& other) const {
    return line != other.line ? line < other.line : at < other.at;
  }
};

/// In the order of the numbers; both zeros are one.
std::uint32_t keyOf(float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value + 0.0f);
  return bits >> 31 != 0 ? ~bits : bits | 0x80000000u;
}

float valueOf(std::uint32_t key) {
  return std::bit_cast<float>(key >> 31 != 0 ? key & 0x7fffffffu : ~key);
}

glm::vec3 pointOf(int axis, const Crossing& crossing, float at) {
  glm::vec3 p(0);
  p[axis] = at;
  p[axis == 0 ? 1 : 0] = valueOf(std::uint32_t(crossing.line >> 32));
  p[axis == 2 ? 1 : 2] = valueOf(std::uint32_t(crossing.line));
  return p;
}

/// Adds up directed edges and keeps what does not cancel.
class EdgeSum {
 public:
  void add(const glm::vec3& from, const glm::vec3& to) {
    const glm::vec3 d = to - from;
    const int along = int(d.x != 0) + 2 * int(d.y != 0) + 4 * int(d.z != 0);
    if (along == 0) return;
    if (along != 1 && along != 2 && along != 4) return oblique_.push_back({from, to});
    const int axis = along == 4 ? 2 : along - 1;
    const std::uint64_t line = std::uint64_t(keyOf(from[axis == 0 ? 1 : 0])) << 32 |
                               keyOf(from[axis == 2 ? 1 : 2]);
    // An edge against the axis is one that begins, with -1, at its low end.
    const int change = to[axis] > from[axis] ? 1 : -1;
    crossings_[std::size_t(axis)].push_back({line, std::min(from[axis], to[axis]), change});
    crossings_[std::size_t(axis)].push_back({line, std::max(from[axis], to[axis]), -change});
  }

  /// None goes past the end of an edge: where runs, caps and visible faces meet they share corners.
  std::vector<Run> runs() {
    std::vector<Run> result = std::move(oblique_);
    for (int axis = 0; axis < 3; ++axis) addRuns(axis, result);
    return result;
  }

 private:
  void addRuns(int axis, std::vector<Run>& result) {
    std::vector<Crossing>& crossings = crossings_[std::size_t(axis)];
    std::sort(crossings.begin(), crossings.end());
    int count = 0;
    float since = 0;
    for (std::size_t i = 0; i < crossings.size();) {
      const Crossing& here = crossings[i];
      int next = count;
      std::size_t end = i;
      for (; end < crossings.size() && crossings[end].line == here.line && crossings[end].at == here.at;
           ++end)
        next += crossings[end].change;
      emit(axis, here, since, count, result);
      since = here.at;
      count = next;
      i = end;
    }
  }

  static void emit(int axis, const Crossing& end, float since, int count, std::vector<Run>& runs) {
    Run run{pointOf(axis, end, since), pointOf(axis, end, end.at)};
    if (count < 0) std::swap(run.from, run.to);
    for (int i = 0; i < std::abs(count); ++i) runs.push_back(run);
  }

  std::array<std::vector<Crossing>, 3> crossings_;  ///< by axis
  std::vector<Run> oblique_;
};

class VolumeBuilder {
 public:
  VolumeBuilder(const CasterSet& casters, const VolumeLight& light, const VolumeOptions& options)
      : casters_(casters), light_(light), options_(options) {}

  VolumeMesh build() {
    if (distant()) mesh_.vertices.push_back(glm::vec4(-glm::vec3(light_), 0));
    const std::vector<Run> runs = sides();
    addSides(runs, true);
    mesh_.alongIndices = std::uint32_t(mesh_.indices.size());
    addSides(runs, false);
    // Caps of solids are drawn in closed volumes only, those of other casters always.
    mesh_.sideIndices = std::uint32_t(mesh_.indices.size());
    forEachMaker([&](const CasterFace& face) {
      if (options_.closed || face.seeThrough) addCaps(face);
    });
    return std::move(mesh_);
  }

 private:
  bool distant() const { return light_.w == 0; }

  /// Corners counter-clockwise as the light sees them; the first stays, and so the diagonal.
  std::array<glm::vec3, 4> towardLight(const CasterFace& face) const {
    std::array<glm::vec3, 4> corners = face.corners;
    if (!face.seeThrough) std::swap(corners[1], corners[3]);
    return corners;
  }

  std::uint32_t add(const glm::vec3& corner) {
    mesh_.vertices.push_back(glm::vec4(corner, 1));
    return std::uint32_t(mesh_.vertices.size() - 1);
  }

  /// The corner pushed away from the light without end.
  std::uint32_t addInfinite(const glm::vec3& corner) {
    if (distant()) return 0;
    mesh_.vertices.push_back(glm::vec4(corner - glm::vec3(light_), 0));
    return std::uint32_t(mesh_.vertices.size() - 1);
  }

  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh_.indices.insert(mesh_.indices.end(), {a, b, c});
  }

  void addSide(const Run& run) {
    const std::uint32_t from = add(run.from), to = add(run.to), far = addInfinite(run.from);
    triangle(from, far, to);
    if (!distant()) triangle(to, far, addInfinite(run.to));
  }

  template <class Visit>
  void forEachMaker(const Visit& visit) const {
    for (const CasterFace& face : casters_.faces)
      if (makesVolume(face, light_) && (!options_.takes || options_.takes(face))) visit(face);
  }

  /// Boundaries of solids, then of other casters.
  std::vector<Run> sides() const {
    EdgeSum edges[2];
    forEachMaker([&](const CasterFace& face) {
      const std::array<glm::vec3, 4> polygon = towardLight(face);
      for (std::size_t i = 0; i < 4; ++i)
        edges[face.seeThrough].add(polygon[i], polygon[(i + 1) % 4]);
    });
    std::vector<Run> runs = edges[0].runs();
    const std::vector<Run> others = edges[1].runs();
    runs.insert(runs.end(), others.begin(), others.end());
    return runs;
  }

  /// Does the light lie in the plane of blocks that the side is in?
  bool alongPlane(const Run& run) const {
    const glm::vec3 toLight = glm::vec3(light_) - light_.w * run.from;
    for (int axis = 0; axis < 3; ++axis)
      if (run.from[axis] == run.to[axis] && std::abs(toLight[axis]) < kAlongLight) return true;
    return false;
  }

  void addSides(const std::vector<Run>& runs, bool along) {
    for (const Run& run : runs)
      if (alongPlane(run) == along) addSide(run);
  }

  // A distant light's volumes end in one point at infinity, which needs no cap.
  void addCaps(const CasterFace& face) {
    const std::array<glm::vec3, 4> p = towardLight(face);
    const std::uint32_t a = add(p[0]), b = add(p[1]), c = add(p[2]), d = add(p[3]);
    triangle(a, b, c);
    triangle(c, d, a);
    if (distant() || !options_.closed) return;
    const std::uint32_t e = addInfinite(p[0]), f = addInfinite(p[1]), g = addInfinite(p[2]),
                        h = addInfinite(p[3]);
    triangle(g, f, e);
    triangle(e, h, g);
  }

  const CasterSet& casters_;
  VolumeLight light_;
  const VolumeOptions& options_;
  VolumeMesh mesh_;
};

}  // namespace

bool makesVolume(const CasterFace& face, const VolumeLight& light) {
  const glm::vec3 toLight = glm::vec3(light) - light.w * face.corners[0];
  const float cosine = glm::dot(face.normal, toLight);
  return face.seeThrough ? cosine > kAlongLight : cosine < -kAlongLight;
}

VolumeMesh buildVolumes(const CasterSet& casters, const VolumeLight& light,
                        const VolumeOptions& options) {
  return VolumeBuilder(casters, light, options).build();
}

}  // namespace orris
