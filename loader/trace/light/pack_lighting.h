// Sun, sky, lamps and reflection of the reference pack, on the CPU. The functions are the pack's own
// GLSL: the build turns its text into C++ (cmake/OrrisPackLighting.cmake), so that the frame and the
// reference cannot come to differ.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <map>
#include <memory>
#include <string>

namespace orris {

/// Every file of the reference pack, "/settings.glsl" and so on, as built into the program.
const std::map<std::string, std::string>& referencePackFiles();

/// What the functions of the pack read.
struct LightingInput {
  std::map<std::string, std::string> options;  ///< those of settings.glsl; "" or absent: 0
  glm::vec3 sunDirection{0, 1, 0};             ///< unit, world axes
  glm::vec3 lightDirection{0, 1, 0};           ///< to the sun or, at night, the moon
  float rainStrength = 0;
};

/// How a lamp lights: as a block that fills its cell, or as a ball in it.
struct LampLight {
  glm::vec3 radiance{0};
  float area = 6;    ///< of the shape that has this radiance, in square blocks
  float radius = 0;  ///< of a ball in the middle of its cell; 0: the block's own faces shine
};

/// A direction and the weight of the light from there; 0 below the surface.
struct MirrorSample {
  glm::vec3 direction{0}, weight{0};
};

class PackLighting {
 public:
  explicit PackLighting(const LightingInput& input);
  ~PackLighting();
  PackLighting(PackLighting&&) noexcept;
  PackLighting& operator=(PackLighting&&) noexcept;

  glm::vec3 lightDirection() const { return lightDirection_; }
  /// On a plane that faces the sun or the moon.
  glm::vec3 lightIrradiance() const { return lightIrradiance_; }
  /// Radiance from a direction, unit, without sun, moon and stars.
  glm::vec3 skyRadiance(const glm::vec3& direction) const;
  /// Radiance toward `v` for irradiance 1 on a plane that faces `l`; 0 with DIRECT_LIGHT=NONE.
  glm::vec3 reflectDirect(const glm::vec3& albedo, const glm::vec3& n, const glm::vec3& v,
                          const glm::vec3& l) const;
  /// Radiance of a lit surface as drawn: albedo times this, for light level 0..15.
  float emissionScale(int level) const;
  /// The light of a block for the pack's rays: `id` of block.properties, `mean` its linear colour.
  LampLight lampLight(int id, int level, const glm::vec3& mean) const;
  /// Plants and leaves: lit from both sides.
  bool isThin(int id) const;
  bool isWater(int id) const;
  /// Class of a block that mirrors, 0 of a diffuse one; with GI_GLOSSY.
  int gloss(int id) const;
  /// As reflectDirect, of a block of that class.
  glm::vec3 reflectGlossy(int gloss, const glm::vec3& albedo, const glm::vec3& n,
                          const glm::vec3& v, const glm::vec3& l) const;
  /// Share of the light from elsewhere that its diffuse base reflects.
  glm::vec3 diffuseShare(int gloss, const glm::vec3& albedo, float cosine) const;
  /// One direction that it mirrors toward `v`, and what light from there is multiplied by; `u` in 0..1.
  MirrorSample mirror(int gloss, const glm::vec3& albedo, const glm::vec3& n, const glm::vec3& v,
                      const glm::vec2& u) const;

  struct Functions;  ///< the pack's text

 private:
  std::unique_ptr<Functions> functions_;
  glm::vec3 lightDirection_{0}, lightIrradiance_{0};
  std::string directLight_ = "PHONG";
  bool mirrors_ = false;
};

/// Textures to light, with the pack's to_linear.
glm::vec3 packToLinear(const glm::vec3& color);

}  // namespace orris
