// The vertex that every geometry draw uses, and the attributes that a program can read of it. No GL calls.
// Contract: attributes.csv.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include <orris/pack/shader_pack.h>
#include <orris/world/mesh/block_mesh.h>

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

// A sample at exactly the far edge of a tile would read the next one; the game shrinks its quads'
// coordinates towards their middle for the same reason. 1/250 texel of a 16-texel tile.
inline constexpr float kUvInset = 1.0f / 2048;

VertexStyle vertexStyleOf(const ShaderPack& pack);

/// Where a named attribute lies in GpuVertex.
struct VertexAttribute {
  std::string_view name;
  int components;
  unsigned type;  ///< GL enum
  bool normalized;
  std::size_t offset;  ///< bytes
};
/// An attribute with one value for all vertices.
struct ConstantAttribute {
  std::string_view name;
  float value[4];
};
std::span<const VertexAttribute> vertexAttributes();
std::span<const ConstantAttribute> constantAttributes();
/// Every attribute name that the host sets, by a vertex or with one value for all.
const std::vector<std::string_view>& attributeNames();

}  // namespace orris
