// Which of our figures shows an entity of the game.
#pragma once

#include <string>
#include <string_view>

namespace orris {

struct EntityFigure {
  std::string_view kind;   ///< of the game, without "minecraft:"
  std::string_view model;  ///< findEntityModel() knows it
  float scale = 1;         ///< of the model, so that it is as tall as the game's
};

/// nullptr: nothing of ours is like it. `kind` has its namespace.
const EntityFigure* findFigure(std::string_view kind);

/// Is there nothing to see of this kind in the game, either?
bool isUnseenKind(std::string_view kind);

/// The name of today: "MushroomCow", of 1.10 and before, is "minecraft:mooshroom". "" where `id` is no
/// name of the game or a mod.
std::string currentKind(const std::string& id);

}  // namespace orris
