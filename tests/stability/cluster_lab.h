// The pack's clusters alone: lights that a test makes, and what the pack's GLSL says of points.
#pragma once

#include <string>

#include "../shaderpack/pack_session.h"

namespace orris::test {

/// light_state of include/lights/lamps.glsl.
struct LightState {
  int lamps, lampsDropped, spilled, longest, entries, tables, grids;
};

/// Of the word length_word of light_bits (include/lights/list_length.glsl).
inline int lampsOfLength(float word) { return static_cast<int>(word) & 0xffff; }

LightState stateOf(PackSession& pack);

struct ClusterSetup {
  /// GLSL expression of `uint i`, a Light with its place relative to the eye (player space); see
  /// include/lights/lamp_light.glsl. random(i) is three numbers of light i and this frame.
  std::string light;
  int lights = 0;
  /// GLSL expression of `ivec2 pixel`, a vec4: what ClusterLab::probe gives. random(n) again, and
  /// seen(u) and compare(view), functions in cluster_lab.cpp.
  std::string probe;
  OptionValues options = {};
  int width = 64;              ///< of the window, and its height
  std::string functions = {};  ///< GLSL that `probe` may call
  std::function<void(PackTexts&)> change = {};
};

class ClusterLab {
 public:
  explicit ClusterLab(const ClusterSetup& setup) : pack_(sessionOf(setup)) {}
  /// Draws so many frames, each with other random numbers.
  void renderFrames(int count) { pack_.renderFrames(count); }
  /// Of the last frame, bottom row first: pixel (x, y) of `probe`.
  std::array<float, 4> probe(int x, int y);
  PackSession& pack() { return pack_; }

 private:
  static SessionSetup sessionOf(const ClusterSetup& setup);
  PackSession pack_;
};

}  // namespace orris::test
