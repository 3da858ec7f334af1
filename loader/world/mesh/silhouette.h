// Shadow volumes of a set of casters: sides on the boundary of the faces that make them, and caps.
//
// A face makes a volume, the space behind it as the light sees it; a point is in shadow when it lies
// in at least one. Faces of one kind that share edges make one volume without walls between them: an
// edge counts +1 in one direction and -1 in the other (Kim, Kim and Turk 2008), and what is left
// bounds the volume. Nothing here needs closed meshes or edges of two faces.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include <orris/world/mesh/casters.h>

namespace orris {

/// w 1: a lamp, relative to CasterSet::origin; w 0: the direction to a distant light, unit.
using VolumeLight = glm::vec4;

/// Does the face make a volume? Faces of solids do that the light cannot see: what then coincides
/// with the caps is dark anyway. Of leaves and plants it is those that the light sees, since what is
/// right behind them shows through their holes and lies in their shadow.
bool makesVolume(const CasterFace& face, const VolumeLight& light);

struct VolumeMesh {
  /// Homogeneous, relative to CasterSet::origin; w 0 is at infinity, away from the light.
  std::vector<glm::vec4> vertices;
  /// Triangles, counter-clockwise as seen from outside of the volume: sides, then caps.
  std::vector<std::uint32_t> indices;
  /// The first of them: sides in planes of blocks that the light lies in, where one volume may end and
  /// the next begin.
  std::uint32_t alongIndices = 0;
  std::uint32_t sideIndices = 0;  ///< how many of them are sides
};

struct VolumeOptions {
  /// Closed volumes. Else open ones, for counts between eye and surface: nothing is seen through the
  /// caps of solids, so only those of other casters are there.
  bool closed = false;
  /// Takes only some faces; all when empty.
  std::function<bool(const CasterFace&)> takes = {};
};

/// Sides end where corners of faces lie: no edge meets another in a T, neither of caps nor of the faces
/// that are seen, since the rasteriser would leave cracks there.
VolumeMesh buildVolumes(const CasterSet& casters, const VolumeLight& light,
                        const VolumeOptions& options);

}  // namespace orris
