// How the active attributes of a program read the vertices of plan/scene/gpu_vertex.h.
// Contract: attributes.csv.
#pragma once

#include <glm/glm.hpp>

#include <orris/gl/program.h>
#include <orris/plan/scene/gpu_vertex.h>

namespace orris {

/// Where the vertices lie in the bound GL_ARRAY_BUFFER.
struct VertexPlace {
  int stride = sizeof(GpuVertex);  ///< bytes from one GpuVertex to the next
  std::size_t offset = 0;          ///< bytes before the first
};

/// Points the active attributes of `program` at the bound GL_ARRAY_BUFFER of GpuVertex; attributes
/// the layout does not know get their contract default. Undo with unbindVertices.
void bindVertices(const gl::Program& program, const VertexPlace& place = {});
void unbindVertices(const gl::Program& program);
/// Chunks are there for long: mc_chunkFade is 1, not the -1 of what is no chunk. After bindVertices.
void setChunkFade(const gl::Program& program);
/// The game's overlay of what is hurt, or of what is not: vaUV1. After bindVertices.
void setOverlay(const gl::Program& program, bool hurt);
/// One colour for all vertices of the next draws, after bindVertices.
void setConstantColor(const gl::Program& program, const glm::vec4& color);

}  // namespace orris
