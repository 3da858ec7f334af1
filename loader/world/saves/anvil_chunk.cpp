#include <orris/world/saves/anvil_chunk.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <map>

#include <orris/world/blocks/block_world.h>
#include <orris/world/files/nbt.h>
#include <orris/world/saves/block_palette.h>
#include <orris/world/saves/legacy_blocks.h>
#include <orris/world/saves/packed_indices.h>

namespace orris {
namespace {

constexpr std::size_t kBiomeParts = 4 * 4 * 4;
constexpr std::size_t kSectionPalette = kSectionBlocks;
constexpr int kMostBits = 16;
constexpr int kLowestSection = -128, kHighestSection = 127;  // a byte
// The stages of generation after which nothing more changes; 1.13 called them otherwise.
constexpr std::array<std::string_view, 4> kFinished = {"full", "minecraft:full", "fullchunk",
                                                       "postprocessed"};

const std::vector<std::int64_t>* numbersOf(const NbtTag& parent, std::string_view name) {
  const NbtTag* tag = parent.find(name);
  return tag ? std::get_if<std::vector<std::int64_t>>(&tag->value) : nullptr;
}

struct ChunkReader {
  AnvilChunk& chunk;
  std::string& problem;
  StateList states;
  std::map<int, AnvilSection> sections;

  bool fail(std::string why) {
    problem = std::move(why);
    return false;
  }

  bool readPalette(const NbtList& list, std::vector<std::uint16_t>& palette) {
    if (list.empty()) return fail("the palette of a section is empty");
    if (list.size() > kSectionPalette)
      return fail(fmt::format("the palette of a section has {} states: expected at most {}",
                              list.size(), kSectionPalette));
    for (const NbtTag& entry : list) {
      const std::optional<BlockState> state = stateOfTag(entry, problem);
      if (!state) return false;
      const std::uint32_t index = states.indexOf(*state);
      if (index >= kMaxPalette) return fail(fmt::format("more than {} block states", kMaxPalette));
      palette.push_back(std::uint16_t(index));
    }
    return true;
  }

  /// How many numbers there are says how they are packed: sizes differ where it matters.
  bool readCells(const std::vector<std::int64_t>& numbers,
                 const std::vector<std::uint16_t>& palette, AnvilSection& section) {
    int bits = indexBits(palette.size(), 4);
    const bool within = numbers.size() == PackedIndices::numbersFor(kSectionBlocks, bits, false);
    const std::size_t across = PackedIndices::numbersFor(kSectionBlocks, bits, true);
    // Games before 1.16 may write more bits than the palette needs.
    if (!within && numbers.size() > across && numbers.size() % 64 == 0)
      bits = int(numbers.size() / 64);
    const bool fits =
        within || numbers.size() == PackedIndices::numbersFor(kSectionBlocks, bits, true);
    if (!fits || bits > kMostBits)
      return fail(fmt::format("the blocks of section {} take {} numbers: expected {} for {} states",
                              section.y, numbers.size(), across, palette.size()));
    const PackedIndices indices(numbers, bits, !within);
    section.cells.resize(kSectionBlocks);
    for (std::size_t i = 0; i < kSectionBlocks; ++i) {
      const std::uint32_t index = indices.at(i);
      if (index >= palette.size())
        return fail(fmt::format("a block of section {} has palette index {}: expected 0 to {}",
                                section.y, index, palette.size() - 1));
      section.cells[i] = palette[index];
    }
    return true;
  }

  bool readPaletted(const NbtList& list, const std::vector<std::int64_t>* numbers,
                    AnvilSection& section) {
    std::vector<std::uint16_t> palette;
    if (!readPalette(list, palette)) return false;
    section.only = palette[0];
    const bool single = palette.size() == 1 && (!numbers || numbers->empty());
    if (single) return true;
    if (!numbers) return fail(fmt::format("section {} has a palette but no blocks", section.y));
    return readCells(*numbers, palette, section);
  }

