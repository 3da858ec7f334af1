// Smooth light and vanilla ambient occlusion of a face's corners.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "world/block_faces.h"
#include "world/light.h"

namespace orris {

/// Occlusion 0.2..1 and light in sixteenths of a level, 0..240.
struct CornerLight {
  float occlusion = 1, block = 0, sky = 0;
};

class FaceLighting {
 public:
  /// `occluding` by palette index: blocks that darken the corners beside them.
  FaceLighting(const BlockWorld& blocks, const LightLevels& light, std::vector<bool> occluding)
      : blocks_(blocks), light_(light), occluding_(std::move(occluding)) {}

  /// For the face's four corners, of the block in `cell`. As in the game: the mean of the four cells
  /// that touch a corner of the side, in front of it when the face is flush; corners of smaller
  /// faces are interpolated.
  std::array<CornerLight, 4> corners(const BlockFace& face, glm::ivec3 cell) const;

  CornerLight cellLight(glm::ivec3 cell) const;

 private:
  CornerLight corner(glm::ivec3 base, glm::ivec3 side1, glm::ivec3 side2) const;
  bool occludes(glm::ivec3 cell) const { return occluding_[blocks_.indexAt(cell)]; }

  const BlockWorld& blocks_;
  const LightLevels& light_;
  std::vector<bool> occluding_;
};

/// Which states of a palette darken their neighbours' corners.
std::vector<bool> occludingStates(const std::vector<BlockFacts>& facts);

}  // namespace orris
