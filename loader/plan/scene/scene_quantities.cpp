#include <orris/plan/scene/scene_quantities.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <orris/plan/frame/celestial.h>
#include <orris/world/mesh/mesh_lamps.h>
#include <orris/world/mesh/silhouette.h>

namespace orris {
namespace {

// Rays into the scene: enough to tell a tenth of the picture from nothing.
constexpr int kColumns = 32, kRows = 18;
constexpr double kLongestRay = 256;  // blocks
constexpr double kNearCaster = 8;    // blocks, of casters_near

struct Seen {
  double distance = 0;
  glm::dvec3 place{0};
  glm::ivec3 before{0};  ///< the cell from which it is seen
};

class Measuring {
 public:
  Measuring(const SceneData& scene, const FrameState& view, const PackDirectives& directives)
      : scene_(scene), view_(view), directives_(directives) {}

  double pixels() { return double(view_.width) * view_.height; }

  double faces() {
    return countFaces([](const MeshSection&, const MeshFace&) { return true; });
  }

  double glass() {
    return countFaces([](const MeshSection& section, const MeshFace& face) {
      return section.layer == RenderLayer::Translucent && !face.fluid;
    });
  }

  double extent() {
    glm::dvec3 low = view_.cameraPosition, high = low;
    for (const MeshSection& section : scene_.mesh.sections)
      for (std::uint32_t i = section.first; i < section.first + section.count; i += 4) {
        const MeshFace& face = scene_.mesh.faces[i / 4];
        for (const glm::vec3& corner : scene_.mesh.shapes[face.shape].corners) {
          const glm::dvec3 place =
              glm::dvec3(section.origin) + glm::dvec3(glm::vec3(face.cell) + corner);
          low = glm::min(low, place);
          high = glm::max(high, place);
        }
      }
    const glm::dvec3 sides = high - low;
    return std::max(sides.x, std::max(sides.y, sides.z));
  }

  double casters() { return double(casterSet().faces.size()); }

  double castersNear() {
    const glm::dvec3 eye = view_.cameraPosition - glm::dvec3(casterSet().origin);
    const auto& faces = casterSet().faces;
    return double(std::count_if(faces.begin(), faces.end(), [&](const CasterFace& face) {
      return glm::distance(eye, glm::dvec3(face.corners[0])) < kNearCaster;
    }));
  }

  double volumes() {
    const glm::vec4 light(shadowLightDirection(view_.skyAngle, directives_.sunPathRotation), 0);
    return double(buildVolumes(casterSet(), light, {}).indices.size()) / 3;
  }

  double lampCount() { return double(lamps().size()); }

  double lampsReaching() {
    double count = 0;
    for (const Seen& point : seen())
      for (const MeshLamp& lamp : lamps())
        count += glm::distance(point.place, lamp.place()) < lamp.level;
    return seen().empty() ? 0 : count / double(seen().size());
  }

  double sun() {
    if (!scene_.contents().sky || seen().empty()) return 0;
    const auto open = std::count_if(seen().begin(), seen().end(), [&](const Seen& point) {
      return scene_.light->sky(point.before) > 0;
    });
    return double(open) / double(seen().size());
  }

  double texelPixels() {
    if (seen().empty()) return 0;
    std::vector<double> distances;
    for (const Seen& point : seen()) distances.push_back(point.distance);
    const auto tenth = distances.begin() + std::ptrdiff_t(distances.size() / 10);
    std::nth_element(distances.begin(), tenth, distances.end());
    const double texel = 2 * directives_.shadowDistance / directives_.shadowMapResolution;
    return texel / *tenth * view_.gbufferProjection[1][1] * view_.height / 2;
  }

 private:
  /// Of those within the shadow distance of the eye.
  template <typename Counts>
  double countFaces(Counts counts) const {
    double count = 0;
    for (const MeshSection& section : scene_.mesh.sections)
      for (std::uint32_t i = section.first; i < section.first + section.count; i += 4) {
        const MeshFace& face = scene_.mesh.faces[i / 4];
        if (!counts(section, face)) continue;
        const glm::vec3 corner = glm::vec3(face.cell) + scene_.mesh.shapes[face.shape].corners[0];
        const glm::dvec3 place = glm::dvec3(section.origin) + glm::dvec3(corner);
        count += glm::distance(place, view_.cameraPosition) <= directives_.shadowDistance;
      }
    return count;
  }

