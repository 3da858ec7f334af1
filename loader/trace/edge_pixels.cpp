#include <orris/trace/edge_pixels.h>

#include <algorithm>

namespace orris {
namespace {

/// Neighbours in one plane, of one kind of block, are one surface.
bool sameSurface(const TraceQuad& a, const TraceQuad& b) {
  return a.normal == b.normal && a.state == b.state &&
         glm::dot(a.normal, a.corner) == glm::dot(b.normal, b.corner);
}

class Looker {
 public:
  Looker(const TraceScene& scene, const TraceCamera& camera) : scene_(scene), camera_(camera) {}

  bool same(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) const {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](auto first, auto second) {
      if (first == second) return true;
      if (first == kNoQuad || second == kNoQuad) return false;
      return sameSurface(scene_.grid.quad(first), scene_.grid.quad(second));
    });
  }

  /// What a ray shows: translucent quads, then the opaque one behind them or kNoQuad.
  std::vector<std::uint32_t> at(double px, double py) const {
    Ray ray;
    ray.origin = glm::vec3(camera_.position - glm::dvec3(scene_.origin));
    ray.direction = withoutZeros(direction(px, py));
    ray.cell = glm::ivec3(glm::floor(ray.origin));
    if (!scene_.grid.contains(ray.cell) && !scene_.grid.enter(ray)) return {kNoQuad};
    std::vector<std::uint32_t> seen;
    for (int layer = 0; layer < kMostLayers; ++layer) {
      const RayHit hit = scene_.grid.look(ray, nullptr);
      seen.push_back(hit.quad);
      if (hit.quad == kNoQuad) break;
      const TraceQuad& quad = scene_.grid.quad(hit.quad);
      if (!quad.blended) break;
      ray.origin = quad.corner + quad.edgeU * hit.at.x + quad.edgeV * hit.at.y;
      ray.cell = hit.cell;
      ray.enteredBy = -1;
      ray.ignore = hit.quad;
    }
    return seen;
  }

 private:
  glm::vec3 direction(double px, double py) const {
    const glm::dvec4 clip =
        glm::dmat4(camera_.projectionInverse) *
        glm::dvec4(2 * px / camera_.width - 1, 1 - 2 * py / camera_.height, 1, 1);
    return glm::vec3(
        glm::normalize(glm::dmat3(camera_.modelViewInverse) * (glm::dvec3(clip) / clip.w)));
  }

  const TraceScene& scene_;
  const TraceCamera& camera_;
};

}  // namespace

std::vector<std::uint8_t> edgePixels(const TraceScene& scene, const TraceCamera& camera) {
  const Looker looker(scene, camera);
  std::vector<std::uint8_t> edges;
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      const double px = x + 0.5, py = y + 0.5;
      const auto middle = looker.at(px, py);
      bool edge = false;
      for (const auto& [dx, dy] : {std::pair{-1, -1}, {1, -1}, {-1, 1}, {1, 1}})
        edge = edge || !looker.same(looker.at(px + dx * kEdgeReach, py + dy * kEdgeReach), middle);
      edges.push_back(edge ? 1 : 0);
    }
  }
  return edges;
}

}  // namespace orris
