// Colours of grass, leaves and water by biome.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

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
/// By the colour maps (without them blended as the game's are), and the biomes that have colours of their own.
BiomeTint biomeTint(const std::string& biome, float temperature, float rainfall,
                    const ColorMaps& maps);

/// Its part for a kind of tint, white for Tint::None.
glm::u8vec3 biomeColor(Tint tint, const BiomeTint& biome);

/// The tints of a world.
struct BiomeTints {
  std::vector<BiomeTint> byBiome;         ///< of the grid's names; without one, of the world's environment
  std::shared_ptr<const BiomeGrid> grid;  ///< nullptr: there is one biome

  /// The mean of the biomes around a block, as the game blends them.
  BiomeTint at(glm::ivec3 block) const;
};
BiomeTints tintsOf(const World& world, const ColorMaps& maps);

/// The colour of a face of `state` that its model gives a tint index (0 or more). The game: BlockColors.
glm::u8vec3 modelTint(const BlockState& state, const BlockFacts& facts, int tintIndex,
                      const BiomeTint& biome);

}  // namespace orris
