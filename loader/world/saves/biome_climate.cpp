#include <orris/world/saves/biome_climate.h>

#include <string>

namespace orris {
namespace {

struct ClimateRow {
  BiomeClimate climate;
  std::string_view biomes;  ///< a space before and behind each
};
constexpr ClimateRow kClimates[] = {
    {{2, 0},
     " desert badlands wooded_badlands eroded_badlands savanna savanna_plateau windswept_savanna "
     "nether_wastes soul_sand_valley crimson_forest warped_forest basalt_deltas "},
    {{0.7f, 0.8f}, " forest flower_forest dark_forest pale_garden "},
    {{0.6f, 0.6f}, " birch_forest old_growth_birch_forest "},
    {{0.25f, 0.8f}, " taiga old_growth_spruce_taiga "},
    {{0.3f, 0.8f}, " old_growth_pine_taiga "},
    {{0.8f, 0.9f}, " swamp mangrove_swamp "},
    {{0.5f, 0.5f},
     " river ocean deep_ocean cold_ocean deep_cold_ocean lukewarm_ocean deep_lukewarm_ocean "
     "warm_ocean deep_frozen_ocean lush_caves the_end end_highlands end_midlands "
     "end_barrens small_end_islands the_void "},
    {{0, 0.5f}, " frozen_river frozen_ocean snowy_plains ice_spikes "},
    {{0.05f, 0.3f}, " snowy_beach "},
    {{0.2f, 0.3f}, " stony_shore windswept_hills windswept_gravelly_hills windswept_forest "},
    {{-0.5f, 0.4f}, " snowy_taiga "},
    {{0.95f, 0.9f}, " jungle bamboo_jungle "},
    {{0.95f, 0.8f}, " sparse_jungle "},
    {{0.9f, 1}, " mushroom_fields "},
    {{0.5f, 0.8f}, " meadow cherry_grove "},
    {{-0.2f, 0.8f}, " grove "},
    {{-0.3f, 0.9f}, " snowy_slopes "},
    {{-0.7f, 0.9f}, " frozen_peaks jagged_peaks "},
    {{1, 0.3f}, " stony_peaks "},
};

}  // namespace

BiomeClimate climateOf(std::string_view biome) {
  constexpr std::string_view kGame = "minecraft:";
  if (!biome.starts_with(kGame)) return {};
  const std::string word = " " + std::string(biome.substr(kGame.size())) + " ";
  for (const ClimateRow& row : kClimates) {
    if (row.biomes.find(word) != std::string_view::npos) return row.climate;
  }
  return {};
}

}  // namespace orris
