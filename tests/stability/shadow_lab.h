// The pack's light alone: what its GLSL says of points of the world that a test chooses, whatever the
// camera sees.
#pragma once

#include <string>

#include "../shaderpack/pack_session.h"

namespace orris::test {

/// Blocks of a texel of the map, 2 * 64 / 1024, and of its depth.
inline constexpr double kTexel = 0.125, kDepth = 256 - 0.05;

struct ShadowSetup {
  /// Text of a whole world.json instead, whose `"time": 700` is set by `sun`; else:
  std::string world = {};
  /// Operations of world.json in a world of 64 x 32 x 64 blocks whose floor's top is y = 2.
  std::string blocks = {};
  /// Angle between the sun, which stands in the east, and up; degrees, 1 to 89.
  double sun = 45;
  /// GLSL expression of `ivec2 pixel`, a vec4. lit(world, normal) is the share of sunlight there.
  std::string probe = {};
  std::string functions = {};  ///< GLSL that the expression may call
  OptionValues options = {};
  /// Options by values that their lists need not hold.
  OptionValues constants = {};
  std::function<void(PackTexts&)> change = {};
  int width = 64, height = 1;
};

class ShadowLab {
 public:
  explicit ShadowLab(const ShadowSetup& setup) : pack_(sessionOf(setup)) {}
  /// Draws a frame; pixel (x, y) of the probe, bottom row first.
  void draw(int frames = 1);
  std::array<float, 4> at(int x, int y = 0) const;
  PackSession& pack() { return pack_; }

 private:
  static SessionSetup sessionOf(const ShadowSetup& setup);
  PackSession pack_;
  ImageF image_;
};

/// Ticks at which the sun is nearest to that angle from up, in the morning.
int timeOfSun(double degrees);

/// The eye of the world, 4 blocks over its floor.
inline constexpr glm::dvec3 kShadowEye{32.5, 6, 32.5};

}  // namespace orris::test
