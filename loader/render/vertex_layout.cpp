#include "render/vertex_layout.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>

#include "gl/functions.h"

namespace orris {
namespace {

// A sample at exactly the far edge of a tile would read the next one; the game shrinks its quads'
// coordinates towards their middle for the same reason. 1/250 texel of a 16-texel tile.
constexpr float kUvInset = 1.0f / 2048;

std::int8_t snorm(float v) {
  return static_cast<std::int8_t>(std::lround(std::clamp(v, -1.0f, 1.0f) * 127));
}

// The game's fixed shading of faces: up, down, north/south, east/west.
float directionalShade(const glm::vec3& n) {
  if (n.y > 0.5f) return 1.0f;
  if (n.y < -0.5f) return 0.5f;
  return std::abs(n.z) > std::abs(n.x) ? 0.8f : 0.6f;
}

void setColor(GpuVertex& out, const BlockVertex& in, const VertexStyle& style) {
  const float shade = style.oldLighting ? directionalShade(in.normal) : 1.0f;
  const float rgb = style.separateAo ? shade : shade * static_cast<float>(in.tint.a) / 255;
  for (int i = 0; i < 3; ++i)
    out.color[i] = static_cast<std::uint8_t>(std::lround(static_cast<float>(in.tint[i]) * rgb));
  out.color[3] = style.separateAo ? in.tint.a : 255;
}

/// Where a named attribute lives in GpuVertex.
struct AttributeRow {
  std::string_view name;
  int components;
  unsigned type;
  bool normalized;
  size_t offset;
};
constexpr AttributeRow kAttributes[] = {
    {"vaPosition", 3, GL_FLOAT, false, offsetof(GpuVertex, position)},
    {"vaUV0", 2, GL_FLOAT, false, offsetof(GpuVertex, uv)},
    {"vaUV2", 2, GL_SHORT, false, offsetof(GpuVertex, light)},
    {"vaColor", 4, GL_UNSIGNED_BYTE, true, offsetof(GpuVertex, color)},
    {"vaNormal", 3, GL_BYTE, true, offsetof(GpuVertex, normal)},
    {"mc_Entity", 2, GL_INT, false, offsetof(GpuVertex, entity)},
    {"mc_midTexCoord", 2, GL_FLOAT, false, offsetof(GpuVertex, midUv)},
    {"at_tangent", 4, GL_BYTE, true, offsetof(GpuVertex, tangent)},
    {"at_midBlock", 4, GL_BYTE, false, offsetof(GpuVertex, midBlock)},
};
/// Constant values of attributes that this geometry does not vary.
struct ConstantRow {
  std::string_view name;
  float value[4];
};
constexpr ConstantRow kConstants[] = {
    {"vaUV1", {0, 10, 0, 1}}, {"mc_chunkFade", {-1, 0, 0, 1}}, {"at_velocity", {0, 0, 0, 1}}};

bool isIntegerAttribute(unsigned type) {
  static constexpr unsigned kTypes[] = {
      GL_INT,          GL_INT_VEC2,          GL_INT_VEC3,          GL_INT_VEC4,
      GL_UNSIGNED_INT, GL_UNSIGNED_INT_VEC2, GL_UNSIGNED_INT_VEC3, GL_UNSIGNED_INT_VEC4};
  return std::find(std::begin(kTypes), std::end(kTypes), type) != std::end(kTypes);
}

const void* pointer(size_t offset) { return reinterpret_cast<const void*>(offset); }

void setConstant(const gl::ActiveVariable& attribute) {
  float value[4] = {0, 0, 0, 1};
  for (const ConstantRow& row : kConstants)
    if (row.name == attribute.name) std::copy(row.value, row.value + 4, value);
  if (isIntegerAttribute(attribute.type))
    gl::VertexAttribI4i(attribute.location, static_cast<int>(value[0]), static_cast<int>(value[1]),
                        static_cast<int>(value[2]), static_cast<int>(value[3]));
  else
    gl::VertexAttrib4f(attribute.location, value[0], value[1], value[2], value[3]);
}

void bindGeneric(const gl::ActiveVariable& attribute) {
  const auto* row = std::find_if(std::begin(kAttributes), std::end(kAttributes),
                                 [&](const AttributeRow& r) { return r.name == attribute.name; });
  if (row == std::end(kAttributes)) return setConstant(attribute);
  gl::EnableVertexAttribArray(attribute.location);
  if (isIntegerAttribute(attribute.type))
    gl::VertexAttribIPointer(attribute.location, row->components, row->type, sizeof(GpuVertex),
                             pointer(row->offset));
  else
    gl::VertexAttribPointer(attribute.location, row->components, row->type,
                            row->normalized ? GL_TRUE : GL_FALSE, sizeof(GpuVertex),
                            pointer(row->offset));
}

void bindTexCoord(int unit, int components, unsigned type, size_t offset) {
  gl::ClientActiveTexture(GL_TEXTURE0 + unit);
  gl::EnableClientState(GL_TEXTURE_COORD_ARRAY);
  gl::TexCoordPointer(components, type, sizeof(GpuVertex), pointer(offset));
}

}  // namespace

const std::vector<std::string_view>& attributeNames() {
  static const std::vector<std::string_view> kNames = [] {
    std::vector<std::string_view> names;
    for (const AttributeRow& row : kAttributes) names.push_back(row.name);
    for (const ConstantRow& row : kConstants) names.push_back(row.name);
    return names;
  }();
  return kNames;
}

std::vector<GpuVertex> packVertices(const BlockMesh& mesh, const std::vector<int>& blockIds,
                                    const VertexStyle& style) {
  std::vector<GpuVertex> out(mesh.vertices.size());
  for (size_t i = 0; i < out.size(); ++i) {
    const BlockVertex& in = mesh.vertices[i];
    GpuVertex& v = out[i];
    for (int k = 0; k < 3; ++k) {
      v.position[k] = in.position[k];
      v.normal[k] = snorm(in.normal[k]);
    }
    for (int k = 0; k < 4; ++k) {
      v.tangent[k] = snorm(in.tangent[k]);
      v.midBlock[k] = in.midBlock[k];
    }
    for (int k = 0; k < 2; ++k) {
      v.uv[k] = in.uv[k] + (in.midUv[k] - in.uv[k]) * kUvInset;
      v.midUv[k] = in.midUv[k];
      v.light[k] = in.light[k];
    }
    v.entity[0] = in.state < blockIds.size() ? blockIds[in.state] : -1;
    v.entity[1] = in.fluid != 0 ? 1 : -1;
    setColor(v, in, style);
  }
  // The game's vertices of block entities have neither.
  for (const MeshSection& section : mesh.sections) {
    if (section.layer != RenderLayer::BlockEntity) continue;
    for (size_t i = section.first; i < section.first + section.count; ++i) {
      out[i].entity[0] = out[i].entity[1] = -1;
      std::fill(std::begin(out[i].midBlock), std::end(out[i].midBlock), std::int8_t{0});
    }
  }
  return out;
}

void bindVertices(const gl::Program& program) {
  // Compatibility arrays are cheap when unused, so all are set; generic ones as the program asks.
  gl::EnableClientState(GL_VERTEX_ARRAY);
  gl::VertexPointer(3, GL_FLOAT, sizeof(GpuVertex), pointer(offsetof(GpuVertex, position)));
  gl::EnableClientState(GL_NORMAL_ARRAY);
  gl::NormalPointer(GL_BYTE, sizeof(GpuVertex), pointer(offsetof(GpuVertex, normal)));
  gl::EnableClientState(GL_COLOR_ARRAY);
  gl::ColorPointer(4, GL_UNSIGNED_BYTE, sizeof(GpuVertex), pointer(offsetof(GpuVertex, color)));
  bindTexCoord(0, 2, GL_FLOAT, offsetof(GpuVertex, uv));
  bindTexCoord(1, 2, GL_SHORT, offsetof(GpuVertex, light));
  bindTexCoord(2, 2, GL_SHORT, offsetof(GpuVertex, light));
  bindTexCoord(3, 2, GL_FLOAT, offsetof(GpuVertex, midUv));
  for (const gl::ActiveVariable& attribute : program.attributes)
    if (attribute.location >= 0) bindGeneric(attribute);
}

void unbindVertices(const gl::Program& program) {
  for (const gl::ActiveVariable& attribute : program.attributes)
    if (attribute.location >= 0) gl::DisableVertexAttribArray(attribute.location);
  for (int unit = 3; unit >= 0; --unit) {
    gl::ClientActiveTexture(GL_TEXTURE0 + unit);
    gl::DisableClientState(GL_TEXTURE_COORD_ARRAY);
  }
  gl::DisableClientState(GL_COLOR_ARRAY);
  gl::DisableClientState(GL_NORMAL_ARRAY);
  gl::DisableClientState(GL_VERTEX_ARRAY);
}

void setChunkFade(const gl::Program& program) {
  for (const gl::ActiveVariable& attribute : program.attributes) {
    if (attribute.name == "mc_chunkFade" && attribute.location >= 0)
      gl::VertexAttrib4f(attribute.location, 1, 0, 0, 1);
  }
}

void setConstantColor(const gl::Program& program, const glm::vec4& color) {
  gl::DisableClientState(GL_COLOR_ARRAY);
  gl::Color4f(color.r, color.g, color.b, color.a);
  for (const gl::ActiveVariable& attribute : program.attributes) {
    if (attribute.name != "vaColor" || attribute.location < 0) continue;
    gl::DisableVertexAttribArray(attribute.location);
    gl::VertexAttrib4f(attribute.location, color.r, color.g, color.b, color.a);
  }
}

}  // namespace orris
