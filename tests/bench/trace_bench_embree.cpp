#include "trace_bench_embree.h"

#ifdef ORRIS_HAS_EMBREE

#include <embree3/rtcore.h>

#include <cmath>

namespace orris {
namespace {

struct Scene {
  const VoxelGrid* grid;
  std::vector<std::uint32_t> quads;  ///< of the grid, by Embree's
};

void dropHoles(const RTCFilterFunctionNArguments* arguments) {
  const auto& scene = *static_cast<const Scene*>(arguments->geometryUserPtr);
  const auto* hit = reinterpret_cast<const RTCHit*>(arguments->hit);
  const TraceQuad& quad = scene.grid->quad(scene.quads[hit->primID]);
  if (quad.alphaTested && scene.grid->texel(quad, {hit->u, hit->v}).a < kAlphaTest)
    arguments->valid[0] = 0;
}

RTCGeometry makeQuads(RTCDevice device, Scene& scene) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_QUAD);
  for (std::uint32_t i = 1; i < scene.grid->quads().size(); ++i)
    if (!scene.grid->quad(i).translucent) scene.quads.push_back(i);
  const std::size_t count = scene.quads.size();
  auto* points = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 4 * count));
  auto* indices = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT4, 4 * sizeof(unsigned), count));
  for (std::size_t i = 0; i < count; ++i) {
    const TraceQuad& q = scene.grid->quad(scene.quads[i]);
    const glm::vec3 corners[4] = {q.corner, q.corner + q.edgeU, q.corner + q.edgeU + q.edgeV,
                                  q.corner + q.edgeV};
    for (std::size_t c = 0; c < 4; ++c) {
      for (int axis = 0; axis < 3; ++axis)
        points[(4 * i + c) * 3 + std::size_t(axis)] = corners[c][axis];
      indices[4 * i + c] = unsigned(4 * i + c);
    }
  }
  rtcSetGeometryUserData(geometry, &scene);
  bool holes = false;
  for (const std::uint32_t quad : scene.quads) holes |= scene.grid->quad(quad).alphaTested;
  if (holes) rtcSetGeometryIntersectFilterFunction(geometry, dropHoles);
  rtcCommitGeometry(geometry);
  return geometry;
}

std::uint64_t shootAll(RTCScene scene, const std::vector<Ray>& rays) {
  std::uint64_t hits = 0;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  for (const Ray& ray : rays) {
    RTCRayHit query;
    query.ray = {ray.origin.x,
                 ray.origin.y,
                 ray.origin.z,
                 1e-4f,
                 ray.direction.x,
                 ray.direction.y,
                 ray.direction.z,
                 0,
                 INFINITY,
                 ~0u,
                 0,
                 0};
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene, &context, &query);
    hits += query.hit.geomID != RTC_INVALID_GEOMETRY_ID;
  }
  return hits;
}

}  // namespace

EmbreeTimes measureEmbree(const VoxelGrid& grid, const std::vector<Ray>& rays, int rounds) {
  RTCDevice device = rtcNewDevice("threads=1");
  Scene quads{&grid, {}};
  RTCScene scene = rtcNewScene(device);
  rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_HIGH);
  RTCGeometry geometry = makeQuads(device, quads);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene);
  EmbreeTimes times{true, INFINITY, 0};
  for (int i = 0; i < rounds; ++i) {
    const double start = threadSeconds();
    times.hits = shootAll(scene, rays);
    times.seconds = std::min(times.seconds, threadSeconds() - start);
  }
  rtcReleaseScene(scene);
  rtcReleaseDevice(device);
  return times;
}

}  // namespace orris

#else

namespace orris {

EmbreeTimes measureEmbree(const VoxelGrid&, const std::vector<Ray>&, int) { return {}; }

}  // namespace orris

#endif
