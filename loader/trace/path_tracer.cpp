#include "trace/path_tracer.h"

#include <algorithm>
#include <cmath>

namespace orris {
namespace {

constexpr float kPi = 3.14159265f;
// Bounces before Russian roulette may end a path.
constexpr int kSureBounces = 2;
constexpr int kMaxBounces = 4096;

Ray rayFrom(const TraceSurface& surface, const glm::vec3& direction) {
  return {surface.position, withoutZeros(direction), surface.cell, -1, surface.quad};
}

/// Density cos/pi about n: a point of the unit sphere resting on the plane.
glm::vec3 cosineDirection(const glm::vec3& n, glm::vec2 u) {
  const float z = 1 - 2 * u.x, r = std::sqrt(std::max(0.0f, 1 - z * z)), phi = 2 * kPi * u.y;
  const glm::vec3 sum = n + glm::vec3(r * std::cos(phi), r * std::sin(phi), z);
  const float length = glm::dot(sum, sum);
  return length > 1e-12f ? sum / std::sqrt(length) : n;
}

float brightest(const glm::vec3& color) { return std::max(color.r, std::max(color.g, color.b)); }

/// Share of light that a thin surface lets through: what it reflects, as far as there is so much.
glm::vec3 passedBy(const TraceSurface& surface) {
  return glm::min(surface.albedo, 1.0f - surface.albedo);
}

/// Which side of a thin surface the next ray looks at; the factor replaces the albedo.
glm::vec3 chooseSide(TraceSurface& surface, SampleRandom& random) {
  if (!surface.thin) return surface.albedo;
  if (random.one() < 0.5f) return 2.0f * surface.albedo;
  surface.normal = -surface.normal;
  return 2.0f * passedBy(surface);
}

}  // namespace

RayCounts& RayCounts::operator+=(const RayCounts& other) {
  camera += other.camera;
  path += other.path;
  lamp += other.lamp;
  sun += other.sun;
  return *this;
}

TraceSurface PathTracer::surfaceAt(const RayHit& hit, const glm::vec3& direction) const {
  const TraceQuad& quad = scene_.grid.quad(hit.quad);
  TraceSurface surface;
  surface.position = quad.corner + quad.edgeU * hit.at.x + quad.edgeV * hit.at.y;
  const bool away = glm::dot(quad.normal, direction) > 0;
  surface.normal = away ? -quad.normal : quad.normal;
  surface.cell = hit.cube ? hit.cell + glm::ivec3(quad.normal) : hit.cell;
  surface.quad = hit.quad;
  surface.albedo = glm::vec3(scene_.grid.texel(quad, hit.at));
  surface.thin = quad.thin;
  return surface;
}

glm::vec3 PathTracer::sunVisibility(const TraceSurface& surface, RayCounts& counts) const {
  if (!scene_.grid.isOpen(surface.cell)) return glm::vec3(0);
  ++counts.sun;
  const Ray ray = rayFrom(surface, scene_.lighting->lightDirection());
  const RayHit hit = scene_.grid.intersect(ray);
  return hit.quad == kNoQuad ? hit.filter : glm::vec3(0);
}

glm::vec3 PathTracer::lampLight(const TraceSurface& surface, SampleRandom& random,
                                RayCounts& counts) const {
  const LampFace& lamp = scene_.lamps.draw(random.one());
  const TraceQuad& quad = scene_.grid.quad(lamp.quad);
  const glm::vec2 at = random.pair();
  const glm::vec3 point = quad.corner + quad.edgeU * at.x + quad.edgeV * at.y;
  const glm::vec3 to = point - surface.position;
  const float squared = glm::dot(to, to);
  if (!(squared > 1e-10f)) return glm::vec3(0);
  const glm::vec3 direction = to / std::sqrt(squared);
  const float cosine = glm::dot(surface.normal, direction);
  const float lampCosine = -glm::dot(quad.normal, direction);
  if (cosine <= 0 || lampCosine <= 1e-6f) return glm::vec3(0);
  ++counts.lamp;
  const RayHit hit = scene_.grid.intersect(rayFrom(surface, direction));
  if (hit.quad != lamp.quad) return glm::vec3(0);
  // Balance heuristic: this density against that of the cosine ray.
  const float density = lamp.probability / lamp.area * squared / lampCosine;
  const float other = cosine / kPi;
  return lamp.radiance * hit.filter * (other / (density + other));
}

/// The light of a lamp that a ray of the given density met.
glm::vec3 PathTracer::metLamp(const RayHit& hit, const glm::vec3& direction, float density) const {
  const TraceQuad& quad = scene_.grid.quad(hit.quad);
  if (quad.lamp == kNoQuad || hit.back) return glm::vec3(0);
  const LampFace& lamp = scene_.lamps.face(quad.lamp);
  const float lampCosine = std::max(-glm::dot(quad.normal, direction), 1e-6f);
  const float other = lamp.probability / lamp.area * hit.distance * hit.distance / lampCosine;
  return lamp.radiance * (density / (density + other));
}

glm::vec3 PathTracer::incoming(TraceSurface surface, SampleRandom& random,
                               RayCounts& counts) const {
  const glm::vec3 sun = scene_.lighting->lightIrradiance();
  const glm::vec3 toSun = scene_.lighting->lightDirection();
  const bool hasSun = brightest(sun) > 0;
  const int limit = settings_.bounces < 0 ? kMaxBounces : settings_.bounces;
  glm::vec3 throughput(1), radiance(0);
  for (int bounce = 0; bounce < limit; ++bounce) {
    if (!scene_.lamps.empty()) radiance += throughput * lampLight(surface, random, counts);
    const glm::vec3 direction = cosineDirection(surface.normal, random.pair());
    ++counts.path;
    const RayHit hit = scene_.grid.intersect(rayFrom(surface, direction));
    throughput *= hit.filter;
    if (hit.quad == kNoQuad) return radiance + throughput * scene_.lighting->skyRadiance(direction);
    const float cosine = std::max(glm::dot(surface.normal, direction), 1e-6f);
    radiance += throughput * metLamp(hit, direction, cosine / kPi);

    surface = surfaceAt(hit, direction);
    const float slope = glm::dot(surface.normal, toSun);
    if (hasSun && (slope > 0 || surface.thin)) {
      const glm::vec3 reflected = slope > 0 ? surface.albedo : passedBy(surface);
      radiance +=
          throughput * reflected * (std::abs(slope) / kPi) * sun * sunVisibility(surface, counts);
    }
    throughput *= chooseSide(surface, random);
    if (bounce < kSureBounces) continue;
    const float survival = std::min(brightest(throughput), 1.0f);
    if (!(random.one() < survival)) break;
    throughput /= survival;
  }
  return radiance;
}

glm::vec3 PathTracer::sample(const PixelView& view, SampleRandom& random, RayCounts& counts) const {
  glm::vec3 radiance = view.constant;
  for (const PixelView::Layer& layer : view.layers) {
    TraceSurface surface = layer.surface;
    const glm::vec3 reflected = chooseSide(surface, random);
    radiance += layer.weight * reflected * incoming(surface, random, counts);
  }
  return radiance;
}

}  // namespace orris
