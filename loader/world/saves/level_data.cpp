#include <orris/world/saves/level_data.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <orris/core/limits.h>
#include <orris/world/files/gunzip.h>
#include <orris/world/files/nbt.h>

namespace orris {
namespace {

constexpr std::int64_t kDay = 24000;
constexpr double kFarthest = 3.0e7;  // the game's border, blocks

/// nullopt where the numbers are no place of a world.
std::optional<SavedPlace> placeOf(const std::vector<double>& feet, float yaw, float pitch,
                                  std::string dimension) {
  const auto sane = [](double value) {
    return std::isfinite(value) && std::abs(value) < kFarthest;
  };
  if (feet.size() != 3 || !std::all_of(feet.begin(), feet.end(), sane)) return std::nullopt;
  SavedPlace place{{feet[0], feet[1], feet[2]}, 0, 0, std::move(dimension)};
  if (std::isfinite(yaw)) place.yaw = std::remainder(yaw, 360.0f);
  if (std::isfinite(pitch)) place.pitch = std::clamp(pitch, -90.0f, 90.0f);
  return place;
}

/// A name; before 1.16 a number.
std::string dimensionIn(const NbtTag& parent, std::string_view name) {
  const NbtTag* tag = parent.find(name);
  if (tag && tag->string() && !tag->string()->empty()) return *tag->string();
  const std::int64_t number = tag && tag->integer() ? *tag->integer() : 0;
  return number == -1  ? "minecraft:the_nether"
         : number == 1 ? "minecraft:the_end"
                       : "minecraft:overworld";
}

std::optional<SavedPlace> playerOf(const NbtTag& data) {
  const NbtTag* player = data.find("Player");
  if (!player) return std::nullopt;
  const std::vector<double> angles = player->numbersAt("Rotation");
  const bool known = angles.size() == 2;
  return placeOf(player->numbersAt("Pos"), known ? float(angles[0]) : 0,
                 known ? float(angles[1]) : 0, dimensionIn(*player, "Dimension"));
}

/// Three members, in newer games a compound. A block's corner: the player begins on its middle.
std::optional<SavedPlace> spawnOf(const NbtTag& data) {
  std::vector<double> block;
  std::string dimension = "minecraft:overworld";
  if (const NbtTag* spawn = data.find("spawn")) {
    block = spawn->numbersAt("pos");
    dimension = dimensionIn(*spawn, "dimension");
  } else if (data.find("SpawnX") && data.find("SpawnZ")) {
    for (const char* name : {"SpawnX", "SpawnY", "SpawnZ"})
      block.push_back(double(data.integerAt(name, 64)));
  }
  if (block.size() != 3) return std::nullopt;
  return placeOf({block[0] + 0.5, block[1], block[2] + 0.5}, 0, 0, dimension);
}

}  // namespace

std::optional<LevelData> parseLevelData(std::string_view bytes, std::string& problem) {
  std::string tags;
  if (gunzip(bytes, limits::kChunkBytes, tags) != GunzipResult::Ok) {
    problem = "its compressed data is damaged, cut off or too large";
    return std::nullopt;
  }
  NbtError error;
  const std::optional<NbtTag> root = parseNbt(tags, error);
  const NbtTag* data = root ? root->find("Data") : nullptr;
  if (!data) {
    problem = root ? "it has no compound \"Data\"" : error.message;
    return std::nullopt;
  }
  LevelData level;
  if (const NbtTag* name = data->find("LevelName"); name && name->string())
    level.name = name->string()->substr(0, 200);
  const std::int64_t ticks = std::max<std::int64_t>(0, data->integerAt("DayTime", level.time));
  level.time = int(ticks % kDay);
  level.day = int(std::min<std::int64_t>(ticks / kDay, INT32_MAX));
  level.rain = data->integerAt("raining", 0) != 0;
  level.thunder = level.rain && data->integerAt("thundering", 0) != 0;
  level.player = playerOf(*data);
  level.spawn = spawnOf(*data);
  return level;
}

}  // namespace orris
