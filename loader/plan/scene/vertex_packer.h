// From the faces of a mesh to the vertices that the driver gets.
#pragma once

#include <array>
#include <vector>

#include <orris/plan/scene/gpu_vertex.h>

namespace orris {

/// Of one mesh, which must outlive it, as must `blockIds`: by palette index, mc_Entity.x.
class VertexPacker {
 public:
  VertexPacker(const BlockMesh& mesh, const std::vector<int>& blockIds, const VertexStyle& style);
  /// Those of one section, `section.count` from `out` on.
  void pack(const MeshSection& section, GpuVertex* out) const;

 private:
  /// What faces of a shape share.
  struct ShapeVertices {
    std::array<GpuVertex, 4> vertices;
    float shade = 1;  ///< of its direction
  };
  static ShapeVertices sharedBy(const FaceShape& shape, const VertexStyle& style);
  GpuVertex vertex(const MeshFace& face, std::size_t corner, bool blockEntity) const;

  const BlockMesh& mesh_;
  const std::vector<int>& blockIds_;
  VertexStyle style_;
  std::vector<ShapeVertices> shapes_;
};

}  // namespace orris
