#include <orris/world/mesh/silhouette.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace orris {
namespace {

/// A straight piece of boundary; the volume's face lies to the left of from -> to, seen from the light.
struct Run {
  glm::vec3 from{0}, to{0};
};

/// Where boundary begins or ends along one line parallel to an axis.
struct Crossing {
  int axis = 0;
  float across[2] = {0, 0};  ///< place of the line: the other two coordinates, in order of axis
  float at = 0;
  int change = 0;  ///< of the number of edges in the direction of the axis
  auto key() const { return std::tie(axis, across[0], across[1], at); }
  bool sameLine(const Crossing& other) const {
    return axis == other.axis && across[0] == other.across[0] && across[1] == other.across[1];
  }
};

glm::vec3 pointOf(const Crossing& line, float at) {
  glm::vec3 p(0);
  p[line.axis] = at;
  p[line.axis == 0 ? 1 : 0] = line.across[0];
  p[line.axis == 2 ? 1 : 2] = line.across[1];
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
    Crossing start;
    start.axis = axis;
    start.across[0] = from[axis == 0 ? 1 : 0];
    start.across[1] = from[axis == 2 ? 1 : 2];
    Crossing end = start;
    start.at = from[axis];
    end.at = to[axis];
    start.change = end.at > start.at ? 1 : -1;
    end.change = -start.change;
    // An edge against the axis is one that begins, with -1, at its low end.
    if (start.change < 0) std::swap(start.at, end.at);
    crossings_.push_back(start);
    crossings_.push_back(end);
  }

  /// None goes past the end of an edge: where runs, caps and visible faces meet they share corners.
  std::vector<Run> runs() {
    std::vector<Run> result = std::move(oblique_);
    std::sort(crossings_.begin(), crossings_.end(),
              [](const Crossing& a, const Crossing& b) { return a.key() < b.key(); });
    int count = 0;
    float since = 0;
    for (std::size_t i = 0; i < crossings_.size();) {
      const Crossing& here = crossings_[i];
      int next = count;
      std::size_t end = i;
      for (; end < crossings_.size() && crossings_[end].sameLine(here) &&
             crossings_[end].at == here.at;
           ++end)
        next += crossings_[end].change;
      emit(here, since, count, result);
      since = here.at;
      count = next;
      i = end;
    }
    return result;
  }

 private:
  static void emit(const Crossing& end, float since, int count, std::vector<Run>& runs) {
    Run run{pointOf(end, since), pointOf(end, end.at)};
    if (count < 0) std::swap(run.from, run.to);
    for (int i = 0; i < std::abs(count); ++i) runs.push_back(run);
  }

  std::vector<Crossing> crossings_;
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
