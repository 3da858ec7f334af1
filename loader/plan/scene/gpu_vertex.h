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

// How far texture coordinates lie towards the middle of their quad. Rasterisers move corners by up to 1/512 of a pixel, so
// that a sample at the edge of a small quad would read the next tile. The game moves them by 4 texels over the size of
// its atlas (TextureAtlasSprite.uvShrinkRatio), which is 1024.
inline constexpr float kUvInset = 1.0f / 256;

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
