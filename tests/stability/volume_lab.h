// Our pack's shadow volumes beside the shadows that rays find.
#pragma once

#include "../shaderpack/pack_session.h"
#include <orris/image/mask_compare.h>
#include <orris/trace/reference_scene.h>
#include <orris/world/mesh/casters.h>

namespace orris::test {

/// Pixels on edges may differ, but no larger share of all than this.
inline constexpr double kEdgeShare = 0.002;

struct VolumeSetup {
  std::string blocks;  ///< list of a world.json
  int time = 6000;
  std::string method = "VOLUME_AUTO";
  std::string sunPathRotation = "-30.0";
  int size = 96;  ///< pixels, both ways
  glm::ivec3 box{32, 24, 32};
  OptionValues options{};
};

class VolumeLab {
 public:
  explicit VolumeLab(const VolumeSetup& setup);
  /// Draws from one point to another.
  void look(glm::dvec3 from, glm::dvec3 to, float fov = 70);
  /// 1 where the frame has light.
  ImageF drawn();
  /// The stencil at a pixel, (0, 0) top left.
  int count(int x, int y);
  ImageF reference() const;
  /// Of a lamp in the middle of a block.
  ImageF referenceOfLamp(const glm::ivec3& cell) const;
  MaskDifference difference();
  PackSession& session() { return session_; }

 private:
  ReferenceScene referenceScene() const;
  CasterSet casters() const;
  VolumeSetup setup_;
  std::string world_;
  PackSession session_;
};

}  // namespace orris::test
