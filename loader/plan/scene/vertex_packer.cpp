#include <orris/plan/scene/vertex_packer.h>

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

/// Of a number from 0 to 255; lround() is a call.
std::uint8_t roundedByte(float v) { return static_cast<std::uint8_t>(static_cast<double>(v) + 0.5); }

}  // namespace

VertexPacker::VertexPacker(const BlockMesh& mesh, const std::vector<int>& blockIds,
                           const VertexStyle& style)
    : mesh_(mesh), blockIds_(blockIds), style_(style) {
  shapes_.reserve(mesh.shapes.size());
  for (const FaceShape& shape : mesh.shapes) shapes_.push_back(sharedBy(shape, style));
}

VertexPacker::ShapeVertices VertexPacker::sharedBy(const FaceShape& shape, const VertexStyle& style) {
  ShapeVertices shared;
  shared.shade = style.oldLighting && shape.shade ? directionalShade(shape.normal) : 1.0f;
  for (std::size_t i = 0; i < shared.vertices.size(); ++i) {
    GpuVertex& v = shared.vertices[i];
    for (int k = 0; k < 3; ++k) {
      v.position[k] = shape.corners[i][k];
      v.normal[k] = snorm(shape.normal[k]);
      v.midBlock[k] = shape.toMiddle[i][k];
    }
    for (int k = 0; k < 4; ++k) v.tangent[k] = snorm(shape.tangent[k]);
    for (int k = 0; k < 2; ++k) {
      v.uv[k] = shape.uv[i][k] + (shape.midUv[k] - shape.uv[i][k]) * kUvInset;
      v.midUv[k] = shape.midUv[k];
    }
  }
  return shared;
}

GpuVertex VertexPacker::vertex(const MeshFace& face, std::size_t corner, bool blockEntity) const {
  const ShapeVertices& shape = shapes_[face.shape];
  GpuVertex v = shape.vertices[corner];
  for (int k = 0; k < 3; ++k) v.position[k] += static_cast<float>(face.cell[k]);
  for (int k = 0; k < 2; ++k) v.light[k] = face.light[corner][k];
  const std::uint8_t occlusion = face.occlusion[corner];
  const float rgb =
      style_.separateAo ? shape.shade : shape.shade * static_cast<float>(occlusion) / 255;
  for (int i = 0; i < 3; ++i) v.color[i] = roundedByte(static_cast<float>(face.tint[i]) * rgb);
  v.color[3] = style_.separateAo ? occlusion : 255;
  // The game's vertices of block entities have neither.
  if (blockEntity) {
    std::fill(std::begin(v.midBlock), std::end(v.midBlock), std::int8_t{0});
    return v;
  }
  v.midBlock[3] = static_cast<std::int8_t>(face.emission);
  v.entity[0] = face.state < blockIds_.size() ? blockIds_[face.state] : -1;
  v.entity[1] = face.fluid != 0 ? 1 : -1;
  return v;
}

void VertexPacker::pack(const MeshSection& section, GpuVertex* out) const {
  const bool blockEntity = section.layer == RenderLayer::BlockEntity;
  for (std::uint32_t i = 0; i < section.count; ++i)
    out[i] = vertex(mesh_.faces[(section.first + i) / 4], i % 4, blockEntity);
}

}  // namespace orris
