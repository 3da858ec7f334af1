// What casts shadows: the opaque faces of a mesh, for shadow volumes and for their reference.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include <orris/world/mesh/block_mesh.h>

namespace orris {

/// A face casts when it is not translucent and at least this share of its texels is opaque; then all
/// of it casts, as a volume knows no holes.
constexpr float kCasterCoverage = 0.5f;
/// Alpha below which a texel of a cutout texture is a hole: what Iris tests terrain with.
constexpr float kCasterAlpha = 0.1f;
/// Faces whose normal has a smaller cosine with the light lie along it and are neither lit nor turned away.
constexpr float kAlongLight = 1e-6f;

/// One quad, counter-clockwise as seen from the side its normal points to.
struct CasterFace {
  std::array<glm::vec3, 4> corners{};  ///< relative to CasterSet::origin, blocks
  glm::vec3 normal{0};
  /// Other surfaces may be seen through it or close behind it (leaves, plants, panes).
  bool seeThrough = false;
};

struct CasterSet {
  glm::ivec3 origin{0};  ///< middle of the mesh: coordinates stay small
  std::vector<CasterFace> faces;
};

/// The faces of `mesh` that cast, in its order.
CasterSet castersOf(const BlockMesh& mesh, const BlockAtlas& atlas);

/// Those that may keep the light of a lamp, which is in the middle of a block, from what is within its
/// range: its own faces do not.
CasterSet castersOfLamp(const CasterSet& casters, const glm::ivec3& cell, double range);

}  // namespace orris
