#include <orris/world/files/world_json_blocks.h>

#include <fmt/core.h>

#include <map>

#include <orris/core/limits.h>
#include <orris/core/files/pack_path.h>
#include <orris/world/files/schematic.h>
#include <orris/world/terrain.h>

namespace orris {
namespace {

constexpr char kAir = '.', kKeep = ' ';

// As many written blocks take about the time of a generated one, and of opening a file.
constexpr std::int64_t kGeneratorWork = 4, kFileWork = 20'000;

class BlockOperations {
 public:
  BlockOperations(JsonReader& reader, const JsonNode& root, const WorldJson& json)
      : reader_(reader), root_(root), json_(json) {}

  std::optional<BlockWorld> run() {
    std::optional<BlockWorld> world = makeBox();
    if (!world) return std::nullopt;
    readPalette(*world);
    const JsonNode* blocks = root_.find("blocks");
    if (blocks && reader_.array(*blocks, "\"blocks\"")) {
      for (const JsonNode& node : blocks->items) {
        if (work_ > std::int64_t(limits::kWorldWork)) break;
        apply(node, *world);
      }
    }
    return world;
  }

 private:
  using Operation = void (BlockOperations::*)(const JsonNode&, BlockWorld&);
  struct OperationInfo {
    const char* key;
    std::vector<std::string> keys;
    Operation apply;
  };
  struct Box {
    glm::ivec3 low, high;
  };

  static const std::vector<OperationInfo>& operations() {
    static const std::vector<OperationInfo> table = {
        {"box", {"box", "min", "max"}, &BlockOperations::applyBox},
        {"hollow", {"hollow", "min", "max"}, &BlockOperations::applyHollow},
        {"replace", {"replace", "with", "min", "max"}, &BlockOperations::applyReplace},
        {"block", {"block", "at"}, &BlockOperations::applyBlock},
        {"layers", {"layers", "at"}, &BlockOperations::applyLayers},
        {"from", {"from", "at"}, &BlockOperations::applyFile},
        {"generate", {"generate"}, &BlockOperations::applyGenerator},
    };
    return table;
  }

  std::optional<BlockWorld> makeBox() {
    glm::ivec3 origin{0};
    if (const JsonNode* node = root_.find("origin")) {
      const std::optional<glm::ivec3> value = reader_.cell(*node, "\"origin\"", kCellRange);
      if (!value) return std::nullopt;
      origin = *value;
    }
    const JsonNode* from = root_.find("from");
    std::optional<BlockWorld> file;
    if (from && !(file = readFile(*from))) return std::nullopt;
    glm::ivec3 size = file ? file->size() : glm::ivec3(0);
    if (!file || root_.find("size")) {
      const std::optional<glm::ivec3> value = readSize();
      if (!value) return std::nullopt;
      size = *value;
    }
    BlockWorld world(origin, size);
    if (file) copy(*file, origin, world);
    return world;
  }

  std::optional<glm::ivec3> readSize() {
    const JsonNode* node = reader_.required(root_, "size", "the world");
    if (!node) return std::nullopt;
    const std::optional<glm::ivec3> size = reader_.cell(*node, "\"size\"", {1, kMaxWorldSize});
    if (!size) return std::nullopt;
    const std::int64_t blocks = std::int64_t(size->x) * size->y * size->z;
    if (blocks <= json_.maximumBlocks) return size;
    reader_.error(node->offset, fmt::format("\"size\" makes {} blocks: expected at most {}", blocks,
                                            json_.maximumBlocks));
    return std::nullopt;
  }

  void readPalette(BlockWorld& world) {
    palette_[kAir] = 0;
    const JsonNode* node = root_.find("palette");
    if (!node) return;
    if (node->kind != JsonNode::Kind::Object) {
      reader_.object(*node, "\"palette\"", {});
      return;
    }
    for (const JsonMember& entry : node->members) {
      const bool printable = entry.key.size() == 1 && entry.key[0] > ' ' && entry.key[0] < 127;
      if (!printable || entry.key[0] == kAir) {
        reader_.error(entry.offset,
                      fmt::format("the palette key \"{}\" is not one printable ASCII character "
                                  "other than space and \".\"",
                                  entry.key));
        continue;
      }
      const std::string what = fmt::format("the palette entry \"{}\"", entry.key);
      if (const auto state = reader_.block(entry.value, what)) {
        palette_[entry.key[0]] = world.paletteIndex(*state);
      }
    }
  }

