// Which of a model's alternatives stands where: the game's choice, a function of the place alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace orris {

/// The game (1.13 to 1.21.4): Mth.getSeed, LegacyRandomSource, WeightedBakedModel, MultiPartBakedModel.
class ModelDice {
 public:
  /// `multipart`: parts throw with a seed that the block's seed gives.
  ModelDice(glm::ivec3 cell, bool multipart);
  /// Index into `weights`, each above 0; the same for equal weights at one place.
  std::size_t choose(const std::vector<int>& weights) const;

 private:
  std::int32_t thrown_ = 0;
};

}  // namespace orris
