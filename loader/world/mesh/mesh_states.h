// What the entries of a world's palette look like to the mesher.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <orris/world/mesh/block_faces.h>
#include <orris/world/mesh/block_mesh.h>
#include <orris/world/resources/block_model.h>

namespace orris {

/// A part of a model: one of these, by weight.
struct MeshChoice {
  std::vector<std::shared_ptr<const std::vector<BlockFace>>> alternatives;
  std::vector<int> weights;
};

/// One palette entry, prepared.
struct MeshState {
  BlockFaces block;               ///< of a model: without faces
  std::vector<MeshChoice> parts;  ///< of a model
  bool multipart = false;
  std::vector<BlockFace> fluidSurface, fluidFull;  ///< under air, submerged in the same fluid
  /// Under air, by heading; empty without a texture of the flowing fluid.
  std::array<std::vector<BlockFace>, kFlowHeadings> flowing;
  std::string fluid;                               ///< name, "" = none
  float height = 0;
  std::uint16_t fluidState = 0;   ///< the palette index that fluid faces carry
  std::uint8_t coveredSides = 0;  ///< bit 1 << FaceDirection: wholly opaque
  bool cullsSame = false;
  bool hiddenByCubes = false;  ///< cubes on all sides hide every face

  bool hides(FaceDirection side) const { return coveredSides >> int(side) & 1; }
};

class MeshStates {
 public:
  /// `input` must outlive it.
  explicit MeshStates(const MeshInput& input);
  const MeshState& operator[](std::size_t index) const { return states_[index]; }
  /// By BlockFace::shape.
  std::vector<FaceShape> takeShapes() { return std::move(shapes_); }

 private:
  void addModel(MeshState& state, const BlockModel& model, bool emits);
  void addFluid(MeshState& state, const std::string& name, std::size_t index, float height);
  /// "" where no resource pack has one.
  std::string flowingTexture(const BlockFacts& facts) const;
  /// Gives each face the index of its shape.
  std::vector<BlockFace> withShapes(std::vector<BlockFace> faces);

  const MeshInput& input_;
  std::vector<MeshState> states_;
  std::vector<FaceShape> shapes_;
  std::map<std::pair<const std::vector<ModelFace>*, bool>,
           std::shared_ptr<const std::vector<BlockFace>>>
      modelFaces_;
};

}  // namespace orris