  void apply(const JsonNode& node, BlockWorld& world) {
    std::string known;
    for (const OperationInfo& operation : operations()) {
      if (node.find(operation.key)) {
        if (reader_.object(node, fmt::format("\"{}\"", operation.key), operation.keys)) {
          (this->*operation.apply)(node, world);
        }
        return;
      }
      known += fmt::format("{}\"{}\"", known.empty() ? "" : ", ", operation.key);
    }
    reader_.error(node.offset, "an operation of \"blocks\" is an object with one of " + known);
  }

  std::optional<std::uint32_t> blockIndex(const JsonNode& node, const char* key,
                                          BlockWorld& world) {
    const JsonNode* value = reader_.required(node, key, "the operation");
    const auto state = value ? reader_.block(*value, fmt::format("\"{}\"", key)) : std::nullopt;
    return state ? std::optional(world.paletteIndex(*state)) : std::nullopt;
  }

  std::optional<glm::ivec3> corner(const JsonNode& node, const char* key, const BlockWorld& world) {
    const std::string what = fmt::format("\"{}\"", key);
    const std::optional<glm::ivec3> value = reader_.cell(node, what, kCellRange);
    if (!value || world.contains(*value)) return value;
    const glm::ivec3 low = world.origin(), high = low + world.size() - 1;
    reader_.error(node.offset,
                  fmt::format("{} ({}, {}, {}) is outside the world: expected ({}, {}, {}) to "
                              "({}, {}, {})",
                              what, value->x, value->y, value->z, low.x, low.y, low.z, high.x,
                              high.y, high.z));
    return std::nullopt;
  }

  /// "min" and "max"; the whole world for an operation that may go without.
  std::optional<Box> box(const JsonNode& node, const BlockWorld& world, bool needed) {
    if (!needed && !node.find("min") && !node.find("max")) {
      return Box{world.origin(), world.origin() + world.size() - 1};
    }
    const JsonNode* min = reader_.required(node, "min", "the operation");
    const JsonNode* max = reader_.required(node, "max", "the operation");
    if (!min || !max) return std::nullopt;
    const auto low = corner(*min, "min", world), high = corner(*max, "max", world);
    if (!low || !high) return std::nullopt;
    if (low->x <= high->x && low->y <= high->y && low->z <= high->z) return Box{*low, *high};
    reader_.error(max->offset, "\"max\" is below \"min\" on an axis");
    return std::nullopt;
  }

  static std::int64_t volume(glm::ivec3 size) { return std::int64_t(size.x) * size.y * size.z; }
  static std::int64_t volume(const Box& box) { return volume(box.high - box.low + 1); }

  /// False and an error when the operations up to `node` are more work than a world may be.
  bool spend(const JsonNode& node, std::int64_t blocks) {
    work_ += blocks;
    if (work_ <= std::int64_t(limits::kWorldWork)) return true;
    reader_.error(node.offset,
                  fmt::format("the operations up to this one write more than {} blocks in all; it "
                              "and those after it are left out",
                              limits::kWorldWork),
                  "leave out operations that others overwrite");
    return false;
  }

  void applyBox(const JsonNode& node, BlockWorld& world) {
    const auto index = blockIndex(node, "box", world);
    const auto area = box(node, world, true);
    if (index && area && spend(node, volume(*area))) world.fill(area->low, area->high, *index);
  }

