// The clouds of the game: a layer of cells, flat ("fast") or boxes ("fancy"), in a pattern of our own
// that repeats. Contract: programs.csv gbuffers_clouds, properties.csv clouds.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include <orris/plan/frame/frame_state.h>
#include <orris/plan/scene/shapes.h>

namespace orris {

/// The faces of one direction, and how bright the game draws them.
struct CloudPart {
  float shade = 1;
  QuadRange range;
};

/// One period of the pattern, in blocks from its corner; y 0 is the layer's lower side.
struct CloudMesh {
  std::vector<GpuVertex> vertices;
  std::vector<CloudPart> parts;
};
CloudMesh buildClouds(bool fancy);

/// Where, relative to the camera, periods of the pattern lie that the view frustum can reach.
std::vector<glm::vec3> cloudOrigins(const FrameState& state);

/// Blocks that the clouds have moved. Uniform cloudTime.
float cloudTimeOf(const FrameState& state);

/// Colour of the clouds by time and rain; alpha is the game's 0.8.
glm::vec4 cloudColor(const FrameState& state);

}  // namespace orris
