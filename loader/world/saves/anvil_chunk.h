// The blocks of one chunk of a save, as the game of 1.13 and later writes them.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

#include <orris/world/blocks/block_state.h>

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
