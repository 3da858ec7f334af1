#include <orris/pack/ids/legacy_ids.h>

#include <array>
#include <span>

#include <orris/pack/files/text.h>

namespace orris {
namespace {

constexpr std::array<std::string_view, 16> kColors{
    "white",      "orange", "magenta", "light_blue", "yellow", "lime",  "pink", "gray",
    "light_gray", "cyan",   "purple",  "blue",       "brown",  "green", "red",  "black"};
constexpr std::array<std::string_view, 6> kWoods{"oak",    "birch",  "jungle",
                                                 "spruce", "acacia", "dark_oak"};

/// Iris: LegacyIdMap, which knows the blocks that old packs ask for. "<color>" and "<wood>" stand
/// for each of them.
struct LegacyId {
  int id;
  std::string_view blocks;
};
constexpr LegacyId kIds[] = {
    {1, "stone granite diorite andesite"},
    {2, "grass_block"},
    {4, "cobblestone"},
    {50, "torch"},
    {89, "glowstone"},
    {124, "redstone_lamp"},
    {12, "sand"},
    {24, "sandstone"},
    {41, "gold_block"},
    {42, "iron_block"},
    {57, "diamond_block"},
    {-123, "emerald_block"},
    {35, "<color>_wool"},
    {9, "water"},
    {11, "lava"},
    {79, "ice"},
    {18, "<wood>_leaves"},
    {95, "<color>_stained_glass"},
    {160, "<color>_stained_glass_pane"},
    {31, "grass seagrass sweet_berry_bush"},
    {59, "wheat carrots potatoes"},
    {37,
     "dandelion poppy blue_orchid allium azure_bluet red_tulip pink_tulip white_tulip orange_tulip "
     "oxeye_daisy cornflower lily_of_the_valley wither_rose"},
    {175, "sunflower lilac tall_grass large_fern rose_bush peony tall_seagrass"},
    {51, "fire"},
    {111, "lily_pad"},
};

std::vector<std::string> expanded(const std::string& block) {
  const auto with = [&](std::string_view mark, std::span<const std::string_view> words) {
    std::vector<std::string> names;
    for (const std::string_view word : words)
      names.push_back(std::string(word) + block.substr(mark.size()));
    return names;
  };
  if (block.starts_with("<color>")) return with("<color>", kColors);
  if (block.starts_with("<wood>")) return with("<wood>", kWoods);
  return {block};
}

}  // namespace

BlockIdMap legacyBlockIds(long long minecraftVersion) {
  BlockIdMap map;
  // Worlds of this host have the new name, whatever the version.
  if (minecraftVersion < kShortGrassVersion)
    map.filters.push_back({.name = "minecraft:short_grass", .id = 31});
  for (const LegacyId& row : kIds) {
    for (const std::string& word : splitBlanks(row.blocks)) {
      for (const std::string& name : expanded(word))
        map.filters.push_back({.name = "minecraft:" + name, .id = row.id});
    }
  }
  return map;
}

}  // namespace orris
