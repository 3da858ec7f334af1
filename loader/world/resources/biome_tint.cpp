#include <orris/world/resources/biome_tint.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include <orris/world/saves/biome_climate.h>

namespace orris {
namespace {

constexpr std::string_view kGame = "minecraft:";

glm::u8vec3 rgb(unsigned value) { return {value >> 16 & 255, value >> 8 & 255, value & 255}; }

/// Colours that a biome sets itself; 0: by the map, and for water the usual one.
struct OwnColors {
  unsigned grass, foliage, water;
  std::string_view biomes;  ///< a space before and behind each
};
constexpr OwnColors kOwnColors[] = {
    {0x90814d, 0x9e814d, 0, " badlands wooded_badlands eroded_badlands "},
    {0x6a7039, 0x6a7039, 0x617b64, " swamp "},
    {0x6a7039, 0x8db127, 0x3a7a6a, " mangrove_swamp "},
    {0xb6db61, 0xb6db61, 0x5db7ef, " cherry_grove "},
    {0x778272, 0x878d76, 0x76889d, " pale_garden "},
    {0, 0, 0x0e4ecf, " meadow "},
    {0, 0, 0x3938c9, " frozen_river frozen_ocean deep_frozen_ocean "},
    {0, 0, 0x3d57d6, " cold_ocean deep_cold_ocean snowy_taiga snowy_beach "},
    {0, 0, 0x45adf2, " lukewarm_ocean deep_lukewarm_ocean "},
    {0, 0, 0x43d5ee, " warm_ocean "},
};
constexpr unsigned kUsualWater = 0x3f76e4;

/// What the game's maps are painted by: a colour where it is hot and dry, cold, hot and wet. The plains keep their own.
glm::u8vec3 blended(float warm, float wet, Tint tint) {
  constexpr glm::vec3 kCorners[2][3] = {{{191, 183, 85}, {128, 180, 151}, {71, 205, 51}},
                                        {{174, 164, 42}, {96, 161, 123}, {26, 191, 0}}};
  constexpr float kPlainsWarm = 0.8f, kPlainsWet = 0.32f, kNear = 1e-3f;
  if (std::abs(warm - kPlainsWarm) < kNear && std::abs(wet - kPlainsWet) < kNear) return plainsTint(tint);
  const glm::vec3* corners = kCorners[tint == Tint::Grass ? 0 : 1];
  return glm::u8vec3(corners[0] * (warm - wet) + corners[1] * (1 - warm) + corners[2] * wet);
}

glm::u8vec3 fromMap(const std::optional<Image8>& map, float temperature, float rainfall,
                    Tint tint) {
  constexpr int kSide = 256;
  const float warm = std::clamp(temperature, 0.0f, 1.0f);
  const float wet = std::clamp(rainfall, 0.0f, 1.0f) * warm;
  if (!map || map->width != kSide || map->height != kSide) return blended(warm, wet, tint);
  const std::uint8_t* texel = map->at(int((1 - warm) * 255), int((1 - wet) * 255));
  return {texel[0], texel[1], texel[2]};
}

const OwnColors* ownColorsOf(const std::string& biome) {
  if (!biome.starts_with(kGame)) return nullptr;
  const std::string word = " " + biome.substr(kGame.size()) + " ";
  const auto found = std::find_if(
      std::begin(kOwnColors), std::end(kOwnColors),
      [&](const auto& row) { return row.biomes.find(word) != std::string_view::npos; });
  return found == std::end(kOwnColors) ? nullptr : found;
}

enum class ModelTintKind { Grass, Foliage, DryFoliage, Water, Fixed, Redstone, Stem, PetalStem };
struct ModelTintRow {
  ModelTintKind kind;
  unsigned color;           ///< of Fixed
  std::string_view blocks;  ///< a space before and behind each
};
constexpr ModelTintRow kModelTints[] = {
    {ModelTintKind::Grass, 0,
     " grass_block short_grass grass tall_grass fern large_fern potted_fern sugar_cane bush "},
    {ModelTintKind::Foliage, 0,
     " oak_leaves jungle_leaves acacia_leaves dark_oak_leaves mangrove_leaves vine "},
    {ModelTintKind::DryFoliage, 0, " leaf_litter "},
    {ModelTintKind::Water, 0, " water bubble_column water_cauldron "},
    {ModelTintKind::Fixed, 0x619961, " spruce_leaves "},
    {ModelTintKind::Fixed, 0x80a755, " birch_leaves "},
    {ModelTintKind::Fixed, 0x208030, " lily_pad "},
    {ModelTintKind::Fixed, 0xe0c71c, " attached_melon_stem attached_pumpkin_stem "},
    {ModelTintKind::Stem, 0, " melon_stem pumpkin_stem "},
    {ModelTintKind::Redstone, 0, " redstone_wire "},
    {ModelTintKind::PetalStem, 0, " pink_petals wildflowers "},
};

int numberOf(const BlockState& state, const char* property, int most) {
  const std::string_view text = state.property(property, "0");
  int value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return std::clamp(value, 0, most);
}

/// Dark red without power, bright with 15.
glm::u8vec3 redstoneColor(int power) {
  const float p = float(power) / 15;
  const glm::vec3 color(p * 0.6f + (power > 0 ? 0.4f : 0.3f),
                        std::clamp(p * p * 0.7f - 0.5f, 0.0f, 1.0f),
                        std::clamp(p * p * 0.6f - 0.7f, 0.0f, 1.0f));
  return glm::u8vec3(color * 255.0f);
}

}  // namespace

glm::u8vec3 plainsTint(Tint tint) {
  switch (tint) {
    case Tint::Grass:
      return {0x91, 0xBD, 0x59};
    case Tint::Foliage:
      return {0x77, 0xAB, 0x2F};
    case Tint::Water:
      return {0x3F, 0x76, 0xE4};
    case Tint::None:
      break;
  }
  return {255, 255, 255};
}

BiomeTint biomeTint(const std::string& biome, float temperature, float rainfall,
                    const ColorMaps& maps) {
  const OwnColors* own = ownColorsOf(biome);
  BiomeTint tint;
  tint.grass =
      own && own->grass ? rgb(own->grass) : fromMap(maps.grass, temperature, rainfall, Tint::Grass);
  tint.foliage = own && own->foliage ? rgb(own->foliage)
                                     : fromMap(maps.foliage, temperature, rainfall, Tint::Foliage);
  tint.dryFoliage = rgb(0xa07a44);
  tint.water = rgb(own && own->water ? own->water : kUsualWater);
  if (biome == "minecraft:dark_forest") {
    const glm::ivec3 half = ((glm::ivec3(tint.grass) & 0xfe) + glm::ivec3(0x28, 0x34, 0x0a)) >> 1;
    tint.grass = glm::u8vec3(half);
  }
  return tint;
}

glm::u8vec3 biomeColor(Tint tint, const BiomeTint& biome) {
  return tint == Tint::Grass     ? biome.grass
         : tint == Tint::Foliage ? biome.foliage
         : tint == Tint::Water   ? biome.water
                                 : glm::u8vec3(255);
}

BiomeTint BiomeTints::at(glm::ivec3 block) const {
  constexpr int kBlend = 2;  // blocks, the game's default
  if (!grid) return byBiome[0];
  const std::uint8_t here = grid->at(block);
  bool one = true;
  glm::ivec3 grass(0), foliage(0), dry(0), water(0);
  for (int z = -kBlend; z <= kBlend; ++z) {
    for (int x = -kBlend; x <= kBlend; ++x) {
      const std::uint8_t biome = grid->at(block + glm::ivec3(x, 0, z));
      const BiomeTint& tint = byBiome[biome];
      one &= biome == here;
      grass += glm::ivec3(tint.grass);
      foliage += glm::ivec3(tint.foliage);
      dry += glm::ivec3(tint.dryFoliage);
      water += glm::ivec3(tint.water);
    }
  }
  constexpr int kPlaces = (2 * kBlend + 1) * (2 * kBlend + 1);
  if (one) return byBiome[here];
  return {glm::u8vec3(grass / kPlaces), glm::u8vec3(foliage / kPlaces), glm::u8vec3(dry / kPlaces),
          glm::u8vec3(water / kPlaces)};
}

BiomeTints tintsOf(const World& world, const ColorMaps& maps) {
  const Environment& environment = world.environment;
  BiomeTints tints;
  tints.grid = world.biomes;
  if (!tints.grid) {
    tints.byBiome = {biomeTint(environment.biome, environment.temperature, environment.rainfall, maps)};
    return tints;
  }
  for (const std::string& biome : tints.grid->names) {
    const BiomeClimate climate = climateOf(biome);
    tints.byBiome.push_back(biomeTint(biome, climate.temperature, climate.rainfall, maps));
  }
  return tints;
}

glm::u8vec3 modelTint(const BlockState& state, const BlockFacts& facts, int tintIndex,
                      const BiomeTint& biome) {
  const std::string_view name = state.name;
  const std::string word =
      name.starts_with(kGame) ? " " + std::string(name.substr(kGame.size())) + " " : "";
  const auto row = std::find_if(std::begin(kModelTints), std::end(kModelTints), [&](const auto& r) {
    return !word.empty() && r.blocks.find(word) != std::string_view::npos;
  });
  if (row == std::end(kModelTints))
    return biomeColor(facts.tint, biome);
  switch (row->kind) {
    case ModelTintKind::Grass:
      return biome.grass;
    case ModelTintKind::Foliage:
      return biome.foliage;
    case ModelTintKind::DryFoliage:
      return biome.dryFoliage;
    case ModelTintKind::Water:
      return biome.water;
    case ModelTintKind::Fixed:
      return rgb(row->color);
    case ModelTintKind::Redstone:
      return redstoneColor(numberOf(state, "power", 15));
    case ModelTintKind::Stem: {
      const int age = numberOf(state, "age", 7);
      return {age * 32, 255 - age * 8, age * 4};
    }
    case ModelTintKind::PetalStem:
      return tintIndex > 0 ? biome.grass : glm::u8vec3(255);
  }
  return glm::u8vec3(255);
}

}  // namespace orris
