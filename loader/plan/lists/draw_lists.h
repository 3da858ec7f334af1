// Everything of a frame besides blocks, sky and clouds, as quads by kind of program: a value that a
// renderer draws and an engine could make itself. No GL in it.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include <orris/plan/schedule/geometry.h>
#include <orris/plan/scene/gpu_vertex.h>
#include <orris/plan/scene/scene_data.h>
#include <orris/plan/scene/shapes.h>

namespace orris {

/// Quads with one set of values of the uniforms that change by draw. Contract: uniforms.csv "draw".
struct ContentDraw {
  Geometry geometry = Geometry::Entities;
  QuadRange range;
  std::string entity{};  ///< entityId, by name; "" for none
  std::string item{};    ///< currentRenderedItemId, by name; "" for none
  BlockState block{};    ///< blockEntityId; name "" for none
  glm::vec4 entityColor{0};
  glm::vec3 middle{0};  ///< of an entity, relative to the camera
};

/// Positions are relative to the camera in the world's axes; those of hands in view space.
struct DrawLists {
  std::vector<GpuVertex> vertices;
  std::vector<ContentDraw> draws;
};

/// `state` is that of the frame.
DrawLists buildDrawLists(const SceneData& scene, const FrameState& state);

}  // namespace orris
