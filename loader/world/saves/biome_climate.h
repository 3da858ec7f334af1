// Temperature and rainfall of the game's biomes.
#pragma once

#include <string_view>

namespace orris {

struct BiomeClimate {
  float temperature = 0.8f, rainfall = 0.4f;  ///< of the plains, and of biomes that are not known
};

/// `biome` with its namespace.
BiomeClimate climateOf(std::string_view biome);

}  // namespace orris
