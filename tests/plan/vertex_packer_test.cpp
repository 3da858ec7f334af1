// Vertices as the driver gets them. The other attributes: tests/render/contract_gl_test.cpp.
#include <orris/plan/scene/vertex_packer.h>

#include <gtest/gtest.h>

namespace orris {
namespace {

/// The red of a white face to the east that is occluded to the half.
int redOf(bool shade, const VertexStyle& style) {
  BlockMesh mesh;
  mesh.shapes = {FaceShape{.normal = {1, 0, 0}, .tangent = {0, 0, -1, 1}, .shade = shade}};
  MeshFace face{};
  face.tint = glm::u8vec3(255);
  face.occlusion.fill(128);
  mesh.faces = {face};
  mesh.sections = {{glm::ivec3(0), RenderLayer::Solid, 0, 4}};
  const std::vector<int> blockIds = {-1};
  std::array<GpuVertex, 4> packed;
  VertexPacker(mesh, blockIds, style).pack(mesh.sections[0], packed.data());
  return packed.front().color[0];
}

TEST(VertexPacker, faces_are_darkened_by_direction_with_old_lighting_where_the_model_is_shaded) {
  EXPECT_EQ(redOf(true, {.separateAo = true}), 255);
  EXPECT_EQ(redOf(true, {.separateAo = true, .oldLighting = true}), 153);
  EXPECT_EQ(redOf(false, {.separateAo = true, .oldLighting = true}), 255);
  EXPECT_EQ(redOf(true, {}), 128);
}

}  // namespace
}  // namespace orris
