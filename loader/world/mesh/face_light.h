// Smooth light and vanilla ambient occlusion of a face's corners.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include <orris/world/mesh/block_faces.h>
#include <orris/world/mesh/light.h>

namespace orris {

/// Occlusion 0.2..1 and light in sixteenths of a level, 0..240.
struct CornerLight {
  float occlusion = 1, block = 0, sky = 0;
};

/// Which states of a palette darken the corners beside them, by palette index.
std::vector<std::uint8_t> occludingStates(const std::vector<BlockFacts>& facts);

class FaceLighting {
 public:
  FaceLighting(const BlockWorld& blocks, const LightLevels& light,
               const std::vector<BlockFacts>& facts)
      : blocks_(blocks), light_(light), occluding_(occludingStates(facts)) {}

  /// For the face's four corners, of the block in `cell`. As in the game: the mean of the four cells
  /// that touch a corner of the side, in front of it when the face is flush; corners of smaller
  /// faces are interpolated.
  std::array<CornerLight, 4> corners(const BlockFace& face, glm::ivec3 cell) const;

 private:
  CornerLight cellLight(glm::ivec3 cell) const;
  CornerLight flatLight(glm::ivec3 cell) const;
  CornerLight fluidLight(const BlockFace& face, glm::ivec3 cell) const;

  const BlockWorld& blocks_;
  const LightLevels& light_;
  std::vector<std::uint8_t> occluding_;
};

}  // namespace orris
