// Colours of grass, leaves and water by biome.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>

#include <orris/image/image.h>
#include <orris/world/blocks/block_facts.h>
#include <orris/world/world.h>

namespace orris {

/// Colour maps of a resource pack, 256x256: warm to cold from left to right, wet to dry from top to bottom.
struct ColorMaps {
  std::optional<Image8> grass, foliage;
};

/// The game's colour of the plains biome, white for Tint::None.
glm::u8vec3 plainsTint(Tint tint);

/// What a biome gives to blocks that take its colour.
struct BiomeTint {
  glm::u8vec3 grass{255}, foliage{255}, dryFoliage{255}, water{255};
};
/// By the colour maps (the plains' colours without), and the biomes that have colours of their own.
BiomeTint biomeTint(const std::string& biome, float temperature, float rainfall,
                    const ColorMaps& maps);

/// The colour of a face of `state` that its model gives a tint index (0 or more). The game: BlockColors.
glm::u8vec3 modelTint(const BlockState& state, const BlockFacts& facts, int tintIndex,
                      const BiomeTint& biome);

}  // namespace orris
