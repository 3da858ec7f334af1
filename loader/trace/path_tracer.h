// Light by unbiased path tracing: what a pixel shows of a scene, one sample at a time.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include <orris/trace/light/random.h>
#include <orris/trace/trace_scene.h>

namespace orris {

/// The matrices of the frame, and the picture's size in pixels.
struct TraceCamera {
  glm::dvec3 position{0};  ///< world blocks
  glm::mat4 modelViewInverse{1}, projectionInverse{1};
  int width = 0, height = 0;
};

struct TraceSettings {
  std::uint64_t seed = 0;
  /// Rays in a row from a surface that the camera sees; 0 leaves emission and direct sun, -1 follows
  /// light without end.
  int bounces = -1;
};

/// Rays by purpose, for one thread.
struct RayCounts {
  std::uint64_t camera = 0, path = 0, lamp = 0, sun = 0;
  std::vector<Ray>* record = nullptr;  ///< takes every ray but the camera's, for measurements
  std::uint64_t total() const { return camera + path + lamp + sun; }
  RayCounts& operator+=(const RayCounts& other);
};

/// A point that reflects light.
struct TraceSurface {
  glm::vec3 position{0};  ///< grid space
  glm::vec3 normal{0};    ///< toward where it is seen from
  glm::ivec3 cell{0};     ///< where rays from it begin
  std::uint32_t quad = kNoQuad;
  glm::vec3 albedo{0};
  bool thin = false;  ///< lets through what it reflects
  int gloss = 0;      ///< as TraceQuad; of what the camera sees
};

/// A camera's ray passes through this many translucent surfaces and holes at most.
inline constexpr int kMostLayers = 64;

/// What a pixel sees, found once: `constant` needs no sampling (sky, emission, direct sun), each layer
/// adds weight times what its surface reflects of the light it receives: as a diffuse one, or as a mirror.
struct PixelView {
  struct Layer {
    TraceSurface surface;
    glm::vec3 weight{0};
    bool mirror = false;
    glm::vec3 toViewer{0};  ///< of a mirror
  };
  glm::vec3 constant{0};
  std::vector<Layer> layers;
};

class PathTracer {
 public:
  PathTracer(const TraceScene& scene, const TraceCamera& camera, const TraceSettings& settings)
      : scene_(scene), camera_(camera), settings_(settings) {}

  /// Pixel (0,0) is top left; its ray goes through the pixel's middle, as the frame's does.
  PixelView view(int x, int y, RayCounts& counts) const;
  /// One sample of its radiance.
  glm::vec3 sample(const PixelView& view, SampleRandom& random, RayCounts& counts) const;
  /// One sample of the mean radiance over the hemisphere of a surface, weighed by the cosine; or, with
  /// a direction, of the radiance from there.
  glm::vec3 incoming(TraceSurface surface, SampleRandom& random, RayCounts& counts,
                     const glm::vec3* from = nullptr) const;

 private:
  struct Look;
  struct Query;
  struct MetBall {
    const LampFace* lamp = nullptr;
    float distance = std::numeric_limits<float>::infinity();
  };
  void look(const Look& from, PixelView& view, RayCounts& counts) const;
  void seeOpaque(const Look& from, const RayHit& hit, const glm::vec3& weight, PixelView& view,
                 RayCounts& counts) const;
  float seeTranslucent(const Look& from, const RayHit& hit, const glm::vec3& weight,
                       PixelView& view, RayCounts& counts) const;
  glm::vec3 drawnSun(const TraceSurface& surface, const glm::vec3& toViewer,
                     RayCounts& counts) const;
  glm::vec3 sunVisibility(const TraceSurface& surface, RayCounts& counts) const;
  void askSun(const TraceSurface& surface, Query& query, RayCounts& counts) const;
  void askLamp(const TraceSurface& surface, SampleRandom& random, Query& query,
               RayCounts& counts) const;
  static void askBall(const TraceSurface& surface, const LampDraw& drawn, glm::vec2 u, Query& query,
                      RayCounts& counts);
  bool isOwn(const TraceSurface& surface, glm::ivec3 cell) const;
  MetBall ballAlong(const glm::vec3& origin, const glm::vec3& direction) const;
  glm::vec3 lampRadiance(const RayHit& hit) const;
  glm::vec3 metLamp(const RayHit& hit, const TraceSurface& from, const glm::vec3& direction) const;
  glm::vec3 mirrored(const PixelView::Layer& layer, SampleRandom& random, RayCounts& counts) const;
  void setSurface(const RayHit& hit, const glm::vec3& direction, TraceSurface& surface,
                  const TextureLevel& level = {}) const;
  glm::vec3 pixelRay(int x, int y) const;

  const TraceScene& scene_;
  TraceCamera camera_;
  TraceSettings settings_;
};

}  // namespace orris
