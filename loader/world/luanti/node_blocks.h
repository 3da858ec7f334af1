// Which block a node of a Luanti world is drawn as.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <orris/world/blocks/block_state.h>

namespace orris {

/// What a node's param2 says of the block. Directions keep their names: north is +z in Luanti and -z here.
enum class NodeTurn : std::uint8_t {
  None,
  Back,    ///< facedir: `facing` is where its back is (stairs, doors, beds)
  Front,   ///< facedir: `facing` is where its front is (furnaces, chests)
  Axis,    ///< facedir: `axis`
  Wall,    ///< wallmounted: `facing` is away from the wall
  Stairs,  ///< as Back, and `half`
  Slab,    ///< facedir: `type`
  Level,   ///< flowing liquid: `level`
  Pane,    ///< facedir: the two sides that it reaches
};

/// A row of the table, node_table.inc.
struct NodeRow {
  std::string_view node, block;  ///< "default:tree", "oak_log": with properties, without namespace
  NodeTurn turn = NodeTurn::None;
};
std::span<const NodeRow> nodeRows();

/// Drawn for nodes that nothing is known of.
inline constexpr const char* kUnknownNodeBlock = "minecraft:light_gray_concrete";

/// nullopt: nothing is known of this node.
std::optional<BlockState> blockOfNode(std::string_view node, std::uint8_t param2);

}  // namespace orris
