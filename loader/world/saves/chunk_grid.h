// The chunks around a place of a save, and the box of blocks that they make.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include <orris/world/blocks/block_world.h>
#include <orris/world/saves/anvil_chunk.h>
#include <orris/world/saves/save_files.h>

namespace orris {

/// What became of one chunk that was asked for.
struct PlacedChunk {
  enum class State { Absent, Unfinished, Unreadable, Read };
  glm::ivec2 at{0};  ///< in chunks
  State state = State::Absent;
  AnvilChunk chunk;     ///< when read
  std::string problem;  ///< when unreadable
};

/// The chunk in the middle of what the regions hold, by the room that their tables give each: chunks
/// that the game has finished take more. nullopt when there is none.
std::optional<glm::ivec2> middleOfRegions(const SaveFiles& files);

/// The chunks of the square of `radius` chunks around `middle`, by row; read by all cores. `things`:
/// what they hold besides blocks, the nearest to the middle of that chunk.
std::vector<PlacedChunk> readChunks(const SaveFiles& files, glm::ivec2 middle, int radius,
                                    SavedThings& things);

/// Those that were read as one box, from the lowest to the highest section that holds a block; at most
/// kMaxWorldSize blocks high, around the height `eye`. `chunks` lose their cells. nullopt and why not.
std::optional<BlockWorld> joinChunks(std::vector<PlacedChunk>& chunks, double eye,
                                     std::string& problem);

/// The biome at a place, "" where no chunk says.
std::string biomeAt(const std::vector<PlacedChunk>& chunks, glm::ivec3 cell);

}  // namespace orris
