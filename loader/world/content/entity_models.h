// Models of entities: boxes with generated textures, of our own.
#pragma once

#include <array>
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
  glm::vec3 turn{0};  ///< degrees around the pivot: x, then y, then z
  float swing = 0;    ///< degrees around x at the largest step; the sign says which leg
};

/// A texture of the game that models wear.
struct EntityTexture {
  std::string_view name;                  ///< in an atlas
  std::array<std::string_view, 2> files;  ///< below "textures", of the newest game first; the other may be ""
  int width = 64;                         ///< texels that the unwrapping counts; it may have more
};

/// How the box was unwrapped.
enum class BoxFold {
  Standing,
  Mirrored,  ///< left and right are exchanged, as of a left arm that wears the right one's
  Lying,     ///< standing, and then laid on its front, as the body of a cow
};

/// Where a texture has the sides of a box.
struct BoxSkin {
  std::string_view texture;  ///< EntityTexture::name; "": the box wears only ours
  int u = kNone, v = 0;      ///< top left of the unwrapped box
  BoxFold fold = BoxFold::Standing;
  glm::ivec3 size{0};  ///< that was unwrapped, upright; 0: of the box itself

  static constexpr int kNone = -1;  ///< the box is not there where the texture is
};

struct EntityModel {
  std::string_view kind;  ///< without "minecraft:"
  float scale = 1;
  /// One without textures is seen only in its skin.
  std::span<const ModelBox> boxes;
  bool carriesItem = false;          ///< shows Entity::item: dropped items and frames
  std::span<const BoxSkin> skins{};  ///< one for each box, or none
  std::array<int, 2> arms = {-1, -1};  ///< boxes of the right and the left arm that hold items; -1: none
  bool wearsArmour = false;            ///< armour.h
};

/// nullptr for a kind without a model.
const EntityModel* findEntityModel(std::string_view kind);
/// Kinds that have a model, sorted, without "minecraft:".
std::vector<std::string> entityKinds();
/// Textures of one model.
std::vector<std::string> texturesOf(const EntityModel& model);
/// Textures of the game for `model`.
std::vector<const EntityTexture*> skinsOf(const EntityModel& model);
/// nullptr: "" or no such texture.
const EntityTexture* findEntityTexture(std::string_view name);
/// Coordinates of a side's corners (top left, bottom left, bottom right, top right seen from outside) in a texture, in
/// its counted texels. `side` in the order of FaceDirection.
std::array<glm::vec2, 4> skinUv(const ModelBox& box, const BoxSkin& skin, int side);
/// Every texture that any content can use, for its tests.
std::vector<std::string> contentTextureNames();

/// The texture of cracks of a stage 0..9.
std::string crackTexture(int stage);

}  // namespace orris