  void applyHollow(const JsonNode& node, BlockWorld& world) {
    const auto index = blockIndex(node, "hollow", world);
    const auto area = box(node, world, true);
    if (!index || !area) return;
    for (int axis = 0; axis < 3; ++axis) {
      glm::ivec3 lowSide = area->high, highSide = area->low;
      lowSide[axis] = area->low[axis];
      highSide[axis] = area->high[axis];
      if (!spend(node, volume({area->low, lowSide}) + volume({highSide, area->high}))) return;
      world.fill(area->low, lowSide, *index);
      world.fill(highSide, area->high, *index);
    }
  }

  /// "replace" names a state; without properties it stands for every state of that block.
  void applyReplace(const JsonNode& node, BlockWorld& world) {
    const auto state = reader_.block(*node.find("replace"), "\"replace\"");
    const auto index = blockIndex(node, "with", world);
    const auto area = box(node, world, false);
    if (!state || !index || !area || !spend(node, volume(*area))) return;
    std::vector<bool> matches;
    for (const BlockState& other : world.palette()) {
      matches.push_back(state->properties.empty() ? other.name == state->name : other == *state);
    }
    for (int y = area->low.y; y <= area->high.y; ++y) {
      for (int z = area->low.z; z <= area->high.z; ++z) {
        for (int x = area->low.x; x <= area->high.x; ++x) {
          if (matches[world.indexAt({x, y, z})]) world.set({x, y, z}, *index);
        }
      }
    }
  }

  /// "at" is one position or a list of them.
  void applyBlock(const JsonNode& node, BlockWorld& world) {
    const auto index = blockIndex(node, "block", world);
    const JsonNode* at = reader_.required(node, "at", "the operation");
    if (!at || !reader_.array(*at, "\"at\"")) return;
    const bool many = !at->items.empty() && at->items[0].kind == JsonNode::Kind::Array;
    const std::size_t count = many ? at->items.size() : 1;
    for (std::size_t i = 0; i < count; ++i) {
      const auto cell = corner(many ? at->items[i] : *at, "at", world);
      if (cell && index) world.set(*cell, *index);
    }
  }

  /// Rows run west to east, rows of a layer north to south, layers upwards.
  void applyLayers(const JsonNode& node, BlockWorld& world) {
    const auto at = position(node, world);
    const JsonNode& layers = *node.find("layers");
    if (!at || !reader_.array(layers, "\"layers\"")) return;
    glm::ivec3 cell = *at;
    for (const JsonNode& layer : layers.items) {
      if (!reader_.array(layer, "a layer")) return;
      cell.z = at->z;
      for (const JsonNode& row : layer.items) {
        if (const auto text = reader_.string(row, "a row")) applyRow(row, *text, cell, world);
        ++cell.z;
      }
      ++cell.y;
    }
  }

  void applyRow(const JsonNode& row, const std::string& text, glm::ivec3 cell, BlockWorld& world) {
    if (text.empty()) return;
    const glm::ivec3 last =
        cell + glm::ivec3(int(std::min<std::size_t>(text.size(), 1 << 20)) - 1, 0, 0);
    if (!world.contains(cell) || !world.contains(last)) {
      reader_.error(row.offset, fmt::format("this row reaches ({}, {}, {}), outside the world",
                                            last.x, last.y, last.z));
      return;
    }
    for (std::size_t i = 0; i < text.size(); ++i, ++cell.x) {
      if (text[i] == kKeep) continue;
      const auto found = palette_.find(text[i]);
      if (found != palette_.end()) {
        world.set(cell, found->second);
        continue;
      }
      reportUnknownKey(row, text, i);
      return;
    }
  }

  void reportUnknownKey(const JsonNode& row, const std::string& text, std::size_t index) {
    // Points at the character itself unless escapes before it shift the text.
    const std::size_t offset = row.offset + 1 + index;
    const std::string_view raw = reader_.source().text;
    const bool found = offset < raw.size() && raw[offset] == text[index];
    std::string known;
    for (const auto& [key, unused] : palette_) known += key;
    reader_.error(found ? offset : row.offset,
                  fmt::format("'{}' is not in the palette: expected one of {} or a space",
                              text[index], known),
                  "add it to \"palette\"");
  }

