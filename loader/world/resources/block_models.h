// The models of the states of a palette.
#pragma once

#include <map>
#include <vector>

#include <orris/world/blocks/block_world.h>
#include <orris/world/resources/block_model.h>
#include <orris/world/resources/blockstate_json.h>
#include <orris/world/resources/model_faces.h>

namespace orris {

class BlockModels {
 public:
  BlockModels(const ResourceStack& resources, Diagnostics& diagnostics)
      : resources_(resources), library_(resources, diagnostics), diagnostics_(diagnostics) {}

  /// Without parts: the packs have no blockstates file for it, or (warnings) none that gives it a face.
  BlockModel modelOf(const BlockState& state);
  /// One warning of the models that no pack has; after all states were asked for.
  void warnOfMissing();

 private:
  const BlockStateFile* fileOf(const std::string& block);
  void addPart(const BlockStateFile& file, const ModelUses& uses, BlockModel& model);
  /// nullptr: the model cannot be used.
  ModelFaces facesOfUse(const BlockStateFile& file, const ModelUse& use);

  const ResourceStack& resources_;
  ModelLibrary library_;
  Diagnostics& diagnostics_;
  std::map<std::string, std::optional<BlockStateFile>> files_;
  std::map<std::tuple<std::string, int, int, bool>, ModelFaces> faces_;
  std::size_t faceCount_ = 0;  ///< in faces_
};

}  // namespace orris
