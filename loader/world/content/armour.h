// What figures wear: pieces of armour, boxes over those of the player's model and the stand's.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <orris/world/content/content.h>
#include <orris/world/content/entity_models.h>

namespace orris {

enum class ArmourSlot { Head, Chest, Legs, Feet };

/// An item that is worn.
struct ArmourPiece {
  ArmourSlot slot = ArmourSlot::Head;
  std::string_view skin;     ///< EntityTexture::name of the slot and the material
  glm::vec3 color{1};        ///< of what our textures show, linear factor
  glm::vec3 skinColor{1};    ///< of what the game's texture shows: only leather is grey there, and takes a dye
  bool takesDye = false;
};

/// By the end of its name, as "minecraft:iron_helmet"; one of an unknown material looks like iron. nullopt: nothing that
/// figures wear.
std::optional<ArmourPiece> armourPieceOf(std::string_view item);

struct WornPiece {
  std::string item;
  ArmourPiece piece;
};
/// What an entity wears, as far as its model shows it.
std::vector<WornPiece> wornBy(const Entity& entity);

/// A part of the pieces of a slot, around a figure that stands.
struct ArmourPart {
  ArmourSlot slot;
  ModelBox box;
  BoxSkin skin;  ///< without a texture: that is the piece's
};
std::span<const ArmourPart> armourParts();

}  // namespace orris
