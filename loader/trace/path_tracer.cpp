#include <orris/trace/path_tracer.h>

#include <algorithm>
#include <cmath>

namespace orris {
namespace {

constexpr float kPi = 3.14159265f;
// Bounces before Russian roulette may end a path.
constexpr int kSureBounces = 2;
constexpr int kMaxBounces = 4096;

/// Sine and cosine of a turn of -1/2 to 1/2, to 1e-6: Taylor's series of a quarter, doubled twice.
glm::vec2 cosineSine(float turn) {
  const float x = turn * (kPi / 2), xx = x * x;
  const float s = x * (1 + xx * (-1.0f / 6 + xx * (1.0f / 120 + xx * (-1.0f / 5040))));
  const float c = 1 + xx * (-0.5f + xx * (1.0f / 24 + xx * (-1.0f / 720 + xx * (1.0f / 40320))));
  const float s2 = 2 * s * c, c2 = 1 - 2 * s * s;
  return {1 - 2 * s2 * s2, 2 * s2 * c2};
}

/// Density cos/pi about n: a point of the unit sphere resting on the plane.
glm::vec3 cosineDirection(const glm::vec3& n, glm::vec2 u) {
  const float z = 1 - 2 * u.x, r = std::sqrt(std::max(0.0f, 1 - z * z));
  const glm::vec3 sum = n + glm::vec3(r * cosineSine(u.y - 0.5f), z);
  const float length = glm::dot(sum, sum);
  return length > 1e-12f ? sum * (1 / std::sqrt(length)) : n;
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

/// A ray from a surface, and what it is worth if it arrives.
struct PathTracer::Query {
  bool wanted = false;
  Ray ray;
  glm::vec3 value{0};              ///< light, before what filters take
  std::uint32_t target = kNoQuad;  ///< must be met; kNoQuad: the sky
  const LampFace* ball = nullptr;  ///< must be reached, if only the blocks of its lamp
  float reach = 0;                 ///< the distance to it
  RayHit hit;

  /// Looks no farther than `until`.
  void send(const TraceSurface& from, const glm::vec3& direction, std::uint64_t& count, RayCounts& counts,
            float until = std::numeric_limits<float>::infinity()) {
    wanted = true;
    ray.origin = from.position;
    ray.direction = withoutZeros(direction);
    ray.cell = from.cell;
    ray.ignore = from.quad;
    hit.quad = kNoQuad;
    hit.distance = until;
    hit.back = hit.cube = false;
    hit.filter = glm::vec3(1);
    ++count;
    if (counts.record != nullptr) counts.record->push_back(ray);
  }
  glm::vec3 arrived() const {
    const bool met =
        ball == nullptr ? hit.quad == target
                        : hit.distance >= reach || hit.cell == glm::ivec3(glm::floor(ball->corner));
    return wanted && met ? value * hit.filter : glm::vec3(0);
  }
};

void PathTracer::setSurface(const RayHit& hit, const glm::vec3& direction, TraceSurface& surface,
                            const TextureLevel& level) const {
  const TraceQuad& quad = scene_.grid.quad(hit.quad);
  surface.position = quad.corner + quad.edgeU * hit.at.x + quad.edgeV * hit.at.y;
  const bool away = glm::dot(quad.normal, direction) > 0;
  surface.normal = away ? -quad.normal : quad.normal;
  surface.cell = hit.cube ? hit.cell + glm::ivec3(quad.normal) : hit.cell;
  surface.quad = hit.quad;
  surface.albedo = glm::vec3(scene_.grid.texel(quad, hit.at, level));
  surface.thin = quad.thin;
  surface.gloss = quad.gloss;
}

glm::vec3 PathTracer::sunVisibility(const TraceSurface& surface, RayCounts& counts) const {
  if (!scene_.grid.isOpen(surface.cell)) return glm::vec3(0);
  Query query;
  query.send(surface, scene_.lighting->lightDirection(), counts.sun, counts);
  query.value = glm::vec3(1);
  scene_.grid.intersect(query.ray, query.hit);
  return query.arrived();
}

/// Asks for the direct sun on a diffuse surface.
void PathTracer::askSun(const TraceSurface& surface, Query& query, RayCounts& counts) const {
  query.wanted = false;
  if (scene_.lighting->lightIrradiance().r <= 0 || !scene_.grid.isOpen(surface.cell)) return;
  const glm::vec3 toSun = scene_.lighting->lightDirection();
  const float slope = glm::dot(surface.normal, toSun);
  if (slope <= 0 && !surface.thin) return;
  const glm::vec3 reflected = slope > 0 ? surface.albedo : passedBy(surface);
  query.value = reflected * scene_.lighting->lightIrradiance() * (std::abs(slope) / kPi);
  query.send(surface, toSun, counts.sun, counts);
}

/// Asks for the light of a ball: a direction within the cone that it fills.
void PathTracer::askBall(const TraceSurface& surface, const LampDraw& drawn, glm::vec2 u,
                         Query& query, RayCounts& counts) {
  const LampFace& ball = *drawn.face;
  const glm::vec3 to = ball.corner - surface.position;
  const float far = glm::length(to);
  if (far <= ball.radius) return;
  const float edge = std::sqrt(1 - ball.radius * ball.radius / (far * far));
  const float z = glm::mix(1.0f, edge, u.x), across = std::sqrt(std::max(0.0f, 1 - z * z));
  const glm::vec3 axis = to / far;
  const glm::vec3 side = glm::normalize(
      glm::cross(axis, std::abs(axis.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0)));
  const glm::vec2 turn = cosineSine(u.y - 0.5f);
  const glm::vec3 direction = axis * z + across * (turn.x * side + turn.y * glm::cross(axis, side));
  const float cosine = glm::dot(surface.normal, direction);
  if (cosine <= 0) return;
  // 2 pi (1 - edge) is the cone's solid angle.
  query.value = ball.radiance * (2 * (1 - edge) * cosine / drawn.probability);
  query.ball = &ball;
  query.reach = far - ball.radius;
  query.send(surface, direction, counts.lamp, counts, query.reach);
}

/// Asks for the light of one lamp, drawn at random, as mean radiance.
void PathTracer::askLamp(const TraceSurface& surface, SampleRandom& random, Query& query,
                         RayCounts& counts) const {
  query.wanted = false;
  query.ball = nullptr;
  if (scene_.lamps.empty()) return;
  const LampDraw drawn = scene_.lamps.draw(surface.cell, random.one());
  if (drawn.face == nullptr) return;
  const LampFace& lamp = *drawn.face;
  const glm::vec2 at = random.pair();
  if (isOwn(surface, lamp.cell)) return;
  if (lamp.radius > 0) return askBall(surface, drawn, at, query, counts);
  const glm::vec3 to = lamp.corner + lamp.edgeU * at.x + lamp.edgeV * at.y - surface.position;
  const float squared = glm::dot(to, to);
  if (!(squared > 1e-10f)) return;
  const glm::vec3 direction = to * (1 / std::sqrt(squared));
  const float cosine = glm::dot(surface.normal, direction);
  const float lampCosine = -glm::dot(lamp.normal, direction);
  if (cosine <= 0 || lampCosine <= 1e-6f) return;
  // Balance heuristic: other / density of the estimate, density / (density + other) of its weight.
  const float density = drawn.probability / lamp.area * squared / lampCosine;
  const float other = cosine / kPi;
  query.value = lamp.radiance * (other / (density + other));
  query.target = lamp.quad;
  query.send(surface, direction, counts.lamp, counts);
}

/// What a lamp gives is what leaves it: its own faces (of a torch beside its ball, of crossed planes of fire) get none.
bool PathTracer::isOwn(const TraceSurface& surface, glm::ivec3 cell) const {
  return surface.cell == cell && surface.quad != kNoQuad && scene_.grid.quad(surface.quad).emission > 0;
}

/// Of the front of a lamp's face; 0 of all else.
glm::vec3 PathTracer::lampRadiance(const RayHit& hit) const {
  const std::uint32_t lamp = scene_.grid.quad(hit.quad).lamp;
  return lamp == kNoQuad || hit.back ? glm::vec3(0) : scene_.lamps.face(lamp).radiance;
}

/// The light of a lamp that a cosine ray met.
glm::vec3 PathTracer::metLamp(const RayHit& hit, const TraceSurface& from,
                              const glm::vec3& direction) const {
  const TraceQuad& quad = scene_.grid.quad(hit.quad);
  if (quad.lamp == kNoQuad || hit.back || isOwn(from, hit.cell)) return glm::vec3(0);
  const LampFace& lamp = scene_.lamps.face(quad.lamp);
  const float lampCosine = std::max(-glm::dot(quad.normal, direction), 1e-6f);
  const float density = std::max(glm::dot(from.normal, direction), 0.0f) / kPi;
  const float probability = scene_.lamps.probability(from.cell, quad.lamp);
  const float other = probability / lamp.area * hit.distance * hit.distance / lampCosine;
  return density > 0 ? lamp.radiance * (density / (density + other)) : glm::vec3(0);
}

/// The nearest ball of a lamp in a direction, as rays of the pack meet it, and its distance.
PathTracer::MetBall PathTracer::ballAlong(const glm::vec3& origin, const glm::vec3& direction) const {
  MetBall met;
  for (const LampFace& lamp : scene_.lamps.faces()) {
    const glm::vec3 to = lamp.corner - origin;
    const float along = glm::dot(to, direction);
    const float inside = lamp.radius * lamp.radius - (glm::dot(to, to) - along * along);
    if (along <= 0 || inside <= 0 || along - std::sqrt(inside) >= met.distance) continue;
    met = {&lamp, along - std::sqrt(inside)};
  }
  return met;
}

glm::vec3 PathTracer::incoming(TraceSurface surface, SampleRandom& random, RayCounts& counts,
                               const glm::vec3* from) const {
  const VoxelGrid& grid = scene_.grid;
  const int limit = settings_.bounces < 0 ? kMaxBounces : settings_.bounces;
  glm::vec3 throughput(1), sunThroughput(0), radiance(0);
  Query path, lamp, sun;
  bool survives = true;
  for (int bounce = 0;; ++bounce) {
    if (bounce > 0) askSun(surface, sun, counts);
    if (bounce >= limit || !survives) break;
    const bool chosen = bounce == 0 && from != nullptr;
    lamp.wanted = false;
    if (!chosen) askLamp(surface, random, lamp, counts);
    const glm::vec3 direction = chosen ? *from : cosineDirection(surface.normal, random.pair());
    const MetBall ball = chosen ? ballAlong(surface.position, direction) : MetBall{};
    path.send(surface, direction, counts.path, counts, ball.distance);
    Query& beside = lamp.wanted ? lamp : sun;
    if (beside.wanted)
      grid.intersect(path.ray, path.hit, beside.ray, beside.hit);
    else
      grid.intersect(path.ray, path.hit);
    if (lamp.wanted && sun.wanted) grid.intersect(sun.ray, sun.hit);
    radiance += sunThroughput * sun.arrived() + throughput * lamp.arrived();
    throughput *= path.hit.filter;
    if (ball.lamp != nullptr && path.hit.distance >= ball.distance) return radiance + throughput * ball.lamp->radiance;
    if (path.hit.quad == kNoQuad)
      return radiance + throughput * scene_.lighting->skyRadiance(direction);
    radiance +=
        throughput * (chosen ? lampRadiance(path.hit) : metLamp(path.hit, surface, direction));

    setSurface(path.hit, direction, surface);
    sunThroughput = throughput;
    throughput *= chooseSide(surface, random);
    if (bounce < kSureBounces) continue;
    const float survival = std::min(brightest(throughput), 1.0f);
    survives = random.one() < survival;
    throughput /= survival;
  }
  if (!sun.wanted) return radiance;
  grid.intersect(sun.ray, sun.hit);
  return radiance + sunThroughput * sun.arrived();
}

/// One sample of what a mirror shows.
glm::vec3 PathTracer::mirrored(const PixelView::Layer& layer, SampleRandom& random,
                               RayCounts& counts) const {
  const TraceSurface& surface = layer.surface;
  const MirrorSample sample = scene_.lighting->mirror(surface.gloss, surface.albedo, surface.normal,
                                                      layer.toViewer, random.pair());
  if (sample.weight == glm::vec3(0)) return glm::vec3(0);
  return sample.weight * incoming(surface, random, counts, &sample.direction);
}

glm::vec3 PathTracer::sample(const PixelView& view, SampleRandom& random, RayCounts& counts) const {
  glm::vec3 radiance = view.constant;
  for (const PixelView::Layer& layer : view.layers) {
    if (layer.mirror) {
      radiance += layer.weight * mirrored(layer, random, counts);
      continue;
    }
    TraceSurface surface = layer.surface;
    const glm::vec3 reflected = chooseSide(surface, random);
    radiance += layer.weight * reflected * incoming(surface, random, counts);
  }
  return radiance;
}

}  // namespace orris
