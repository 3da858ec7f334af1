// What the resource packs make of items.
#pragma once

#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <string>

#include <orris/world/blocks/block_facts.h>
#include <orris/world/items/item_tints.h>
#include <orris/world/resources/block_model.h>
#include <orris/world/resources/model_json.h>
#include <orris/world/resources/look_textures.h>

namespace orris {

/// An item as the packs draw it, in a cube 0..1.
struct ItemLook {
  ModelFaces faces;
  DisplayPoses poses{};
  std::map<int, ItemTint> tints{};  ///< by tint index of the faces

  /// What a texture is multiplied with: white below 0. `dye`: of the item, where it has one.
  glm::vec3 tintOf(int tintIndex, const std::optional<glm::vec3>& dye = {}) const;
  DisplayPose poseOf(DisplayPlace place) const;
  /// Puts the cube to its place, whose middle is the origin.
  glm::mat4 posed(DisplayPlace place) const;
};

/// The same pose for the other hand.
DisplayPose mirroredPose(DisplayPose pose);
/// Puts a cube 0..1 to its place, whose middle is the origin.
glm::mat4 poseMatrix(const DisplayPose& pose);

/// An item that the world shows.
struct ItemUse {
  const BlockFacts* facts = nullptr;  ///< without boxes: no block
  int times = 0;                      ///< how often it is drawn in a frame
};

/// By item; one that is absent keeps the look of Orris. Textures of the faces join `textures`.
std::map<std::string, ItemLook> makeItemLooks(const ResourceStack& resources,
                                              const std::map<std::string, ItemUse>& items,
                                              LookTextures& textures, Diagnostics& diagnostics);

}  // namespace orris
