#include <orris/world/luanti/node_blocks.h>

#include <algorithm>
#include <array>
#include <unordered_map>
#include <vector>

#include <orris/world/blocks/block_data.h>

namespace orris {
namespace {

constexpr NodeRow kNodes[] = {
#include <orris/world/luanti/node_table.inc>
};

/// Materials of stairs and slabs whose blocks have other names.
struct NodeMaterial {
  std::string_view node, block;
};
constexpr NodeMaterial kMaterials[] = {
#include <orris/world/luanti/node_materials.inc>
};

/// Nodes in the sixteen colours: what stands before and behind the colour, there and here.
struct NodeDye {
  std::string_view before, behind, block;
};
constexpr NodeDye kDyed[] = {
    {"wool:", "", "_wool"},
    {"mcl_wool:", "_carpet", "_carpet"},
    {"mcl_wool:", "", "_wool"},
    {"mcl_colorblocks:concrete_", "", "_concrete"},
    {"mcl_colorblocks:concrete_powder_", "", "_concrete_powder"},
    {"mcl_colorblocks:hardened_clay_", "", "_terracotta"},
    {"mcl_colorblocks:glazed_terracotta_", "", "_glazed_terracotta"},
    {"mcl_core:glass_", "", "_stained_glass"},
};
/// Minetest Game's; VoxeLibre's are those of the block, but for `silver`, which is light grey, and `grey`.
constexpr NodeMaterial kGameColours[] = {{"grey", "light_gray"}, {"dark_grey", "gray"},  {"violet", "purple"},
                                         {"dark_green", "green"}, {"green", "lime"}};
constexpr NodeMaterial kVoxelColours[] = {{"silver", "light_gray"}, {"grey", "gray"}, {"lightblue", "light_blue"}};

// Luanti: facedir_to_dir. Where the side that a node of facedir 0 turns north is: 4 down, 5 up.
constexpr std::array<const char*, 6> kFacedirSides = {"north", "east", "south", "west", "down", "up"};
constexpr std::array<int, 24> kBackOfFacedir = {0, 1, 2, 3, 4, 1, 5, 3, 5, 1, 4, 3, 0, 4, 2, 5, 0, 5, 2, 4, 0, 3, 2, 1};
constexpr int kUpsideDown = 5;  // of facedir / 4: the upper side is below

template <std::size_t N>
std::string_view translated(std::string_view word, const NodeMaterial (&words)[N]) {
  for (const NodeMaterial& known : words) {
    if (known.node == word) return known.block;
  }
  return word;
}

const NodeRow* nodeRowOf(std::string_view node) {
  static const auto rows = [] {
    std::unordered_map<std::string_view, const NodeRow*> made;
    for (const NodeRow& row : kNodes) made.emplace(row.node, &row);
    return made;
  }();
  const auto row = rows.find(node);
  return row == rows.end() ? nullptr : row->second;
}

std::optional<BlockState> knownState(const std::string& block) {
  std::optional<BlockState> state = parseBlockState(block);
  if (state && !definitionOf(state->name)) return std::nullopt;
  return state;
}

std::optional<BlockState> dyedBlock(std::string_view node) {
  for (const NodeDye& dyed : kDyed) {
    if (!node.starts_with(dyed.before) || !node.ends_with(dyed.behind)) continue;
    std::string_view colour = node.substr(dyed.before.size());
    colour.remove_suffix(std::min(colour.size(), dyed.behind.size()));
    colour = node.starts_with("mcl_") ? translated(colour, kVoxelColours) : translated(colour, kGameColours);
    if (auto state = knownState(std::string(colour) + std::string(dyed.block))) return state;
  }
  return std::nullopt;
}

/// "north" and so on; of nodes that lie on their side the nearest that a block has.
const char* backOf(int facedir) {
  const int side = kBackOfFacedir[std::size_t(facedir)];
  return kFacedirSides[std::size_t(side < 4 ? side : 0)];
}
const char* frontOf(int facedir) {
  const int side = kBackOfFacedir[std::size_t(facedir)];
  return kFacedirSides[std::size_t(side < 4 ? (side + 2) % 4 : 2)];
}

void turnState(BlockState& state, NodeTurn turn, std::uint8_t param2) {
  const int facedir = (param2 & 31) % 24;
  switch (turn) {
    case NodeTurn::None:
      break;
    case NodeTurn::Back:
      state.properties["facing"] = backOf(facedir);
      break;
    case NodeTurn::Front:
      state.properties["facing"] = frontOf(facedir);
      break;
    case NodeTurn::Axis: {
      constexpr std::array<const char*, 6> kAxes = {"y", "z", "z", "x", "x", "y"};
      state.properties["axis"] = kAxes[std::size_t(facedir / 4)];
      break;
    }
    case NodeTurn::Wall: {
      // 2 to 5: the wall is in the east, west, north, south.
      constexpr std::array<const char*, 8> kAway = {"north", "north", "west", "east", "south", "north", "north", "north"};
      state.properties["facing"] = kAway[param2 & 7];
      break;
    }
    case NodeTurn::Stairs: {
      const bool top = facedir / 4 == kUpsideDown;
      state.properties["facing"] = backOf(facedir);
      state.properties["half"] = top ? "top" : "bottom";
      // Turned over, left is right.
      const auto shape = state.properties.find("shape");
      if (top && shape != state.properties.end() && shape->second.ends_with("_left"))
        shape->second.replace(shape->second.size() - 4, 4, "right");
      break;
    }
    case NodeTurn::Slab:
      state.properties["type"] = facedir / 4 == kUpsideDown ? "top" : "bottom";
      break;
    case NodeTurn::Level: {
      const int height = param2 & 7;
      state.properties["level"] = std::to_string((param2 & 8) != 0 ? 8 : std::clamp(8 - height, 1, 7));
      break;
    }
    case NodeTurn::Pane:
      for (const char* side : facedir % 2 == 0 ? std::array{"east", "west"} : std::array{"north", "south"})
        state.properties[side] = "true";
      break;
  }
}

bool takePrefix(std::string_view& text, std::string_view prefix) {
  if (!text.starts_with(prefix)) return false;
  text.remove_prefix(prefix.size());
  return true;
}
bool takeSuffix(std::string_view& text, std::string_view suffix) {
  if (!text.ends_with(suffix)) return false;
  text.remove_suffix(suffix.size());
  return true;
}

/// Stairs and slabs of all materials: "stairs:stair_inner_cobble", "mcl_stairs:slab_cobble_top".
std::optional<BlockState> stepBlock(std::string_view node, std::uint8_t param2) {
  if (!takePrefix(node, "stairs:") && !takePrefix(node, "mcl_stairs:") && !takePrefix(node, "moreblocks:"))
    return std::nullopt;
  const bool slab = takePrefix(node, "slab_");
  if (!slab && !takePrefix(node, "stair_")) return std::nullopt;
  std::string type, shape;
  if (slab && takeSuffix(node, "_top")) type = "top";
  if (slab && takeSuffix(node, "_double")) type = "double";
  if (!slab && (takePrefix(node, "inner_") || takeSuffix(node, "_inner"))) shape = "inner_left";
  if (!slab && (takePrefix(node, "outer_") || takeSuffix(node, "_outer"))) shape = "outer_left";
  const std::string material(translated(node, kMaterials));
  auto state = knownState(material + (slab ? "_slab" : "_stairs"));
  if (!state) return std::nullopt;
  if (!shape.empty()) state->properties["shape"] = shape;
  turnState(*state, slab ? NodeTurn::Slab : NodeTurn::Stairs, param2);
  if (!type.empty()) state->properties["type"] = type;
  return state;
}

/// Mineclonia and VoxeLibre keep most of the names: what stands behind the colon.
std::optional<BlockState> sameName(std::string_view node) {
  if (!node.starts_with("mcl_")) return std::nullopt;
  return knownState(std::string(node.substr(node.find(':') + 1)));
}

/// Wood of Mineclonia: "mcl_trees:leaves_oak".
std::optional<BlockState> treeBlock(std::string_view node, std::uint8_t param2) {
  struct TreePart {
    std::string_view before, before2, behind;
    NodeTurn turn;
  };
  constexpr TreePart kTreeParts[] = {
      {"tree_", "", "_log", NodeTurn::Axis},         {"bark_stripped_", "stripped_", "_wood", NodeTurn::Axis},
      {"bark_", "", "_wood", NodeTurn::Axis},        {"stripped_", "stripped_", "_log", NodeTurn::Axis},
      {"wood_", "", "_planks", NodeTurn::None},      {"leaves_", "", "_leaves", NodeTurn::None},
      {"sapling_", "", "_sapling", NodeTurn::None},
  };
  if (!takePrefix(node, "mcl_trees:")) return std::nullopt;
  for (const TreePart& part : kTreeParts) {
    std::string_view tree = node;
    if (!takePrefix(tree, part.before)) continue;
    takeSuffix(tree, "_orphan");
    auto state = knownState(std::string(part.before2) + std::string(tree) + std::string(part.behind));
    if (state) turnState(*state, part.turn, param2);
    return state;
  }
  return std::nullopt;
}

}  // namespace

std::span<const NodeRow> nodeRows() { return kNodes; }

std::optional<BlockState> blockOfNode(std::string_view node, std::uint8_t param2) {
  if (const NodeRow* row = nodeRowOf(node)) {
    std::optional<BlockState> state = parseBlockState(row->block);
    if (state) turnState(*state, row->turn, param2);
    return state;
  }
  if (auto state = stepBlock(node, param2)) return state;
  if (auto state = dyedBlock(node)) return state;
  if (auto state = treeBlock(node, param2)) return state;
  return sameName(node);
}

}  // namespace orris
