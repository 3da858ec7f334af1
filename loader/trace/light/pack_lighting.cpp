#include <orris/trace/light/pack_lighting.h>

#include <algorithm>
#include <cstdlib>

namespace orris {
namespace {

using namespace glm;

float numberOf(const std::map<std::string, std::string>& options, const char* name) {
  const auto found = options.find(name);
  return found == options.end() ? 0.0f : std::strtof(found->second.c_str(), nullptr);
}

}  // namespace

// Options and uniforms are members under the pack's names; its functions follow.
struct PackLighting::Functions {
  float SUN_STRENGTH = 0, SKY_STRENGTH = 0, EMISSION_STRENGTH = 0;
  mat4 gbufferModelViewInverse{1};
  vec3 sunPosition{0}, shadowLightPosition{0};
  float rainStrength = 0;

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"
#include "reference_pack_functions.inc"
#pragma GCC diagnostic pop
};

PackLighting::PackLighting(const LightingInput& input)
    : functions_(std::make_unique<Functions>()), lightDirection_(input.lightDirection) {
  functions_->SUN_STRENGTH = numberOf(input.options, "SUN_STRENGTH");
  functions_->SKY_STRENGTH = numberOf(input.options, "SKY_STRENGTH");
  functions_->EMISSION_STRENGTH = numberOf(input.options, "EMISSION_STRENGTH");
  functions_->sunPosition = input.sunDirection;
  functions_->shadowLightPosition = input.lightDirection;
  functions_->rainStrength = input.rainStrength;
  lightIrradiance_ = functions_->light_irradiance();
  const auto direct = input.options.find("DIRECT_LIGHT");
  if (direct != input.options.end()) directLight_ = direct->second;
  const auto glossy = input.options.find("GI_GLOSSY");
  mirrors_ = glossy != input.options.end() && glossy->second == "true";
}

PackLighting::~PackLighting() = default;
PackLighting::PackLighting(PackLighting&&) noexcept = default;
PackLighting& PackLighting::operator=(PackLighting&&) noexcept = default;

vec3 PackLighting::skyRadiance(const vec3& direction) const {
  return functions_->sky_radiance(direction);
}

vec3 PackLighting::reflectDirect(const vec3& albedo, const vec3& n, const vec3& v,
                                 const vec3& l) const {
  const float cosine = std::max(dot(n, l), 0.0f);
  if (directLight_ == "NONE") return vec3(0);
  if (directLight_ == "PHONG_PUBLISHED") return functions_->reflect_as_published(albedo, n, v, l);
  return cosine * (directLight_ == "LAMBERT_GGX" ? functions_->reflect_ggx(albedo, n, v, l)
                                                 : functions_->reflect_phong(albedo, n, v, l));
}

float PackLighting::emissionScale(int level) const {
  return functions_->lamp_radiance(vec3(1), level).x;
}

LampLight PackLighting::lampLight(int id, int level, const vec3& mean) const {
  const float brightest = std::max(std::max(mean.r, mean.g), std::max(mean.b, 1e-3f));
  const vec3 listed = functions_->is_lamp(id) ? functions_->lamp_color(id) : vec3(0);
  const vec3 color = listed == vec3(0) ? mean / brightest : listed;
  const vec3 radiance = functions_->lamp_radiance(color, level);
  if (!functions_->is_small_lamp(id)) return {radiance, 6};
  const float radius = Functions::small_lamp_radius;
  return {radiance * Functions::small_lamp_boost, 4 * Functions::pi * radius * radius, radius};
}

bool PackLighting::isThin(int id) const {
  return id == Functions::block_plant || id == Functions::block_leaves;
}

bool PackLighting::isWater(int id) const { return id == Functions::block_water; }

int PackLighting::gloss(int id) const { return mirrors_ ? functions_->block_gloss(id) : 0; }

vec3 PackLighting::reflectGlossy(int gloss, const vec3& albedo, const vec3& n, const vec3& v,
                                 const vec3& l) const {
  return directLight_ == "NONE" ? vec3(0) : functions_->reflect_glossy(gloss, albedo, n, v, l);
}

vec3 PackLighting::diffuseShare(int gloss, const vec3& albedo, float cosine) const {
  return functions_->diffuse_share(gloss, albedo, cosine);
}

MirrorSample PackLighting::mirror(int gloss, const vec3& albedo, const vec3& n, const vec3& v,
                                  const vec2& u) const {
  const float alpha = functions_->gloss_alpha(gloss);
  const vec3 facet = functions_->ggx_facet(n, v, alpha, u);
  const vec3 direction = reflect(-v, facet);
  return {direction, functions_->gloss_fresnel(gloss, albedo, dot(v, facet)) *
                         functions_->ggx_masking(dot(n, direction), alpha)};
}

vec3 packToLinear(const vec3& color) { return PackLighting::Functions().to_linear(color); }

}  // namespace orris
