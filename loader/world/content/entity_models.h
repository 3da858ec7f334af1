// Models of entities: boxes with generated textures, of our own.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace orris {

/// What a part of a model is drawn as.
enum class ModelLayer { Body, Translucent, Eyes };

/// A box in 1/16 block, y up, its front to +z; textures are named as in blocks.json.
struct ModelBox {
  glm::vec3 from{0}, to{0};      ///< relative to `pivot`
  glm::vec3 pivot{0};            ///< relative to the feet
  std::string_view side, front;  ///< "": as `side`; of eyes there is only a front
  ModelLayer layer = ModelLayer::Body;
  glm::vec3 turn{0};    ///< degrees around the pivot: x, then y, then z
  float swing = 0;      ///< degrees around x at the largest step; the sign says which leg
  bool armour = false;  ///< takes the glint
};

struct EntityModel {
  std::string_view kind;  ///< without "minecraft:"
  float scale = 1;
  std::span<const ModelBox> boxes;
  bool carriesItem = false;  ///< shows Entity::item: dropped items and frames
};

/// nullptr for a kind without a model.
const EntityModel* findEntityModel(std::string_view kind);
/// Kinds that have a model, sorted, without "minecraft:".
std::vector<std::string> entityKinds();
/// Textures of one model.
std::vector<std::string> texturesOf(const EntityModel& model);
/// Every texture that any content can use, for its tests.
std::vector<std::string> contentTextureNames();

/// The texture of cracks of a stage 0..9.
std::string crackTexture(int stage);

}  // namespace orris
