// What the camera sees, layer by layer, as the frame draws it: fronts only, translucent quads blended
// over what is behind them.
#include <algorithm>
#include <cmath>

#include <orris/trace/path_tracer.h>

namespace orris {
namespace {

constexpr float kWaterReflectance = 0.02f;  // gbuffers_translucent

}  // namespace

/// A ray of the camera, or its mirror image on water.
struct PathTracer::Look {
  Ray ray;
  glm::vec3 weight{1};
  bool mirrored = false;
  const PixelFootprint* footprint = nullptr;
};

/// Direct sun as the frame shades it, with the reflection that DIRECT_LIGHT names.
glm::vec3 PathTracer::drawnSun(const TraceSurface& surface, const glm::vec3& toViewer,
                               RayCounts& counts) const {
  const PackLighting& light = *scene_.lighting;
  const glm::vec3 toSun = light.lightDirection();
  TraceSurface lit = surface;
  if (lit.thin && glm::dot(lit.normal, toSun) < 0) lit.normal = -lit.normal;
  if (glm::dot(lit.normal, toSun) <= 0 || light.lightIrradiance() == glm::vec3(0))
    return glm::vec3(0);
  const glm::vec3 reflected =
      lit.gloss != 0 ? light.reflectGlossy(lit.gloss, lit.albedo, lit.normal, toViewer, toSun)
                     : light.reflectDirect(lit.albedo, lit.normal, toViewer, toSun);
  return light.lightIrradiance() * reflected * sunVisibility(lit, counts);
}

void PathTracer::seeOpaque(const Look& from, const RayHit& hit, const glm::vec3& weight,
                           PixelView& view, RayCounts& counts) const {
  TraceSurface surface;
  setSurface(hit, from.ray.direction, surface, scene_.grid.textureLevel(hit.quad, from.footprint));
  const std::uint8_t level = scene_.grid.quad(hit.quad).emission;
  view.constant += weight * (surface.albedo * scene_.emissionScale[level] +
                             drawnSun(surface, -from.ray.direction, counts));
  if (surface.gloss == 0) return view.layers.push_back({surface, weight});
  const glm::vec3 toViewer = -from.ray.direction;
  const float cosine = std::max(glm::dot(surface.normal, toViewer), 0.0f);
  view.layers.push_back(
      {surface, weight * scene_.lighting->diffuseShare(surface.gloss, surface.albedo, cosine)});
  view.layers.push_back({surface, weight, true, toViewer});
}

/// Returns the share of what is behind.
float PathTracer::seeTranslucent(const Look& from, const RayHit& hit, const glm::vec3& weight,
                                 PixelView& view, RayCounts& counts) const {
  const TraceQuad& quad = scene_.grid.quad(hit.quad);
  const glm::vec3 toViewer = -from.ray.direction;
  TraceSurface surface;
  const TextureLevel level = scene_.grid.textureLevel(hit.quad, from.footprint);
  setSurface(hit, from.ray.direction, surface, level);
  surface.thin = false;
  surface.gloss = 0;
  const float grazing = 1 - glm::clamp(glm::dot(surface.normal, toViewer), 0.0f, 1.0f);
  const float mirror =
      quad.water ? kWaterReflectance + (1 - kWaterReflectance) * std::pow(grazing, 5.0f) : 0;
  const float alpha = glm::mix(scene_.grid.texel(quad, hit.at, level).a, 1.0f, mirror);
  const glm::vec3 diffuse = weight * (alpha * (1 - mirror));
  view.constant += diffuse * (surface.albedo * scene_.emissionScale[quad.emission] + drawnSun(surface, toViewer, counts));
  view.layers.push_back({surface, diffuse});
  if (mirror > 0) {
    const glm::vec3 direction = glm::reflect(from.ray.direction, surface.normal);
    const glm::vec3 share = weight * (alpha * mirror);
    if (from.mirrored)
      view.constant += share * scene_.lighting->skyRadiance(direction);
    else
      look({{surface.position, withoutZeros(direction), surface.cell, -1, hit.quad}, share, true},
           view, counts);
  }
  return 1 - alpha;
}

void PathTracer::look(const Look& from, PixelView& view, RayCounts& counts) const {
  Look now = from;
  for (int i = 0; i < kMostLayers; ++i) {
    ++counts.camera;
    const RayHit hit = scene_.grid.look(now.ray, now.footprint);
    if (hit.quad == kNoQuad) {
      view.constant += now.weight * scene_.lighting->skyRadiance(now.ray.direction);
      return;
    }
    const TraceQuad& quad = scene_.grid.quad(hit.quad);
    if (!quad.blended) return seeOpaque(now, hit, now.weight, view, counts);
    now.weight *= seeTranslucent(now, hit, now.weight, view, counts);
    now.ray.origin = quad.corner + quad.edgeU * hit.at.x + quad.edgeV * hit.at.y;
    now.ray.cell = hit.cell;
    now.ray.enteredBy = -1;
    now.ray.ignore = hit.quad;
  }
}

glm::vec3 PathTracer::pixelRay(int x, int y) const {
  const glm::vec2 pixel((float(x) + 0.5f) / float(camera_.width),
                        (float(y) + 0.5f) / float(camera_.height));
  const glm::vec4 clip =
      camera_.projectionInverse * glm::vec4(pixel.x * 2 - 1, 1 - pixel.y * 2, 1, 1);
  return glm::normalize(glm::mat3(camera_.modelViewInverse) * (glm::vec3(clip) / clip.w));
}

PixelView PathTracer::view(int x, int y, RayCounts& counts) const {
  const glm::vec3 direction = pixelRay(x, y);
  PixelView view;
  Look from;
  from.ray.origin = glm::vec3(camera_.position - glm::dvec3(scene_.origin));
  from.ray.direction = withoutZeros(direction);
  from.ray.cell = glm::ivec3(glm::floor(from.ray.origin));
  // Squares of four begin in the lower left corner of the picture.
  const int left = x & ~1, below = camera_.height - 1 - ((camera_.height - 1 - y) & ~1);
  const PixelFootprint footprint{
      from.ray.origin,
      {pixelRay(left, below), pixelRay(left + 1, below), pixelRay(left, below - 1)}};
  from.footprint = &footprint;
  if (!scene_.grid.contains(from.ray.cell) && !scene_.grid.enter(from.ray)) {
    view.constant = scene_.lighting->skyRadiance(direction);
    return view;
  }
  look(from, view, counts);
  return view;
}

}  // namespace orris
