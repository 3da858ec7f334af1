#include <orris/world/world.h>

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include <orris/core/add_diagnostic.h>
#include <orris/core/limits.h>
#include <orris/core/files/read_file.h>
#include <orris/core/files/text_file.h>
#include <orris/core/work_stage.h>
#include <orris/world/blocks/block_facts.h>
#include <orris/world/files/schematic.h>
#include <orris/world/files/world_json.h>
#include <orris/world/luanti/luanti_files.h>
#include <orris/world/luanti/luanti_world.h>
#include <orris/world/random_room.h>
#include <orris/world/saves/save.h>
#include <orris/world/saves/save_files.h>

namespace orris {
namespace {

namespace fs = std::filesystem;

constexpr const char* kWorldHint =
    "WORLD is a folder with world.json, a world.json, a schematic (.schem, .schematic, .litematic, .nbt), "
    "a save, a region file (.mca), or a Luanti world or its map.sqlite";
const std::set<std::string> kSchematics = {".schem", ".schematic", ".litematic", ".nbt"};
constexpr std::size_t kMaxFileBytes = std::size_t(1) << 28;

/// Adds what may appear later or along with the blocks: the states that events set and the water of
/// waterlogged blocks. Facts and textures of the palette then serve every frame.
void completePalette(World& world) {
  for (const Event& event : world.events) {
    if (const auto* set = std::get_if<SetBlock>(&event.action))
      world.blocks.paletteIndex(set->state);
  }
  const BlockTable table;
  const std::vector<BlockState>& palette = world.blocks.palette();
  const bool waterlogged =
      std::any_of(palette.begin(), palette.end(),
                  [&](const BlockState& state) { return table.factsOf(state).waterlogged; });
  if (waterlogged) world.blocks.paletteIndex({"minecraft:water", {}});
}

std::optional<World> loadSchematic(const fs::path& path, Diagnostics& diagnostics) {
  ReadFault fault{};
  const std::optional<std::string> bytes = readFile(path.string(), kMaxFileBytes, fault);
  if (!bytes) {
    addError(diagnostics, "world-unreadable", {path.string()},
             fmt::format("this schematic {}", describe(fault)));
    return std::nullopt;
  }
  std::optional<BlockWorld> blocks =
      parseSchematic(*bytes, path.string(), diagnostics, std::int64_t(limits::kWorldBlocks));
  if (!blocks) return std::nullopt;
  World world;
  world.name = path.stem().string();
  world.exercises = "a schematic";
  world.blocks = std::move(*blocks);
  world.cameras = defaultCameras(world.blocks);
  world.environment.clouds = Clouds::Fancy;
  completePalette(world);
  return world;
}

/// `text`: what was read of `path`, or nothing because of `fault`.
std::optional<World> loadJson(const fs::path& path, const std::optional<std::string>& text,
                              ReadFault fault, unsigned seed, Diagnostics& diagnostics) {
  if (!text) {
    addError(diagnostics, "world-unreadable", {path.string()},
             fmt::format("this world {}", describe(fault)), kWorldHint);
    return std::nullopt;
  }
  if (text->size() > limits::kWorldJsonBytes) {
    addError(diagnostics, "world-unreadable", {path.string()},
             fmt::format("this world has {} bytes: expected at most {}", text->size(),
                         limits::kWorldJsonBytes),
             "put blocks into a schematic and name it with \"from\"");
    return std::nullopt;
  }
  if (isUtf16(*text)) {
    addError(diagnostics, "world-unreadable", {path.string()}, "this file is UTF-16",
             "save it as UTF-8");
    return std::nullopt;
  }
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  std::error_code problem;
  WorldJson json;
  json.text = *text;
  json.file = path.string();
  json.defaultName = fs::weakly_canonical(folder, problem).filename().string();
  json.seed = seed;
  json.maximumBlocks = std::int64_t(limits::kWorldBlocks);
  json.readFile = [&](const std::string& name) {
    ReadFault ignored{};
    return readFileBelow(folder.string(), name, kMaxFileBytes, ignored);
  };
  std::optional<World> world = parseWorldJson(json, diagnostics);
  if (world) completePalette(*world);
  return world;
}

std::optional<World> loadRandomRoom(const std::string& name, Diagnostics& diagnostics) {
  const auto seed = randomRoomSeed(name);
  if (!seed) {
    addError(diagnostics, "world-unreadable", {name},
             "expected a whole number from 0 to 4294967295 after random:", "random:17");
    return std::nullopt;
  }
  World world = randomRoom(*seed);
  completePalette(world);
  return world;
}

}  // namespace

const Camera* World::camera(std::string_view cameraName) const {
  for (const Camera& candidate : cameras) {
    if (candidate.name == cameraName) return &candidate;
  }
  return nullptr;
}

std::optional<World> loadWorld(const std::string& path, unsigned seed, Diagnostics& diagnostics,
                               const SavePart& part) {
  const WorkStage stage("reading the world", path);
  std::error_code problem;
  const fs::path given(path);
  ReadFault fault{};
  if (path.starts_with(kRandomRoom)) return loadRandomRoom(path, diagnostics);
  const bool described = fs::exists(given / "world.json", problem);
  const bool luanti = !described && isLuantiWorld(given);
  if (luanti || (!described && isSave(given))) {
    std::optional<World> world =
        luanti ? loadLuantiWorld(given, part, diagnostics) : loadSave(given, part, diagnostics);
    if (world) completePalette(*world);
    return world;
  }
  if (part.at || part.radius) {
    addError(diagnostics, "world-unreadable", {path},
             "this world is drawn whole: --at and --radius choose a part of a save or a Luanti world");
    return std::nullopt;
  }
  if (fs::is_directory(given, problem)) {
    const auto text = readFileBelow(path, "world.json", kMaxFileBytes, fault);
    return loadJson(given / "world.json", text, fault, seed, diagnostics);
  }
  const std::string extension = given.extension().string();
  if (kSchematics.count(extension) != 0) return loadSchematic(given, diagnostics);
  if (extension == ".json") {
    const auto text = readQuotedFile(path, kMaxFileBytes, fault);
    return loadJson(given, text, fault, seed, diagnostics);
  }
  addError(diagnostics, "world-unreadable", {path},
           fs::exists(given, problem) ? "not a world" : "no such file or folder", kWorldHint);
  return std::nullopt;
}

}  // namespace orris
