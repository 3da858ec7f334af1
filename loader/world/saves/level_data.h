// level.dat of a save: what of it sets the frame.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace orris {

/// Where the player stood, or began: feet in world blocks, angles in degrees as in the game.
struct SavedPlace {
  glm::dvec3 feet{0};
  float yaw = 0, pitch = 0;
  std::string dimension = "minecraft:overworld";
};

struct LevelData {
  std::string name;          ///< "" when it has none
  int time = 6000, day = 0;  ///< ticks of the day, number of the day
  bool rain = false, thunder = false;
  std::optional<SavedPlace> player;  ///< of a game for one person
  std::optional<SavedPlace> spawn;   ///< yaw and pitch 0 where the game does not keep them
};

/// `bytes` are those of the file, compressed with gzip. nullopt and why: it is damaged. What it does not
/// hold has the values above.
std::optional<LevelData> parseLevelData(std::string_view bytes, std::string& problem);

}  // namespace orris
