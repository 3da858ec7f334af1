#include "cache_scene.h"

#include <orris/render/session/loaded_pack.h>

namespace orris {
namespace {

glm::ivec3 frontCell(const TraceQuad& quad) {
  return glm::ivec3(
      glm::floor(quad.corner + 0.5f * (quad.edgeU + quad.edgeV) + 0.5f * quad.normal));
}

glm::vec3 meanIncoming(const PathTracer& tracer, const TraceSurface& surface, std::uint32_t pixel,
                       int samples) {
  RayCounts counts;
  glm::dvec3 sum(0);
  for (int i = 0; i < samples; ++i) {
    SampleRandom random(7, pixel, std::uint32_t(i));
    sum += glm::dvec3(tracer.incoming(surface, random, counts));
  }
  return glm::vec3(sum / double(samples));
}

PathTracer tracerOf(const ReferenceScene& reference, int bounces) {
  TraceSettings settings;
  settings.bounces = bounces;
  return PathTracer(reference.scene, reference.camera, settings);
}

}  // namespace

glm::vec3 cosineAbout(const glm::vec3& n, SampleRandom& random) {
  const glm::vec2 u = random.pair();
  const float z = 1 - 2 * u.x, r = std::sqrt(std::max(0.0f, 1 - z * z)), turn = 6.2831853f * u.y;
  return glm::normalize(n + 0.9999f * glm::vec3(r * std::cos(turn), r * std::sin(turn), z));
}

std::optional<Room> Room::open(const std::string& path, int columns, int samples) {
  Diagnostics diagnostics;
  auto world = loadWorld(path, 0, diagnostics);
  LoadRequest request;
  request.buildSources = false;
  const auto pack = loadShaderPack(memorySource(referencePackFiles()), request, diagnostics);
  if (!world || !pack) return std::nullopt;
  const Camera camera = world->cameras.front();
  Room room;
  room.reference_ = std::make_shared<ReferenceScene>(buildReferenceScene(
      std::move(*world), *pack, camera, columns, columns * 9 / 16, diagnostics));
  const VoxelGrid& grid = room.grid();
  for (std::uint32_t i = kHiddenQuad + 1; i < grid.quads().size(); ++i)
    if (!grid.isOpen(frontCell(grid.quad(i)))) room.faces_.push_back(i);
  const PathTracer all = tracerOf(*room.reference_, -1), one = tracerOf(*room.reference_, 1);
  RayCounts counts;
  for (int y = 0; y < columns * 9 / 16; ++y)
    for (int x = 0; x < columns; ++x) {
      const PixelView view = all.view(x, y, counts);
      if (view.layers.empty()) continue;
      RoomPoint point{view.layers[0].surface};
      const auto pixel = std::uint32_t(y * columns + x);
      point.reference = meanIncoming(all, point.surface, pixel, samples);
      point.direct = meanIncoming(one, point.surface, pixel, samples);
      room.points_.push_back(point);
    }
  return room;
}

TraceSurface Room::surfaceAt(const RayHit& hit) const {
  const TraceQuad& quad = grid().quad(hit.quad);
  TraceSurface surface;
  surface.position = quad.corner + quad.edgeU * hit.at.x + quad.edgeV * hit.at.y;
  surface.normal = quad.normal;
  surface.cell = frontCell(quad);
  surface.quad = hit.quad;
  surface.albedo = glm::vec3(grid().texel(quad, hit.at));
  return surface;
}

TraceSurface Room::onFace(std::uint32_t quad, SampleRandom& random) const {
  RayHit hit;
  hit.quad = quad;
  hit.at = random.pair();
  return surfaceAt(hit);
}

RayHit Room::cosineHit(const TraceSurface& from, SampleRandom& random) const {
  Ray ray;
  ray.origin = from.position;
  ray.direction = withoutZeros(cosineAbout(from.normal, random));
  ray.cell = from.cell;
  ray.ignore = from.quad;
  return grid().intersect(ray);
}

glm::vec3 Room::directAt(const TraceSurface& surface, SampleRandom& random) const {
  RayCounts counts;
  return tracerOf(*reference_, 1).incoming(surface, random, counts);
}

glm::vec3 Room::lampOf(const RayHit& hit) const {
  const std::uint32_t lamp = grid().quad(hit.quad).lamp;
  return lamp == kNoQuad || hit.back ? glm::vec3(0) : reference_->scene.lamps.face(lamp).radiance;
}

}  // namespace orris
