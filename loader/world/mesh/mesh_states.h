// The palette's entries prepared for meshes: the faces that each block state and its fluid have.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "world/mesh/block_faces.h"
#include "world/mesh/block_mesh.h"
#include "world/resources/block_look.h"

namespace orris {

/// A part of a model: one of these, by weight.
struct MeshChoice {
  std::vector<std::shared_ptr<const std::vector<BlockFace>>> alternatives;
  std::vector<int> weights;
};

/// One palette entry, prepared.
struct MeshState {
  BlockFaces block;               // of a model: without faces
  std::vector<MeshChoice> parts;  // of a model
  bool multipart = false;
  std::vector<BlockFace> fluidSurface, fluidFull;  // under air, submerged in the same fluid
  std::string fluid;                               // name, "" = none
  float height = 0;
  std::uint16_t fluidState = 0;   // the palette index that fluid faces carry
  std::uint8_t coveredSides = 0;  // bit 1 << FaceDirection: wholly opaque
  bool cullsSame = false;

  bool hides(FaceDirection side) const { return coveredSides >> int(side) & 1; }
};

/// What the palette's entries look like, for all sections.
class MeshStates {
 public:
  explicit MeshStates(const MeshInput& input);
  const MeshState& operator[](std::size_t index) const { return states_[index]; }

 private:
  void addModel(MeshState& state, const BlockModel& model, bool emits);
  void addFluid(MeshState& state, const std::string& name, std::size_t index, float height);

  const MeshInput& input_;
  std::vector<MeshState> states_;
  std::map<std::pair<const std::vector<ModelFace>*, bool>,
           std::shared_ptr<const std::vector<BlockFace>>>
      modelFaces_;
};

}  // namespace orris
