#include <orris/plan/scene/gpu_vertex.h>

#include <GL/gl.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace orris {
namespace {

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
  const float shade = style.oldLighting && in.shade ? directionalShade(in.normal) : 1.0f;
  const float rgb = style.separateAo ? shade : shade * static_cast<float>(in.tint.a) / 255;
  for (int i = 0; i < 3; ++i)
    out.color[i] = static_cast<std::uint8_t>(std::lround(static_cast<float>(in.tint[i]) * rgb));
  out.color[3] = style.separateAo ? in.tint.a : 255;
}

void setVertex(GpuVertex& v, const BlockVertex& in, const std::vector<int>& blockIds,
               const VertexStyle& style) {
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

constexpr VertexAttribute kAttributes[] = {
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
constexpr ConstantAttribute kConstants[] = {
    {"vaUV1", {0, 10, 0, 1}}, {"mc_chunkFade", {-1, 0, 0, 1}}, {"at_velocity", {0, 0, 0, 1}}};

}  // namespace

VertexStyle vertexStyleOf(const ShaderPack& pack) {
  return {pack.properties.flag("separateAo", false), pack.properties.flag("oldLighting", false)};
}

std::span<const VertexAttribute> vertexAttributes() { return kAttributes; }
std::span<const ConstantAttribute> constantAttributes() { return kConstants; }

const std::vector<std::string_view>& attributeNames() {
  static const std::vector<std::string_view> kNames = [] {
    std::vector<std::string_view> names;
    for (const VertexAttribute& row : kAttributes) names.push_back(row.name);
    for (const ConstantAttribute& row : kConstants) names.push_back(row.name);
    return names;
  }();
  return kNames;
}

std::vector<GpuVertex> packVertices(const BlockMesh& mesh, const MeshSection& section,
                                    const std::vector<int>& blockIds, const VertexStyle& style) {
  std::vector<GpuVertex> out(section.count);
  for (size_t i = 0; i < out.size(); i += 4) {
    const std::array<BlockVertex, 4> quad = mesh.quad(section.first + i);
    for (size_t k = 0; k < quad.size(); ++k) setVertex(out[i + k], quad[k], blockIds, style);
  }
  if (section.layer != RenderLayer::BlockEntity) return out;
  // The game's vertices of block entities have neither.
  for (GpuVertex& v : out) {
    v.entity[0] = v.entity[1] = -1;
    std::fill(std::begin(v.midBlock), std::end(v.midBlock), std::int8_t{0});
  }
  return out;
}

}  // namespace orris
