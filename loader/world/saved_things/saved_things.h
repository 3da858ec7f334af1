// What the chunks of a save hold besides blocks: entities and the texts of signs.
#pragma once

#include <orris/world/content/content.h>
#include <orris/world/files/nbt.h>

#include <array>
#include <cstddef>
#include <glm/glm.hpp>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace orris {

/// One side of a sign.
struct SignSide {
  std::array<std::string, 4> lines;  ///< as drawn, the topmost first
  glm::vec3 color{0};
};

struct SavedSign {
  glm::ivec3 at{0};
  SignSide front, back;
};

struct SavedThings {
  std::vector<Entity> entities;
  std::vector<SavedSign> signs;                   ///< those with a text
  std::map<std::string, std::size_t> figureless;  ///< entities by kind that no figure of ours shows
  std::size_t damaged = 0;           ///< entities and signs without a sane kind or place
  std::size_t tooFar = 0;            ///< those that keepNearest() left out
  std::size_t unreadableChunks = 0;  ///< of entities
  std::string problem;               ///< of the first of these
};

/// Adds the entities of a list, and those that ride on them.
void readEntities(const NbtList& list, SavedThings& things);
/// The same of a chunk of the folder `entities` (1.17 and later), decompressed. An unreadable one is
/// counted.
void readEntityChunk(std::string_view tags, SavedThings& things);
/// Adds the signs of a list of block entities.
void readSigns(const NbtList& list, SavedThings& things);

/// Leaves limits::kWorldThings entities and as many signs, those nearest to `middle` (x and z).
void keepNearest(SavedThings& things, glm::dvec2 middle);
/// Appends `more` to `things`.
void join(SavedThings& things, SavedThings&& more);

/// The texts of a sign on the block `state`, in front of its board; none where that is no sign.
std::vector<BlockText> textsOf(const SavedSign& sign, const BlockState& state);

}  // namespace orris
