// A box of blocks by palette. Coordinates are world blocks, x east, y up, z south, as in the game.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <vector>

#include "world/blocks/block_state.h"

namespace orris {

constexpr int kMaxWorldSize = 512;  ///< blocks an axis
constexpr std::int64_t kMaxWorldBlocks = std::int64_t(1) << 27;
constexpr std::size_t kMaxPalette = 65535;  ///< a vertex names its state in 16 bits

/// Palette entry 0 is always minecraft:air; outside the box everything is air.
class BlockWorld {
 public:
  BlockWorld() : BlockWorld(glm::ivec3(0), glm::ivec3(0)) {}
  BlockWorld(glm::ivec3 origin, glm::ivec3 size);

  glm::ivec3 origin() const { return origin_; }
  glm::ivec3 size() const { return size_; }
  bool contains(glm::ivec3 p) const;
  /// Palette index at `p`; 0 outside.
  std::uint32_t indexAt(glm::ivec3 p) const;
  const BlockState& at(glm::ivec3 p) const { return palette_[indexAt(p)]; }
  /// Index of `state`, added when new.
  std::uint32_t paletteIndex(const BlockState& state);
  const std::vector<BlockState>& palette() const { return palette_; }
  /// Ignored outside the box.
  void set(glm::ivec3 p, std::uint32_t paletteIndex);
  void fill(glm::ivec3 from, glm::ivec3 to, std::uint32_t paletteIndex);  ///< both inclusive

 private:
  std::size_t offset(glm::ivec3 p) const;
  glm::ivec3 origin_, size_;
  std::vector<BlockState> palette_;
  std::map<BlockState, std::uint32_t> indexOf_;
  std::vector<std::uint32_t> blocks_;
};

}  // namespace orris
