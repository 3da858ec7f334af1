#include <orris/trace/shadow_mask.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include <orris/trace/seen_surfaces.h>

namespace orris {
namespace {

/// Rays begin this far before what the pixel shows, blocks.
constexpr double kLift = 1e-5;

/// Whether light reaches what is seen through points of the picture.
class LightSeen {
 public:
  LightSeen(const TraceScene& scene, const TraceCamera& camera, const LightStopped& stopped,
            const glm::dvec4& light)
      : scene_(scene), camera_(camera), viewer_(scene, camera), stopped_(stopped), light_(light) {}

  bool at(double x, double y) const {
    const std::vector<SeenSurface> seen = viewer_.at(x, y, 0);
    return seen.empty() || reaches(seen[0], 0);
  }

  /// What a frame shows at a pixel's middle when the ray meets another surface first.
  std::optional<SeenSurface> other(double x, double y, double depth) const {
    std::vector<SeenSurface> met = viewer_.at(x, y, kFrameDepth);
    if (met.empty()) met.emplace_back();
    const std::optional<SeenSurface> shown = viewer_.shownAt(x, y, depth);
    const bool same = !shown || std::any_of(met.begin(), met.end(), [&](const SeenSurface& seen) {
      return seen.quad == shown->quad;
    });
    return same ? std::nullopt : shown;
  }

  bool reached(const SeenSurface& seen) const { return seen.quad == nullptr || reaches(seen, 0); }

  /// doubtful() of one surface.
  bool doubtfulOn(const SeenSurface& seen, double x, double y) const {
    bool lit = false, dark = false;
    for (const glm::dvec2& place : kPlaces) {
      const SeenSurface moved =
          viewer_.movedTo(seen, x + place.x * kFramePixel, y + place.y * kFramePixel);
      for (const double lift : {0.0, kFrameDepth}) (reaches(moved, lift) ? lit : dark) = true;
    }
    return lit && dark;
  }

  /// Does the answer at a pixel's middle depend on more than a frame knows? Any straight line within
  /// half of kFramePixel parts one of three points from the middle.
  bool doubtful(double x, double y) const {
    bool lit = false, dark = false;
    for (const glm::dvec2& place : kPlaces) {
      const auto found =
          viewer_.at(x + place.x * kFramePixel, y + place.y * kFramePixel, kFrameDepth);
      lit |= found.empty();
      for (const SeenSurface& seen : found)
        for (const double lift : {0.0, kFrameDepth}) (reaches(seen, lift) ? lit : dark) = true;
      if (lit && dark) return true;
    }
    return false;
  }

 private:
  static constexpr glm::dvec2 kPlaces[] = {{0, 0}, {0.97, 0.26}, {-0.71, 0.71}, {-0.26, -0.97}};

  /// `lift`: of the range of depth, from the seen place to the eye.
  bool reaches(const SeenSurface& seen, double lift) const {
    const glm::dvec3 on = seen.position + glm::dvec3(scene_.origin);
    const double cosine = glm::dot(seen.normal, glm::normalize(glm::dvec3(light_) - light_.w * on));
    if ((seen.quad->thin ? std::abs(cosine) : cosine) <= kGrazing) return false;
    const glm::dvec3 toEye = camera_.position - on;
    const double distance = glm::length(toEye);
    const glm::dvec3 at = on + toEye * (viewer_.stepAt(distance, lift) / distance);
    return !stopped_(*seen.quad, at + seen.normal * kLift, light_);
  }

  const TraceScene& scene_;
  const TraceCamera& camera_;
  SeenSurfaces viewer_;
  const LightStopped& stopped_;
  glm::dvec4 light_;
};

}  // namespace

LightStopped stoppedByBlocks(const TraceScene& scene) {
  return [&scene](const TraceQuad& on, const glm::dvec3& from, const glm::dvec4& light) {
    const glm::dvec3 start = from - glm::dvec3(scene.origin);
    const glm::dvec3 place = glm::dvec3(light) - glm::dvec3(scene.origin);
    const glm::dvec3 toward = light.w == 0 ? glm::dvec3(light) : place - start;
    Ray ray;
    ray.origin = glm::vec3(start);
    ray.direction = withoutZeros(glm::vec3(glm::normalize(toward)));
    ray.cell = glm::ivec3(glm::floor(start));
    ray.ignore = std::uint32_t(&on - scene.grid.quads().data());
    RayHit hit;
    if (light.w != 0) hit.distance = float(glm::length(toward));
    scene.grid.intersect(ray, hit);
    return hit.quad != kNoQuad && !(light.w != 0 && hit.cell == glm::ivec3(glm::floor(place)));
  };
}

ImageF shadowMask(const TraceScene& scene, const TraceCamera& camera, const LightStopped& stopped,
                  const glm::dvec4& light, ShownFrame* shown) {
  const LightSeen seen(scene, camera, stopped, light);
  const auto row = [&](double y, double first) {
    std::vector<bool> lit;
    for (int x = 0; x + first <= camera.width; ++x) lit.push_back(seen.at(x + first, y));
    return lit;
  };
  ImageF mask(camera.width, camera.height, 1);
  std::vector<bool> above = row(0, 0);
  for (int y = 0; y < camera.height; ++y) {
    const std::vector<bool> middle = row(y + 0.5, 0.5), below = row(y + 1, 0);
    for (std::size_t x = 0; x < middle.size(); ++x) {
      const int corners = above[x] + above[x + 1] + below[x] + below[x + 1];
      const double px = double(x) + 0.5, py = y + 0.5;
      bool changes = corners != (middle[x] ? 4 : 0) || seen.doubtful(px, py), lit = middle[x];
      const std::optional<SeenSurface> other =
          shown != nullptr ? seen.other(px, py, shown->depth.at(int(x), y)[0]) : std::nullopt;
      if (other) {
        ++shown->others;
        lit = seen.reached(*other);
        changes = changes || (other->quad != nullptr && seen.doubtfulOn(*other, px, py));
      }
      mask.at(int(x), y)[0] = lit ? (changes ? 0.75f : 1.0f) : (changes ? 0.25f : 0.0f);
    }
    above = below;
  }
  return mask;
}

}  // namespace orris
