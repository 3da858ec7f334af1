// The pack's propagation alone, on a small volume whose light and walls a test prepares.
#pragma once

#include <string>

#include "../shaderpack/pack_session.h"

namespace orris::test {

constexpr int kLabSize = 32;
/// A lamp in the middle.
constexpr const char* kLampBlock = R"({"block": "glowstone", "at": [16, 16, 16]})";
/// SKY_STRENGTH that makes the night's zenith 1 in red.
constexpr const char* kSkyOfOne = "500.0";

struct LabSetup {
  /// Operations of world.json, comma-separated; block (x, y, z) of the world is that cell of the
  /// volume.
  std::string blocks = {};
  /// Of world.json. A world whose last block goes loses its light, too, as its programs change.
  std::string events = {};
  /// GLSL expression of `ivec3 cell`, a vec3: the light that the volume holds before step
  /// `initialStep`; empty for none.
  std::string initial = {};
  int initialStep = 0;
  /// Light that leaves the volume comes in on the other side, where the pack has darkness.
  bool periodic = false;
  int width = 8;  ///< of the window, and its height
  OptionValues options = {};
  /// Options by values that their lists need not hold.
  OptionValues constants = {};
  std::function<void(PackTexts&)> change = {};
};

/// Eye in the cell at half the volume's size, still; night; one step a frame; nothing is drawn but
/// the volume.
class Lab {
 public:
  explicit Lab(const LabSetup& setup) : pack_(sessionOf(setup)) {}
  void step(int count = 1) { pack_.renderFrames(count); }
  CellField light() { return pack_.light({kLabSize, kLabSize}); }
  CellField voxels() { return pack_.voxels({kLabSize, kLabSize}); }
  PackSession& pack() { return pack_; }

 private:
  static SessionSetup sessionOf(const LabSetup& setup);
  PackSession pack_;
};

/// Changes the pack so that it draws nothing but the volume.
void runOnlyTheVolume(PackTexts& files);

/// Changes the pack so that the light is stored in full floats: of what a half float cannot hold some
/// drivers store the largest and others infinity.
void storeFullFloats(PackTexts& files);

/// Vertex shader of a fullscreen program.
extern const char* const kFullscreen;

}  // namespace orris::test
