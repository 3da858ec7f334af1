#include <orris/check/ids/block_names.h>

#include <algorithm>
#include <set>
#include <vector>

#include <orris/check/pack/pack_texts.h>
#include <orris/pack/files/text.h>
#include <orris/world/blocks/block_data.h>

namespace orris {
namespace {

// Names of versions before 1.13, and those that later versions renamed.
constexpr std::string_view kOld =
    "acacia_bark bed birch_bark black_hardened_clay brick_block brown_mushroom_block chain "
    "dark_oak_bark daylight_detector_inverted deadbush double_plant double_stone_slab "
    "double_stone_slab2 double_wooden_slab end_bricks fence fence_gate flowing_lava flowing_water "
    "golden_rail grass grass_path hardened_clay jungle_bark leaves leaves2 lit_furnace lit_pumpkin "
    "lit_redstone_lamp lit_redstone_ore log log2 magma melon_block mob_spawner monster_egg "
    "nether_brick noteblock oak_bark piston_extension planks portal powered_comparator "
    "powered_repeater prismarine_bricks purpur_double_slab quartz_ore red_flower red_nether_brick "
    "reeds sapling sign silver_glazed_terracotta silver_shulker_box skull slime snow_layer "
    "spruce_bark stained_glass stained_glass_pane stained_hardened_clay standing_banner "
    "standing_sign stone_slab stone_slab2 stone_stairs stonebrick tallgrass trapdoor "
    "unlit_redstone_torch unpowered_comparator unpowered_repeater wall_banner wall_sign waterlily "
    "web wooden_button wooden_door wooden_pressure_plate wooden_slab wool yellow_flower "
    "carpet concrete concrete_powder";

/// A list for several versions of the game may misspell a name of any.
const std::vector<std::string>& knownBlocks() {
  static const std::vector<std::string> kNames = [] {
    std::vector<std::string> names = splitBlanks(kOld);
    for (const auto& [name, definition] : blockData().blocks) names.push_back(name);
    return names;
  }();
  return kNames;
}

}  // namespace

std::string meantBlock(std::string_view name) {
  // Two slips in a short name make another one.
  constexpr std::size_t kShortest = 5;
  const std::vector<std::string>& known = knownBlocks();
  const bool exists = std::ranges::find(known, name) != known.end();
  return exists || name.size() < kShortest ? "" : likelyMeant(name, known);
}

}  // namespace orris
