// Light, fog and sky of the game's dimensions.
#pragma once

#include <orris/world/world.h>

#include <string_view>

namespace orris {

/// Does sky light reach the blocks of a dimension?
bool hasSkylight(std::string_view dimension);

/// Light that every block of a dimension has, 0..1 of the brightest. Uniform ambientLight.
float ambientLightOf(std::string_view dimension);

/// The time by which its sky turns: that of the day, or the dimension's own.
int skyTimeOf(const Environment& environment);

/// Makes it the environment of a dimension: biome, climate, fog and sky of the Nether and the End; of others the name
/// alone.
void setDimension(const std::string& dimension, Environment& environment);

}  // namespace orris