  /// "at", else the world's origin.
  std::optional<glm::ivec3> position(const JsonNode& node, const BlockWorld& world) {
    const JsonNode* at = node.find("at");
    return at ? corner(*at, "at", world) : std::optional(world.origin());
  }

  void applyFile(const JsonNode& node, BlockWorld& world) {
    const auto at = position(node, world);
    if (!at || !spend(node, kFileWork)) return;
    const auto file = readFile(*node.find("from"));
    if (file && spend(node, volume(file->size()))) copy(*file, *at, world);
  }

  void applyGenerator(const JsonNode& node, BlockWorld& world) {
    const JsonNode& generator = *node.find("generate");
    if (!reader_.object(generator, "\"generate\"", {"terrain"})) return;
    const JsonNode* terrain = reader_.required(generator, "terrain", "\"generate\"");
    if (!terrain || !reader_.object(*terrain, "\"terrain\"",
                                    {"seed", "seaLevel", "relief", "trees", "plants"})) {
      return;
    }
    int seed = 0;
    TerrainSettings settings;
    const RealRange share{0, 1};
    reader_.optional(*terrain, "seed", IntegerRange{0, 1 << 30}, seed);
    reader_.optional(*terrain, "seaLevel", kCellRange, settings.seaLevel);
    reader_.optional(*terrain, "relief", IntegerRange{0, kMaxWorldSize}, settings.relief);
    reader_.optional(*terrain, "trees", share, settings.trees);
    reader_.optional(*terrain, "plants", share, settings.plants);
    settings.seed = unsigned(seed) + json_.seed;
    const int low = world.origin().y, high = low + world.size().y - 1;
    if (settings.seaLevel < low || settings.seaLevel > high) {
      reader_.error(terrain->offset,
                    fmt::format("the sea level {} is outside of the box, whose heights are {} to {}: set "
                                "\"seaLevel\" or \"origin\"", settings.seaLevel, low, high));
      return;
    }
    if (spend(node, volume(world.size()) * kGeneratorWork)) generateTerrain(world, settings);
  }

  std::optional<BlockWorld> readFile(const JsonNode& node) {
    const std::optional<std::string> name = reader_.string(node, "\"from\"");
    if (!name) return std::nullopt;
    const auto path = name->starts_with('/') ? std::nullopt : resolvePackPath("/world.json", *name);
    if (!path) {
      reader_.error(node.offset,
                    fmt::format("\"{}\" is not a path inside the world's folder", *name));
      return std::nullopt;
    }
    const std::optional<std::string> bytes =
        json_.readFile ? json_.readFile(path->substr(1)) : std::nullopt;
    if (!bytes) {
      reader_.error(node.offset, fmt::format("cannot read \"{}\"", *name));
      return std::nullopt;
    }
    Diagnostics problems;
    std::optional<BlockWorld> world = parseSchematic(*bytes, *name, problems, json_.maximumBlocks);
    for (const Diagnostic& problem : problems) {
      reader_.error(node.offset, fmt::format("{}: {}", *name, problem.message), problem.hint);
    }
    return world;
  }

  /// What leaves the target's box is cut off.
  static void copy(const BlockWorld& source, glm::ivec3 at, BlockWorld& target) {
    std::vector<std::uint32_t> index;
    for (const BlockState& state : source.palette()) index.push_back(target.paletteIndex(state));
    const glm::ivec3 size = source.size();
    for (int y = 0; y < size.y; ++y) {
      for (int z = 0; z < size.z; ++z) {
        for (int x = 0; x < size.x; ++x) {
          const glm::ivec3 p(x, y, z);
          target.set(at + p, index[source.indexAt(source.origin() + p)]);
        }
      }
    }
  }

  JsonReader& reader_;
  const JsonNode& root_;
  const WorldJson& json_;
  std::map<char, std::uint32_t> palette_;
  std::int64_t work_ = 0;  ///< of the operations so far, in blocks
};

}  // namespace

std::optional<BlockWorld> readBlocks(JsonReader& reader, const JsonNode& root,
                                     const WorldJson& json) {
  return BlockOperations(reader, root, json).run();
}

}  // namespace orris
