#include <orris/pack/ids/block_tags.h>

#include <algorithm>
#include <array>

#include <orris/pack/files/text.h>

namespace orris {
namespace {

/// Patterns separated by blanks: a name, "*end", "start*" or "!name" for an exception, which stands
/// before what it is taken from.
struct Tag {
  std::string_view name, patterns;
};

// Vanilla tags as rules over block names, so that blocks of one family need no list.
constexpr std::array<Tag, 84> kTags{{
    {"leaves", "*_leaves"},
    {"logs", "*_log *_wood *_stem *_hyphae"},
    {"oak_logs", "oak_log oak_wood stripped_oak_log stripped_oak_wood"},
    {"spruce_logs", "spruce_log spruce_wood stripped_spruce_log stripped_spruce_wood"},
    {"birch_logs", "birch_log birch_wood stripped_birch_log stripped_birch_wood"},
    {"jungle_logs", "jungle_log jungle_wood stripped_jungle_log stripped_jungle_wood"},
    {"acacia_logs", "acacia_log acacia_wood stripped_acacia_log stripped_acacia_wood"},
    {"dark_oak_logs", "dark_oak_log dark_oak_wood stripped_dark_oak_log stripped_dark_oak_wood"},
    {"mangrove_logs", "mangrove_log mangrove_wood stripped_mangrove_log stripped_mangrove_wood"},
    {"cherry_logs", "cherry_log cherry_wood stripped_cherry_log stripped_cherry_wood"},
    {"crimson_stems", "crimson_stem crimson_hyphae stripped_crimson_stem stripped_crimson_hyphae"},
    {"warped_stems", "warped_stem warped_hyphae stripped_warped_stem stripped_warped_hyphae"},
    {"bamboo_blocks", "bamboo_block stripped_bamboo_block"},
    {"planks", "*_planks"},
    {"saplings", "*_sapling azalea flowering_azalea mangrove_propagule"},
    {"crops",
     "wheat carrots potatoes beetroots melon_stem pumpkin_stem torchflower_crop pitcher_crop"},
    {"small_flowers",
     "dandelion poppy blue_orchid allium azure_bluet *_tulip oxeye_daisy cornflower "
     "lily_of_the_valley wither_rose torchflower"},
    {"tall_flowers", "sunflower lilac peony rose_bush pitcher_plant"},
    {"flowers",
     "dandelion poppy blue_orchid allium azure_bluet *_tulip oxeye_daisy cornflower "
     "lily_of_the_valley wither_rose torchflower sunflower lilac peony rose_bush pitcher_plant "
     "flowering_azalea_leaves flowering_azalea mangrove_propagule cherry_leaves pink_petals "
     "chorus_flower spore_blossom"},
    {"flower_pots", "flower_pot potted_*"},
    {"stone_bricks", "stone_bricks mossy_stone_bricks cracked_stone_bricks chiseled_stone_bricks"},
    {"anvil", "anvil chipped_anvil damaged_anvil"},
    {"rails", "rail powered_rail detector_rail activator_rail"},
    {"cauldrons", "*cauldron"},
    {"fire", "fire soul_fire"},
    {"campfires", "campfire soul_campfire"},
    {"base_stone_overworld", "stone granite diorite andesite tuff deepslate"},
    {"base_stone_nether", "netherrack basalt blackstone"},
    {"coal_ores", "coal_ore deepslate_coal_ore"},
    {"iron_ores", "iron_ore deepslate_iron_ore"},
    {"copper_ores", "copper_ore deepslate_copper_ore"},
    {"gold_ores", "gold_ore nether_gold_ore deepslate_gold_ore"},
    {"redstone_ores", "redstone_ore deepslate_redstone_ore"},
    {"emerald_ores", "emerald_ore deepslate_emerald_ore"},
    {"lapis_ores", "lapis_ore deepslate_lapis_ore"},
    {"diamond_ores", "diamond_ore deepslate_diamond_ore"},
    {"stone_buttons", "stone_button polished_blackstone_button"},
    {"stone_pressure_plates", "stone_pressure_plate polished_blackstone_pressure_plate"},
    {"buttons", "*_button"},
    {"wooden_buttons", "!stone_button !polished_blackstone_button *_button"},
    {"pressure_plates", "*_pressure_plate"},
    {"wooden_pressure_plates",
     "!stone_pressure_plate !polished_blackstone_pressure_plate "
     "!light_weighted_pressure_plate !heavy_weighted_pressure_plate *_pressure_plate"},
    {"doors", "*_door"},
    {"wooden_doors",
     "!iron_door !copper_door !exposed_copper_door !weathered_copper_door "
     "!oxidized_copper_door !waxed_* *_door"},
    {"trapdoors", "*_trapdoor"},
    {"wooden_trapdoors",
     "!iron_trapdoor !copper_trapdoor !exposed_copper_trapdoor "
     "!weathered_copper_trapdoor !oxidized_copper_trapdoor !waxed_* *_trapdoor"},
    {"fences", "*_fence"},
    {"wooden_fences", "!nether_brick_fence *_fence"},
    {"fence_gates", "*_fence_gate"},
    {"walls", "*_wall"},
    {"slabs", "*_slab"},
    {"wooden_slabs",
     "oak_slab spruce_slab birch_slab jungle_slab acacia_slab dark_oak_slab crimson_slab "
     "warped_slab "
     "mangrove_slab bamboo_slab cherry_slab pale_oak_slab"},
    {"stairs", "*_stairs"},
    {"wooden_stairs",
     "oak_stairs spruce_stairs birch_stairs jungle_stairs acacia_stairs dark_oak_stairs "
     "crimson_stairs warped_stairs mangrove_stairs bamboo_stairs cherry_stairs pale_oak_stairs"},
    {"all_signs", "*_sign"},
    {"signs", "!*_hanging_sign *_sign"},
    {"banners", "*_banner"},
    {"beds", "*_bed"},
    {"candles", "candle *_candle"},
    {"candle_cakes", "candle_cake *_candle_cake"},
    {"wool", "*_wool"},
    {"wool_carpets", "!moss_carpet !pale_moss_carpet *_carpet"},
    {"terracotta", "!*_glazed_terracotta terracotta *_terracotta"},
    {"concrete_powder", "*_concrete_powder"},
    {"shulker_boxes", "shulker_box *_shulker_box"},
    {"beehives", "bee_nest beehive"},
    {"coral_blocks", "!dead_* *_coral_block"},
    {"coral_plants", "!dead_* *_coral"},
    {"corals", "!dead_* *_coral !*_coral_wall_fan *_coral_fan"},
    {"wall_corals", "!dead_* *_coral_wall_fan"},
    {"crystal_sound_blocks", "amethyst_block budding_amethyst"},
    {"dirt",
     "dirt grass_block podzol coarse_dirt mycelium rooted_dirt moss_block mud "
     "muddy_mangrove_roots pale_moss_block"},
    {"sand", "sand red_sand suspicious_sand"},
    {"snow", "snow snow_block powder_snow"},
    {"ice", "ice packed_ice blue_ice frosted_ice"},
    {"nylium", "crimson_nylium warped_nylium"},
    {"wart_blocks", "nether_wart_block warped_wart_block"},
    {"soul_fire_base_blocks", "soul_sand soul_soil"},
    {"enchantment_power_provider", "bookshelf"},
    {"invalid_spawn_inside", "end_portal end_gateway"},
    {"mooshrooms_spawnable_on", "mycelium"},
    {"polar_bears_spawnable_on_alternate", "ice"},
    {"sniffer_egg_hatch_boost", "moss_block"},
    {"impermeable", "glass *_stained_glass tinted_glass"},
}};

std::string_view withoutNamespace(std::string_view name) {
  constexpr std::string_view kNamespace = "minecraft:";
  return name.starts_with(kNamespace) ? name.substr(kNamespace.size()) : name;
}

const Tag* findTag(std::string_view tag) {
  const auto found = std::find_if(kTags.begin(), kTags.end(),
                                  [&](auto& t) { return t.name == withoutNamespace(tag); });
  return found == kTags.end() ? nullptr : &*found;
}

bool fits(std::string_view block, std::string_view pattern) {
  if (pattern.starts_with('*')) return block.ends_with(pattern.substr(1));
  if (pattern.ends_with('*')) return block.starts_with(pattern.substr(0, pattern.size() - 1));
  return block == pattern;
}

}  // namespace

bool isKnownBlockTag(std::string_view tag) { return findTag(tag) != nullptr; }

bool hasBlockTag(std::string_view block, std::string_view tag) {
  const Tag* known = findTag(tag);
  if (!known) return false;
  const std::string_view name = withoutNamespace(block);
  for (std::string_view pattern : splitAt(known->patterns, ' ')) {
    const bool exception = pattern.starts_with('!');
    if (exception) pattern.remove_prefix(1);
    if (fits(name, pattern)) return !exception;
  }
  return false;
}

}  // namespace orris