  const CasterSet& casterSet() {
    if (!casters_) casters_ = castersOf(scene_.mesh, scene_.atlas);
    return *casters_;
  }

  const std::vector<MeshLamp>& lamps() {
    if (lamps_) return *lamps_;
    lamps_ = lampsOf(scene_.mesh);
    std::erase_if(*lamps_, [&](const MeshLamp& lamp) {
      return glm::distance(lamp.place(), view_.cameraPosition) > directives_.shadowDistance;
    });
    return *lamps_;
  }

  const std::vector<Seen>& seen() {
    if (seen_) return *seen_;
    seen_.emplace();
    for (int row = 0; row < kRows; ++row)
      for (int column = 0; column < kColumns; ++column) {
        const glm::vec4 target =
            view_.gbufferProjectionInverse * glm::vec4((float(column) + 0.5f) / kColumns * 2 - 1,
                                                       (float(row) + 0.5f) / kRows * 2 - 1, 1, 1);
        const glm::vec3 direction =
            glm::mat3(view_.gbufferModelViewInverse) * (glm::vec3(target) / target.w);
        if (const auto found = firstBlock(glm::normalize(glm::dvec3(direction))))
          seen_->push_back(*found);
      }
    return *seen_;
  }

  bool stops(const glm::ivec3& cell) const {
    const BlockFacts& facts = scene_.facts[scene_.world.blocks.indexAt(cell)];
    return !facts.air && !facts.fluid;
  }

  /// Cell by cell (Amanatides and Woo 1987). The cell of the eye does not stop the ray.
  std::optional<Seen> firstBlock(const glm::dvec3& direction) const {
    const glm::dvec3& eye = view_.cameraPosition;
    glm::ivec3 cell(glm::floor(eye)), step;
    glm::dvec3 next, each;
    for (int i = 0; i < 3; ++i) {
      step[i] = direction[i] < 0 ? -1 : 1;
      each[i] =
          direction[i] != 0 ? std::abs(1 / direction[i]) : std::numeric_limits<double>::infinity();
      const double rest = direction[i] < 0 ? eye[i] - cell[i] : cell[i] + 1 - eye[i];
      next[i] = direction[i] != 0 ? rest * each[i] : each[i];
    }
    for (;;) {
      const int axis = next.x < next.y ? (next.x < next.z ? 0 : 2) : (next.y < next.z ? 1 : 2);
      const double distance = next[axis];
      if (distance > kLongestRay) return std::nullopt;
      const glm::ivec3 before = cell;
      cell[axis] += step[axis];
      next[axis] += each[axis];
      if (stops(cell)) return Seen{distance, eye + direction * distance, before};
    }
  }

  const SceneData& scene_;
  const FrameState& view_;
  const PackDirectives& directives_;
  std::optional<CasterSet> casters_;
  std::optional<std::vector<MeshLamp>> lamps_;
  std::optional<std::vector<Seen>> seen_;
};

struct Entry {
  std::string_view name;
  double (Measuring::*measure)();
};
constexpr Entry kEntries[] = {
    {"pixels", &Measuring::pixels},   {"faces", &Measuring::faces},
    {"extent", &Measuring::extent},   {"casters", &Measuring::casters},
    {"volumes", &Measuring::volumes}, {"casters_near", &Measuring::castersNear},
    {"lamps", &Measuring::lampCount}, {"lamps_reaching", &Measuring::lampsReaching},
    {"glass", &Measuring::glass},     {"sun", &Measuring::sun},
    {"texel_pixels", &Measuring::texelPixels}};

}  // namespace

Quantities measureScene(const SceneData& scene, const FrameState& view,
                        const PackDirectives& directives, const std::set<std::string>& wanted) {
  Measuring measuring(scene, view, directives);
  Quantities quantities;
  for (const Entry& entry : kEntries)
    if (wanted.contains(std::string(entry.name)))
      quantities.emplace(entry.name, (measuring.*entry.measure)());
  return quantities;
}

}  // namespace orris
