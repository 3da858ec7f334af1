// What a resource pack makes of a block state: quads in the unit cube, chosen by the block's place.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <orris/world/blocks/block_facts.h>

namespace orris {

/// One quad. Corners are counter-clockwise seen from the side that its normal points to.
struct ModelFace {
  std::array<glm::vec3, 4> corners{};  ///< blocks; may leave the block by one on each side
  std::array<glm::vec2, 4> uv{};       ///< of the texture, 0..1, v down
  std::string texture;                 ///< "minecraft:block/stone"
  glm::vec3 normal{0};
  glm::vec4 tangent{0};                         ///< u direction, w handedness
  FaceDirection direction = FaceDirection::Up;  ///< nearest to the normal
  std::optional<FaceDirection> cull{};          ///< the neighbour there may hide it
  int tintIndex = -1;                           ///< below 0: not tinted
  bool smooth = true;                           ///< has ambient occlusion
  bool shade = true;                            ///< the game darkens it by its direction
};
using ModelFaces = std::shared_ptr<const std::vector<ModelFace>>;

struct ModelAlternative {
  ModelFaces faces;
  int weight = 1;
};

/// One of its alternatives is drawn (mesh/model_choice.h).
struct ModelChoice {
  std::vector<ModelAlternative> alternatives;
  int totalWeight = 0;
};

/// All parts are drawn. Without any, the block keeps the look of its facts.
struct BlockModel {
  std::vector<ModelChoice> parts;
  bool multipart = false;  ///< the game's random numbers of the parts start differently
};

}  // namespace orris
