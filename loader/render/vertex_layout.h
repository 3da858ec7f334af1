// The vertex every geometry draw uses, and how a program's active attributes read it.
// Contract: attributes.csv.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "gl/program.h"
#include "world/mesh/block_mesh.h"

namespace orris {

/// What attributes.csv lists, in the types the game uses.
struct GpuVertex {
  float position[3] = {0, 0, 0};
  float uv[2] = {0, 0};
  float midUv[2] = {0, 0};
  std::int8_t normal[4] = {0, 0, 127, 0};
  std::int8_t tangent[4] = {127, 0, 0, 127};
  std::uint8_t color[4] = {255, 255, 255, 255};
  std::int16_t light[2] = {240, 240};
  std::int8_t midBlock[4] = {0, 0, 0, 0};
  std::int32_t entity[2] = {-1, -1};  ///< mc_Entity x and y
};
static_assert(sizeof(GpuVertex) == 56);

/// What of a pack changes vertex data.
struct VertexStyle {
  bool separateAo = false;   ///< ambient occlusion in alpha instead of multiplied into rgb
  bool oldLighting = false;  ///< directional shading baked into the colour
  bool operator==(const VertexStyle&) const = default;
};

/// Every attribute name that the host sets, by a vertex or with one value for all.
const std::vector<std::string_view>& attributeNames();

/// `blockIds[palette index]` is mc_Entity.x.
std::vector<GpuVertex> packVertices(const BlockMesh& mesh, const std::vector<int>& blockIds,
                                    const VertexStyle& style);

/// Points the active attributes of `program` at the bound GL_ARRAY_BUFFER of GpuVertex; attributes
/// the layout does not know get their contract default. Undo with unbindVertices.
void bindVertices(const gl::Program& program);
void unbindVertices(const gl::Program& program);
/// Chunks are there for long: mc_chunkFade is 1, not the -1 of what is no chunk. After bindVertices.
void setChunkFade(const gl::Program& program);
/// One colour for all vertices of the next draws, after bindVertices.
void setConstantColor(const gl::Program& program, const glm::vec4& color);

}  // namespace orris
