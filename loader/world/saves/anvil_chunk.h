// One chunk of a save: its blocks, and what it holds besides them.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

#include <orris/world/blocks/block_state.h>
#include <orris/world/saved_things/saved_things.h>

namespace orris {

/// 16x16x16 blocks by the chunk's palette.
struct AnvilSection {
  int y = 0;                         ///< in sections
  std::vector<std::uint16_t> cells;  ///< x fastest, then z, then y; empty: all are `only`
  std::uint16_t only = 0;
  std::vector<std::string> biomes;  ///< of its 4x4x4 parts in the same order, or one for all
};

struct AnvilChunk {
  int dataVersion = 0;
  std::vector<BlockState> palette;  ///< 0 is air
  std::vector<AnvilSection>
      sections;  ///< ascending, each y once; those without blocks are left out
  SavedThings things;  ///< its signs, and before 1.17 its entities
};

enum class ChunkOutcome {
  Read,
  Unfinished,  ///< the game has begun to generate it, no more
  Unreadable,
};

/// `tags` are decompressed. Of two sections at one height the later is taken, as the game does.
/// Unreadable: `problem` says why, and `chunk` is of no use.
ChunkOutcome parseAnvilChunk(std::string_view tags, AnvilChunk& chunk, std::string& problem);

}  // namespace orris