  /// Of 1.12 and before: a byte a block, four bits of data, and four more bits of ids that mods add.
  bool readNumeric(const NbtTag& tag, const NbtBytes& blocks, AnvilSection& section) {
    const auto nibbles = [&](std::string_view name) {
      const NbtTag* member = tag.find(name);
      const NbtBytes* bytes = member ? member->bytes() : nullptr;
      return bytes && bytes->bytes.size() == kSectionBlocks / 2 ? &bytes->bytes : nullptr;
    };
    const std::string *data = nibbles("Data"), *add = nibbles("Add");
    if (blocks.bytes.size() != kSectionBlocks || !data)
      return fail(
          fmt::format("section {} has no {} blocks with their data", section.y, kSectionBlocks));
    const auto nibble = [](const std::string* bytes, std::size_t i) {
      return bytes ? std::uint8_t((*bytes)[i / 2]) >> (i % 2 * 4) & 15 : 0;
    };
    section.cells.resize(kSectionBlocks);
    std::map<int, std::uint16_t> known;
    for (std::size_t i = 0; i < kSectionBlocks; ++i) {
      const int id = nibble(add, i) << 8 | std::uint8_t(blocks.bytes[i]), meta = nibble(data, i);
      const auto [entry, added] = known.emplace(id << 4 | meta, std::uint16_t(0));
      if (added) entry->second = std::uint16_t(states.indexOf(legacyState(id, meta)));
      section.cells[i] = entry->second;
    }
    return true;
  }

  void readBiomes(const NbtTag& tag, AnvilSection& section) {
    const NbtTag* biomes = tag.find("biomes");
    const NbtList* list = biomes ? biomes->listAt("palette") : nullptr;
    if (!list || list->empty() || list->size() > kBiomeParts) return;
    std::vector<std::string> names;
    for (const NbtTag& name : *list) names.push_back(name.string() ? *name.string() : "");
    const std::vector<std::int64_t>* numbers = numbersOf(*biomes, "data");
    const int bits = indexBits(names.size(), 1);
    if (!numbers || numbers->size() != PackedIndices::numbersFor(kBiomeParts, bits, false)) {
      section.biomes = {names.front()};
      return;
    }
    const PackedIndices indices(*numbers, bits, false);
    for (std::size_t i = 0; i < kBiomeParts; ++i)
      section.biomes.push_back(names[std::min<std::size_t>(indices.at(i), names.size() - 1)]);
  }

  bool readSection(const NbtTag& tag) {
    const NbtTag* y = tag.find("Y");
    if (!y || !y->integer() || *y->integer() < kLowestSection || *y->integer() > kHighestSection)
      return fail("a section has no \"Y\" from -128 to 127");
    AnvilSection section{int(*y->integer()), {}, 0, {}};
    const NbtTag* states18 = tag.find("block_states");
    const NbtTag& holder = states18 ? *states18 : tag;
    const NbtTag* blocks = tag.find("Blocks");
    if (const NbtList* palette = holder.listAt(states18 ? "palette" : "Palette")) {
      if (!readPaletted(*palette, numbersOf(holder, states18 ? "data" : "BlockStates"), section))
        return false;
    } else if (blocks && blocks->bytes()) {
      if (!readNumeric(tag, *blocks->bytes(), section)) return false;
    } else {
      return true;  // light alone
    }
    readBiomes(tag, section);
    sections[section.y] = std::move(section);
    return true;
  }

  bool readAll(const NbtList& list) {
    if (list.size() > 256)
      return fail(fmt::format("{} sections: expected at most 256", list.size()));
    for (const NbtTag& tag : list) {
      if (!readSection(tag)) return false;
    }
    chunk.palette = states.take();
    for (auto& [y, section] : sections) chunk.sections.push_back(std::move(section));
    return true;
  }
};

}  // namespace

ChunkOutcome parseAnvilChunk(std::string_view tags, AnvilChunk& chunk, std::string& problem) {
  NbtError error;
  const std::optional<NbtTag> root = parseNbt(tags, error);
  if (!root) {
    problem = error.message;
    return ChunkOutcome::Unreadable;
  }
  if (const NbtTag* version = root->find("DataVersion"); version && version->integer())
    chunk.dataVersion = int(*version->integer());
  const NbtTag* level = root->find("Level");
  const NbtTag& holder = level ? *level : *root;
  const NbtTag* status = holder.find("Status");
  if (status && status->string() &&
      std::find(kFinished.begin(), kFinished.end(), *status->string()) == kFinished.end())
    return ChunkOutcome::Unfinished;
  const NbtList* sections = holder.listAt("sections");
  if (!sections) sections = holder.listAt("Sections");
  if (!sections) {
    problem = "it has no list of sections";
    return ChunkOutcome::Unreadable;
  }
  ChunkReader reader{chunk, problem, {}, {}};
  if (!reader.readAll(*sections)) return ChunkOutcome::Unreadable;
  const NbtList* blockEntities = holder.listAt(level ? "TileEntities" : "block_entities");
  if (blockEntities) readSigns(*blockEntities, chunk.things);
  // Of 1.17 and later they lie in files of their own.
  if (const NbtList* entities = holder.listAt("Entities")) readEntities(*entities, chunk.things);
  return ChunkOutcome::Read;
}

}  // namespace orris
