#include <orris/world/dimension_look.h>

#include <algorithm>
#include <iterator>

namespace orris {
namespace {

struct DimensionLook {
  std::string_view dimension, biome;
  float temperature, rainfall;
  int skyTime;  ///< ticks of the day, at which it stands still
  glm::vec3 fog;
};
// The game: dimension_type, and the biomes that a new portal leads to. The fog of the End is that of its biome, darkened.
constexpr DimensionLook kLooks[] = {{"minecraft:the_nether",
                                     "minecraft:nether_wastes",
                                     2,
                                     0,
                                     18000,
                                     {0x33 / 255.0f, 0x08 / 255.0f, 0x08 / 255.0f}},
                                    {"minecraft:the_end",
                                     "minecraft:the_end",
                                     0.5f,
                                     0.5f,
                                     6000,
                                     {0xa0 * 0.15f / 255, 0x80 * 0.15f / 255, 0xa0 * 0.15f / 255}}};

const DimensionLook* lookOfDimension(std::string_view dimension) {
  const auto* found = std::ranges::find(kLooks, dimension, &DimensionLook::dimension);
  return found == std::end(kLooks) ? nullptr : found;
}

}  // namespace

bool hasSkylight(std::string_view dimension) { return lookOfDimension(dimension) == nullptr; }

float ambientLightOf(std::string_view dimension) {
  return dimension == "minecraft:the_nether" ? 0.1f : 0;
}

int skyTimeOf(const Environment& environment) {
  const DimensionLook* look = lookOfDimension(environment.dimension);
  return look ? look->skyTime : environment.time;
}

void setDimension(const std::string& dimension, Environment& environment) {
  environment.dimension = dimension;
  const DimensionLook* look = lookOfDimension(dimension);
  if (!look) return;
  environment.biome = look->biome;
  environment.temperature = look->temperature;
  environment.rainfall = look->rainfall;
  environment.fogColor = look->fog;
  environment.skyColor = glm::vec3(0);
}

}  // namespace orris
