#include <orris/world/saves/legacy_blocks.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace orris {
namespace {

using Properties = std::map<std::string, std::string>;
using Words = std::string_view;

/// How the four bits of data set properties, once the name is known.
enum class Data : std::uint8_t {
  None,
  Log,   // axis in the upper two bits; 12: bark all around
  Axis,  // the same, without bark
  Stairs,
  Slab,   // upper half by bit 8
  Level,  // fluids
  Torch,
  Facing4,  // 2 north, 3 south, 4 west, 5 east
  Facing6,  // 0 down, 1 up, then as above
  Turn,     // 0 south, 1 west, 2 north, 3 east
  Turn16,   // signs and banners that stand
  Door,
  Trapdoor,
  Gate,
  Bed,
  Rail,
  Age,
  Layers,
  Vine,
  Lever,
  Button,
  Plant,  // upper half by bit 8
  Wire,
  Repeater,
};

/// `names` by the bits of `mask`, lowest first; the last stands for the rest. "{}" is replaced by the
/// word of the list.
struct LegacyRow {
  int id;
  Words pattern;
  Words list;
  int mask;
  Data data = Data::None;
  Words more = {};  ///< properties that never change, "lit=true"
};

constexpr Words kWoods = "oak spruce birch jungle acacia dark_oak";
constexpr Words kColours =
    "white orange magenta light_blue yellow lime pink gray light_gray cyan purple blue brown green "
    "red black";

constexpr LegacyRow kRows[] = {
    {0, "air", "", 0},
    {1, "{}", "stone granite polished_granite diorite polished_diorite andesite polished_andesite",
     7},
    {2, "grass_block", "", 0},
    {3, "{}", "dirt coarse_dirt podzol", 3},
    {4, "cobblestone", "", 0},
    {5, "{}_planks", kWoods, 7},
    {6, "{}_sapling", kWoods, 7},
    {7, "bedrock", "", 0},
    {8, "water", "", 0, Data::Level},
    {9, "water", "", 0, Data::Level},
    {10, "lava", "", 0, Data::Level},
    {11, "lava", "", 0, Data::Level},
    {12, "{}", "sand red_sand", 1},
    {13, "gravel", "", 0},
    {14, "gold_ore", "", 0},
    {15, "iron_ore", "", 0},
    {16, "coal_ore", "", 0},
    {17, "{}", "oak spruce birch jungle", 3, Data::Log},
    {18, "{}_leaves", "oak spruce birch jungle", 3},
    {19, "{}", "sponge wet_sponge", 1},
    {20, "glass", "", 0},
    {21, "lapis_ore", "", 0},
    {22, "lapis_block", "", 0},
    {23, "dispenser", "", 0, Data::Facing6},
    {24, "{}", "sandstone chiseled_sandstone cut_sandstone", 3},
    {25, "note_block", "", 0},
    {26, "red_bed", "", 0, Data::Bed},
    {27, "powered_rail", "", 0, Data::Rail},
    {28, "detector_rail", "", 0, Data::Rail},
    {29, "sticky_piston", "", 0, Data::Facing6},
    {30, "cobweb", "", 0},
    {31, "{}", "dead_bush short_grass fern", 3},
    {32, "dead_bush", "", 0},
    {33, "piston", "", 0, Data::Facing6},
    {34, "piston_head", "", 0, Data::Facing6},
    {35, "{}_wool", kColours, 15},
    {37, "dandelion", "", 0},
    {38, "{}",
     "poppy blue_orchid allium azure_bluet red_tulip orange_tulip white_tulip pink_tulip "
     "oxeye_daisy",
     15},
    {39, "brown_mushroom", "", 0},
    {40, "red_mushroom", "", 0},
    {41, "gold_block", "", 0},
    {42, "iron_block", "", 0},
    {43, "{}",
     "smooth_stone_slab sandstone_slab petrified_oak_slab cobblestone_slab brick_slab "
     "stone_brick_slab nether_brick_slab quartz_slab",
     7, Data::None, "type=double"},
    {44, "{}",
     "smooth_stone_slab sandstone_slab petrified_oak_slab cobblestone_slab brick_slab "
     "stone_brick_slab nether_brick_slab quartz_slab",
     7, Data::Slab},
    {45, "bricks", "", 0},
    {46, "tnt", "", 0},
    {47, "bookshelf", "", 0},
    {48, "mossy_cobblestone", "", 0},
    {49, "obsidian", "", 0},
    {50, "torch", "", 0, Data::Torch},
    {51, "fire", "", 0},
    {52, "spawner", "", 0},
    {53, "oak_stairs", "", 0, Data::Stairs},
    {54, "chest", "", 0, Data::Facing4},
    {55, "redstone_wire", "", 0, Data::Wire},
    {56, "diamond_ore", "", 0},
    {57, "diamond_block", "", 0},
    {58, "crafting_table", "", 0},
    {59, "wheat", "", 0, Data::Age},
    {60, "farmland", "", 0},
    {61, "furnace", "", 0, Data::Facing4},
    {62, "furnace", "", 0, Data::Facing4, "lit=true"},
    {63, "oak_sign", "", 0, Data::Turn16},
    {64, "oak_door", "", 0, Data::Door},
    {65, "ladder", "", 0, Data::Facing4},
    {66, "rail", "", 0, Data::Rail},
    {67, "cobblestone_stairs", "", 0, Data::Stairs},
    {68, "oak_wall_sign", "", 0, Data::Facing4},
    {69, "lever", "", 0, Data::Lever},
    {70, "stone_pressure_plate", "", 0},
    {71, "iron_door", "", 0, Data::Door},
    {72, "oak_pressure_plate", "", 0},
    {73, "redstone_ore", "", 0},
    {74, "redstone_ore", "", 0, Data::None, "lit=true"},
    {75, "redstone_torch", "", 0, Data::Torch, "lit=false"},
    {76, "redstone_torch", "", 0, Data::Torch, "lit=true"},
    {77, "stone_button", "", 0, Data::Button},
    {78, "snow", "", 0, Data::Layers},
    {79, "ice", "", 0},
    {80, "snow_block", "", 0},
    {81, "cactus", "", 0},
    {82, "clay", "", 0},
    {83, "sugar_cane", "", 0},
    {84, "jukebox", "", 0},
    {85, "oak_fence", "", 0},
    {86, "carved_pumpkin", "", 0, Data::Turn},
    {87, "netherrack", "", 0},
    {88, "soul_sand", "", 0},
    {89, "glowstone", "", 0},
    {90, "nether_portal", "", 0},
    {91, "jack_o_lantern", "", 0, Data::Turn},
    {92, "cake", "", 0},
    {93, "repeater", "", 0, Data::Repeater, "powered=false"},
    {94, "repeater", "", 0, Data::Repeater, "powered=true"},
    {95, "{}_stained_glass", kColours, 15},
    {96, "oak_trapdoor", "", 0, Data::Trapdoor},
    {97, "{}",
     "infested_stone infested_cobblestone infested_stone_bricks infested_mossy_stone_bricks "
     "infested_cracked_stone_bricks infested_chiseled_stone_bricks",
     7},
    {98, "{}stone_bricks", " mossy_ cracked_ chiseled_", 3},
    {99, "brown_mushroom_block", "", 0},
    {100, "red_mushroom_block", "", 0},
    {101, "iron_bars", "", 0},
    {102, "glass_pane", "", 0},
    {103, "melon", "", 0},
    {104, "pumpkin_stem", "", 0, Data::Age},
    {105, "melon_stem", "", 0, Data::Age},
    {106, "vine", "", 0, Data::Vine},
    {107, "oak_fence_gate", "", 0, Data::Gate},
    {108, "brick_stairs", "", 0, Data::Stairs},
    {109, "stone_brick_stairs", "", 0, Data::Stairs},
    {110, "mycelium", "", 0},
    {111, "lily_pad", "", 0},
    {112, "nether_bricks", "", 0},
    {113, "nether_brick_fence", "", 0},
    {114, "nether_brick_stairs", "", 0, Data::Stairs},
    {115, "nether_wart", "", 0, Data::Age},
    {116, "enchanting_table", "", 0},
    {117, "brewing_stand", "", 0},
    {118, "cauldron", "", 0},
    {119, "end_portal", "", 0},
    {120, "end_portal_frame", "", 0, Data::Turn},
    {121, "end_stone", "", 0},
    {122, "dragon_egg", "", 0},
    {123, "redstone_lamp", "", 0, Data::None, "lit=false"},
    {124, "redstone_lamp", "", 0, Data::None, "lit=true"},
    {125, "{}_slab", kWoods, 7, Data::None, "type=double"},
    {126, "{}_slab", kWoods, 7, Data::Slab},
    {127, "cocoa", "", 0, Data::Turn},
    {128, "sandstone_stairs", "", 0, Data::Stairs},
    {129, "emerald_ore", "", 0},
    {130, "ender_chest", "", 0, Data::Facing4},
    {131, "tripwire_hook", "", 0, Data::Turn},
    {132, "tripwire", "", 0},
    {133, "emerald_block", "", 0},
    {134, "spruce_stairs", "", 0, Data::Stairs},
    {135, "birch_stairs", "", 0, Data::Stairs},
    {136, "jungle_stairs", "", 0, Data::Stairs},
    {137, "command_block", "", 0, Data::Facing6},
    {138, "beacon", "", 0},
    {139, "{}cobblestone_wall", " mossy_", 1},
    {140, "flower_pot", "", 0},
    {141, "carrots", "", 0, Data::Age},
    {142, "potatoes", "", 0, Data::Age},
    {143, "oak_button", "", 0, Data::Button},
    {144, "skeleton_skull", "", 0},
    {145, "anvil", "", 0, Data::Turn},
    {146, "trapped_chest", "", 0, Data::Facing4},
    {147, "light_weighted_pressure_plate", "", 0},
    {148, "heavy_weighted_pressure_plate", "", 0},
    {149, "comparator", "", 0, Data::Repeater},
    {150, "comparator", "", 0, Data::Repeater, "powered=true"},
    {151, "daylight_detector", "", 0},
    {152, "redstone_block", "", 0},
    {153, "nether_quartz_ore", "", 0},
    {154, "hopper", "", 0, Data::Facing6},
    {155, "{}",
     "quartz_block chiseled_quartz_block quartz_pillar[axis=y] quartz_pillar[axis=x] "
     "quartz_pillar[axis=z]",
     7},
    {156, "quartz_stairs", "", 0, Data::Stairs},
    {157, "activator_rail", "", 0, Data::Rail},
    {158, "dropper", "", 0, Data::Facing6},
    {159, "{}_terracotta", kColours, 15},
    {160, "{}_stained_glass_pane", kColours, 15},
    {161, "{}_leaves", "acacia dark_oak", 1},
    {162, "{}", "acacia dark_oak", 1, Data::Log},
    {163, "acacia_stairs", "", 0, Data::Stairs},
    {164, "dark_oak_stairs", "", 0, Data::Stairs},
    {165, "slime_block", "", 0},
    {166, "barrier", "", 0},
    {167, "iron_trapdoor", "", 0, Data::Trapdoor},
    {168, "{}", "prismarine prismarine_bricks dark_prismarine", 3},
    {169, "sea_lantern", "", 0},
    {170, "hay_block", "", 0, Data::Axis},
    {171, "{}_carpet", kColours, 15},
    {172, "terracotta", "", 0},
    {173, "coal_block", "", 0},
    {174, "packed_ice", "", 0},
    {175, "{}", "sunflower lilac tall_grass large_fern rose_bush peony", 7, Data::Plant},
    {176, "white_banner", "", 0, Data::Turn16},
    {177, "white_wall_banner", "", 0, Data::Facing4},
    {178, "daylight_detector", "", 0, Data::None, "inverted=true"},
    {179, "{}", "red_sandstone chiseled_red_sandstone cut_red_sandstone", 3},
    {180, "red_sandstone_stairs", "", 0, Data::Stairs},
    {181, "red_sandstone_slab", "", 0, Data::None, "type=double"},
    {182, "red_sandstone_slab", "", 0, Data::Slab},
    {183, "spruce_fence_gate", "", 0, Data::Gate},
    {184, "birch_fence_gate", "", 0, Data::Gate},
    {185, "jungle_fence_gate", "", 0, Data::Gate},
    {186, "dark_oak_fence_gate", "", 0, Data::Gate},
    {187, "acacia_fence_gate", "", 0, Data::Gate},
    {188, "spruce_fence", "", 0},
    {189, "birch_fence", "", 0},
    {190, "jungle_fence", "", 0},
    {191, "dark_oak_fence", "", 0},
    {192, "acacia_fence", "", 0},
    {193, "spruce_door", "", 0, Data::Door},
    {194, "birch_door", "", 0, Data::Door},
    {195, "jungle_door", "", 0, Data::Door},
    {196, "acacia_door", "", 0, Data::Door},
    {197, "dark_oak_door", "", 0, Data::Door},
    {198, "end_rod", "", 0, Data::Facing6},
    {199, "chorus_plant", "", 0},
    {200, "chorus_flower", "", 0, Data::Age},
    {201, "purpur_block", "", 0},
    {202, "purpur_pillar", "", 0, Data::Axis},
    {203, "purpur_stairs", "", 0, Data::Stairs},
    {204, "purpur_slab", "", 0, Data::None, "type=double"},
    {205, "purpur_slab", "", 0, Data::Slab},
    {206, "end_stone_bricks", "", 0},
    {207, "beetroots", "", 0, Data::Age},
    {208, "dirt_path", "", 0},
    {209, "end_gateway", "", 0},
    {210, "repeating_command_block", "", 0, Data::Facing6},
    {211, "chain_command_block", "", 0, Data::Facing6},
    {212, "frosted_ice", "", 0},
    {213, "magma_block", "", 0},
    {214, "nether_wart_block", "", 0},
    {215, "red_nether_bricks", "", 0},
    {216, "bone_block", "", 0, Data::Axis},
    {217, "structure_void", "", 0},
    {218, "observer", "", 0, Data::Facing6},
    {255, "structure_block", "", 0},
};
// 219 to 234 are the shulker boxes by colour, 235 to 250 glazed terracotta; 251 and 252 concrete.
constexpr int kShulkers = 219, kGlazed = 235, kConcrete = 251, kPowder = 252;

std::string word(Words list, int index) {
  std::size_t begin = 0;
  for (; index > 0; --index) {
    const std::size_t space = list.find(' ', begin);
    if (space == Words::npos) break;
    begin = space + 1;
  }
  return std::string(list.substr(begin, list.find(' ', begin) - begin));
}

void setAll(Properties& properties, Words text) {
  while (!text.empty()) {
    const std::size_t comma = text.find(','), equals = text.find('=');
    const Words item = text.substr(0, comma);
    properties[std::string(item.substr(0, equals))] = item.substr(equals + 1);
    text = comma == Words::npos ? Words() : text.substr(comma + 1);
  }
}

const char* flag(int bits) { return bits != 0 ? "true" : "false"; }
std::string facing6(int data) {
  return word("down up north south west east north north", data & 7);
}
std::string facing4(int data) {
  return word("north north north south west east north north", data & 7);
}
std::string turn(int data) { return word("south west north east", data & 3); }

void setTorch(BlockState& state, int data) {
  const int side = data & 7;
  if (side < 1 || side > 4) return;
  state.name =
      state.name == "minecraft:torch" ? "minecraft:wall_torch" : "minecraft:redstone_wall_torch";
  state.properties["facing"] = word("east west south north", side - 1);
}

/// The lower half knows where the door turns, the upper half on which side.
void setDoor(Properties& properties, int data) {
  const bool upper = (data & 8) != 0;
  properties["half"] = upper ? "upper" : "lower";
  if (upper) {
    properties["hinge"] = (data & 1) != 0 ? "right" : "left";
    return;
  }
  properties["facing"] = word("east south west north", data & 3);
  properties["open"] = flag(data & 4);
}

void setLog(BlockState& state, int data) {
  const int axis = data >> 2 & 3;
  state.name += axis == 3 ? "_wood" : "_log";
  state.properties["axis"] = word("y x z y", axis);
}

void setLever(BlockState& state, int data) {
  const int place = data & 7;
  const bool floor = place == 5 || place == 6, ceiling = place == 0 || place == 7;
  state.properties["face"] = floor ? "floor" : ceiling ? "ceiling" : "wall";
  state.properties["facing"] = word("east east west south north south east south", place);
  state.properties["powered"] = flag(data & 8);
}

void setButton(Properties& properties, int data) {
  const int place = data & 7;
  properties["face"] = place == 0 ? "ceiling" : place >= 5 ? "floor" : "wall";
  properties["facing"] = word("north east west south north north north north", place);
}

void setVine(Properties& properties, int data) {
  for (int side = 0; side < 4; ++side) {
    if (data >> side & 1) properties[turn(side)] = "true";
  }
  if (data == 0) properties["up"] = "true";
}

void setData(BlockState& state, Data rule, int data) {
  Properties& set = state.properties;
  switch (rule) {
    case Data::None:
      break;
    case Data::Log:
      setLog(state, data);
      break;
    case Data::Axis:
      set["axis"] = word("y x z y", data >> 2 & 3);
      break;
    case Data::Stairs:
      set["facing"] = word("east west south north", data & 3);
      set["half"] = (data & 4) != 0 ? "top" : "bottom";
      break;
    case Data::Slab:
      set["type"] = (data & 8) != 0 ? "top" : "bottom";
      break;
    case Data::Level:
      set["level"] = std::to_string(data);
      break;
    case Data::Torch:
      setTorch(state, data);
      break;
    case Data::Facing4:
      set["facing"] = facing4(data);
      break;
    case Data::Facing6:
      set["facing"] = facing6(data);
      break;
    case Data::Turn:
      set["facing"] = turn(data);
      break;
    case Data::Turn16:
      set["rotation"] = std::to_string(data);
      break;
    case Data::Door:
      setDoor(set, data);
      break;
    case Data::Trapdoor:
      set["facing"] = word("north south west east", data & 3);
      set["open"] = flag(data & 4);
      set["half"] = (data & 8) != 0 ? "top" : "bottom";
      break;
    case Data::Gate:
      set["facing"] = turn(data);
      set["open"] = flag(data & 4);
      break;
    case Data::Bed:
      set["facing"] = turn(data);
      set["part"] = (data & 8) != 0 ? "head" : "foot";
      break;
    case Data::Rail:
      set["shape"] = word(
          "north_south east_west ascending_east ascending_west ascending_north ascending_south "
          "south_east south_west north_west north_east",
          state.name == "minecraft:rail" ? data : data & 7);
      break;
    case Data::Age:
      set["age"] = std::to_string(data & 7);
      break;
    case Data::Layers:
      set["layers"] = std::to_string((data & 7) + 1);
      break;
    case Data::Vine:
      setVine(set, data);
      break;
    case Data::Lever:
      setLever(state, data);
      break;
    case Data::Button:
      setButton(set, data);
      break;
    case Data::Plant:
      set["half"] = (data & 8) != 0 ? "upper" : "lower";
      break;
    case Data::Wire:
      set["power"] = std::to_string(data);
      break;
    case Data::Repeater:
      set["facing"] = turn(data);
      break;
  }
}

BlockState stateOfRow(const LegacyRow& row, int data) {
  std::string name(row.pattern);
  const std::size_t hole = name.find("{}");
  if (hole != std::string::npos) name.replace(hole, 2, word(row.list, data & row.mask));
  BlockState state =
      parseBlockState(name).value_or(BlockState{"legacy:" + std::to_string(row.id), {}});
  setAll(state.properties, row.more);
  setData(state, row.data, data);
  return state;
}

}  // namespace

BlockState legacyState(int id, int data) {
  const auto coloured = [](int colour, const char* suffix) {
    return BlockState{"minecraft:" + word(kColours, colour) + suffix, {}};
  };
  if (id >= kShulkers && id < kShulkers + 16) return coloured(id - kShulkers, "_shulker_box");
  if (id == kConcrete) return coloured(data, "_concrete");
  if (id == kPowder) return coloured(data, "_concrete_powder");
  if (id >= kGlazed && id < kGlazed + 16) {
    BlockState state = coloured(id - kGlazed, "_glazed_terracotta");
    state.properties["facing"] = turn(data);
    return state;
  }
  for (const LegacyRow& row : kRows) {
    if (row.id == id) return stateOfRow(row, data);
  }
  return {"legacy:" + std::to_string(id), {}};
}

}  // namespace orris
