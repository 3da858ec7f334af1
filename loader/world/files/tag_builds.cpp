#include <orris/world/files/tag_builds.h>

#include <fmt/core.h>

#include <algorithm>
#include <limits>

#include <orris/world/blocks/neighbour_joins.h>
#include <orris/world/saves/block_palette.h>
#include <orris/world/saves/legacy_blocks.h>
#include <orris/world/saves/packed_indices.h>

namespace orris {
namespace {

constexpr std::int64_t kFarthestRegion = 1 << 24;    // blocks from the origin
constexpr int kLitematicBits = 2;                    // at least, of an index
using BuildBox = std::pair<glm::ivec3, glm::ivec3>;  // lowest and highest cell

std::nullopt_t refuse(std::string& problem, std::string why) {
  problem = std::move(why);
  return std::nullopt;
}

/// Three integers: a list, or the members x, y and z.
std::optional<glm::i64vec3> tripleOf(const NbtTag* tag) {
  const char* const names[] = {"x", "y", "z"};
  const NbtList* list = tag ? std::get_if<NbtList>(&tag->value) : nullptr;
  if (list && list->size() != 3) return std::nullopt;
  glm::i64vec3 triple{0};
  for (int axis = 0; axis < 3; ++axis) {
    const NbtTag* item = list  ? &(*list)[std::size_t(axis)]
                         : tag ? tag->find(names[axis])
                               : nullptr;
    if (!item || !item->integer()) return std::nullopt;
    triple[axis] = *item->integer();
  }
  return triple;
}

bool checkBox(glm::i64vec3 size, std::int64_t maximum, std::string& problem) {
  for (int axis = 0; axis < 3; ++axis) {
    if (size[axis] >= 1 && size[axis] <= kMaxWorldSize) continue;
    problem = fmt::format("{} x {} x {} blocks: expected 1 to {} along each axis", size.x, size.y,
                          size.z, kMaxWorldSize);
    return false;
  }
  if (size.x * size.y * size.z <= maximum) return true;
  problem = fmt::format("{} blocks: expected at most {}", size.x * size.y * size.z, maximum);
  return false;
}

/// The world's index of each entry of a palette.
std::optional<std::vector<std::uint32_t>> paletteOf(const NbtTag* tag, BlockWorld& world,
                                                    std::string& problem) {
  const NbtList* list = tag ? std::get_if<NbtList>(&tag->value) : nullptr;
  if (!list || list->empty()) return refuse(problem, "no palette of block states");
  std::vector<std::uint32_t> palette;
  for (const NbtTag& entry : *list) {
    const auto state = stateOfTag(entry, problem);
    if (!state) return std::nullopt;
    palette.push_back(world.paletteIndex(*state));
    if (palette.back() + 1 >= kMaxPalette)
      return refuse(problem, fmt::format("more than {} block states", kMaxPalette - 2));
  }
  return palette;
}

/// Structures of ruins have several palettes; the first is taken.
const NbtTag* structurePalette(const NbtTag& root) {
  if (const NbtTag* palette = root.find("palette")) return palette;
  const NbtTag* palettes = root.find("palettes");
  const NbtList* list = palettes ? std::get_if<NbtList>(&palettes->value) : nullptr;
  return list && !list->empty() ? &list->front() : nullptr;
}

std::optional<BlockWorld> readStructure(const NbtTag& root, std::int64_t maximum,
                                        std::string& problem) {
  const auto size = tripleOf(root.find("size"));
  if (!size) return refuse(problem, "no \"size\" of three integers");
  if (!checkBox(*size, maximum, problem)) return std::nullopt;
  BlockWorld world(glm::ivec3(0), glm::ivec3(*size));
  const auto palette = paletteOf(structurePalette(root), world, problem);
  if (!palette) return std::nullopt;
  for (const NbtTag& block : std::get<NbtList>(root.find("blocks")->value)) {
    const auto at = tripleOf(block.find("pos"));
    const NbtTag* state = block.find("state");
    if (!at || !state || !state->integer())
      return refuse(problem, "a block has no \"pos\" and \"state\"");
    const bool inside = glm::all(glm::greaterThanEqual(*at, glm::i64vec3(0))) &&
                        glm::all(glm::lessThan(*at, *size));
    if (!inside)
      return refuse(
          problem, fmt::format("block ({}, {}, {}) lies outside of the size", at->x, at->y, at->z));
    const std::int64_t index = *state->integer();
    if (index < 0 || index >= std::int64_t(palette->size()))
      return refuse(problem,
                    fmt::format("block ({}, {}, {}) has palette index {}: expected 0 to {}", at->x,
                                at->y, at->z, index, palette->size() - 1));
    world.set(glm::ivec3(*at), (*palette)[std::size_t(index)]);
  }
  return world;
}

/// A side may be negative: the region then extends from its position the other direction.
std::optional<BuildBox> boxOfRegion(const NbtTag& region) {
  const auto position = tripleOf(region.find("Position")), size = tripleOf(region.find("Size"));
  if (!position || !size) return std::nullopt;
  BuildBox box;
  for (int axis = 0; axis < 3; ++axis) {
    const std::int64_t from = (*position)[axis], length = (*size)[axis];
    if (length == 0 || std::abs(length) > kMaxWorldSize || std::abs(from) > kFarthestRegion)
      return std::nullopt;
    box.first[axis] = int(length > 0 ? from : from + length + 1);
    box.second[axis] = int(length > 0 ? from + length - 1 : from);
  }
  return box;
}

bool placeRegion(const NbtTag& region, const BuildBox& box, glm::ivec3 shift, BlockWorld& world,
                 std::string& problem) {
  const auto palette = paletteOf(region.find("BlockStatePalette"), world, problem);
  if (!palette) return false;
  const NbtTag* states = region.find("BlockStates");
  const auto* numbers = states ? std::get_if<std::vector<std::int64_t>>(&states->value) : nullptr;
  const glm::ivec3 size = box.second - box.first + 1;
  const std::size_t count = std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z);
  const int bits = indexBits(palette->size(), kLitematicBits);
  if (!numbers || numbers->size() < PackedIndices::numbersFor(count, bits, true)) {
    problem = fmt::format("\"BlockStates\" has {} numbers: expected {} for {} blocks",
                          numbers ? numbers->size() : 0,
                          PackedIndices::numbersFor(count, bits, true), count);
    return false;
  }
  const PackedIndices indices(*numbers, bits, true);
  std::size_t i = 0;
  for (int y = 0; y < size.y; ++y)
    for (int z = 0; z < size.z; ++z)
      for (int x = 0; x < size.x; ++x, ++i) {
        const std::uint32_t index = indices.at(i);
        if (index >= palette->size()) {
          problem = fmt::format("a block has palette index {}: expected 0 to {}", index,
                                palette->size() - 1);
          return false;
        }
        world.set(box.first + glm::ivec3(x, y, z) - shift, (*palette)[index]);
      }
  return true;
}

std::optional<BlockWorld> readLitematic(const NbtTag& root, std::int64_t maximum,
                                        std::string& problem) {
  const NbtCompound& regions = *root.find("Regions")->compound();
  if (regions.empty()) return refuse(problem, "no regions");
  std::vector<BuildBox> boxes;
  glm::ivec3 low(std::numeric_limits<int>::max()), high(std::numeric_limits<int>::min());
  std::int64_t total = 0;
  for (const auto& [name, region] : regions) {
    const auto box = boxOfRegion(region);
    if (!box)
      return refuse(
          problem,
          fmt::format("the region \"{}\" has no \"Position\" and \"Size\" of 1 to {} blocks",
                      name.substr(0, 100), kMaxWorldSize));
    low = glm::min(low, box->first);
    high = glm::max(high, box->second);
    const glm::i64vec3 size(box->second - box->first + 1);
    total += size.x * size.y * size.z;
    boxes.push_back(*box);
  }
  const glm::i64vec3 size(high - low + 1);
  if (!checkBox(size, maximum, problem)) return std::nullopt;
  if (total > 2 * maximum)
    return refuse(problem, fmt::format("its regions have {} blocks: expected at most {}", total,
                                       2 * maximum));
  BlockWorld world(glm::ivec3(0), glm::ivec3(size));
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (placeRegion(regions[i].second, boxes[i], low, world, problem)) continue;
    return refuse(problem,
                  fmt::format("region \"{}\": {}", regions[i].first.substr(0, 100), problem));
  }
  return world;
}

