#include <orris/plan/scene/gpu_vertex.h>

#include <GL/gl.h>

namespace orris {
namespace {

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

}  // namespace orris
