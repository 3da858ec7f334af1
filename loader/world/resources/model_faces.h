// From a model's elements to the quads of a block, turned as its blockstates file says.
#pragma once

#include <orris/world/resources/block_model.h>
#include <orris/world/resources/model_library.h>

namespace orris {

/// How a model is placed: about the middle of the block, first about x, then about y.
struct ModelTurn {
  int x = 0, y = 0;     ///< degrees, multiples of 90
  bool uvLock = false;  ///< textures stay as they lie
};

/// Faces without a texture get "missing".
std::vector<ModelFace> facesOf(const ResolvedModel& model, const ModelTurn& turn);

}  // namespace orris