const std::string* bytesOf(const NbtTag& root, const char* name, std::size_t least) {
  const NbtTag* tag = root.find(name);
  return tag && tag->bytes() && tag->bytes()->bytes.size() >= least ? &tag->bytes()->bytes
                                                                    : nullptr;
}

std::optional<BlockWorld> readNumericSchematic(const NbtTag& root, std::int64_t maximum,
                                               std::string& problem) {
  glm::i64vec3 size{0};
  const char* const names[] = {"Width", "Height", "Length"};
  for (int axis = 0; axis < 3; ++axis) {
    const NbtTag* tag = root.find(names[axis]);
    if (!tag || !tag->integer())
      return refuse(problem, fmt::format("no integer \"{}\"", names[axis]));
    size[axis] = *tag->integer();
  }
  if (!checkBox(size, maximum, problem)) return std::nullopt;
  const auto count = std::size_t(size.x * size.y * size.z);
  const std::string *ids = bytesOf(root, "Blocks", count), *data = bytesOf(root, "Data", count);
  if (!ids || !data)
    return refuse(problem,
                  fmt::format("\"Blocks\" and \"Data\" have fewer than {} bytes each", count));
  const std::string* more = bytesOf(root, "AddBlocks", (count + 1) / 2);
  BlockWorld world(glm::ivec3(0), glm::ivec3(size));
  std::vector<std::uint32_t> known(1 << 16, std::numeric_limits<std::uint32_t>::max());
  std::size_t i = 0;
  for (int y = 0; y < size.y; ++y)
    for (int z = 0; z < size.z; ++z)
      for (int x = 0; x < size.x; ++x, ++i) {
        const int upper = more ? std::uint8_t((*more)[i / 2]) >> (i % 2 * 4) & 15 : 0;
        const int id = upper << 8 | std::uint8_t((*ids)[i]), value = (*data)[i] & 15;
        std::uint32_t& index = known[std::size_t(id << 4 | value)];
        if (index == std::numeric_limits<std::uint32_t>::max())
          index = world.paletteIndex(legacyState(id, value));
        world.set({x, y, z}, index);
      }
  completeParts(world);
  joinSides(world);
  return world;
}

}  // namespace

BuildFormat buildFormatOf(const NbtTag& root) {
  const NbtTag *regions = root.find("Regions"), *listed = root.find("blocks"),
               *ids = root.find("Blocks");
  if (regions && regions->compound()) return BuildFormat::Litematic;
  if (listed && std::get_if<NbtList>(&listed->value)) return BuildFormat::Structure;
  if (ids && ids->bytes() && !root.find("Version")) return BuildFormat::Numeric;
  return BuildFormat::Sponge;
}

std::optional<BlockWorld> readBuild(const NbtTag& root, BuildFormat format, std::int64_t maximum,
                                    std::string& problem) {
  switch (format) {
    case BuildFormat::Structure:
      return readStructure(root, maximum, problem);
    case BuildFormat::Litematic:
      return readLitematic(root, maximum, problem);
    case BuildFormat::Numeric:
      return readNumericSchematic(root, maximum, problem);
    case BuildFormat::Sponge:
      break;  // another reader's
  }
  return refuse(problem, "a Sponge schematic");
}

}  // namespace orris
