// A world as rendered: blocks, cameras, time and weather, events. See docs/world-format.md.
#pragma once

#include <glm/glm.hpp>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <orris/core/diagnostic.h>
#include <orris/world/blocks/biome_grid.h>
#include <orris/world/blocks/block_world.h>
#include <orris/world/content/content.h>
#include <orris/world/content/stated_values.h>

namespace orris {

/// Position of the eye in world blocks; yaw and pitch in degrees as in the game: yaw 0 looks south
/// (+z), 90 west (-x); pitch 90 looks down. Vertical field of view in degrees.
struct Camera {
  std::string name;
  glm::dvec3 position{0};
  float yaw = 0, pitch = 0;
  float fov = 70;
};

/// What the pack knows of the player behind the camera. Contract: uniforms.csv groups player, id.
struct Player {
  float blindness = 0, nightVision = 0, darkness = 0, darknessLight = 0;  ///< effects, 0..1
  float brightness = 1;                                                   ///< setting, 0..1
  int heldLight = 0, heldLight2 = 0;                                      ///< 0..15, both hands
  bool sneaking = false, sprinting = false, hurt = false, invisible = false, burning = false;
  bool onGround = true, hideGui = true;
  /// Held items with their namespace; "" shows no hand, "minecraft:air" the bare arm.
  std::string mainHand, offHand;
  bool handGlint = false;  ///< what the hands hold is enchanted
  bool body = false;  ///< casts a shadow
};

/// The game's setting of its clouds: none, flat, or boxes.
enum class Clouds { Off, Fast, Fancy };

/// Everything but blocks and cameras. Contract: uniforms.csv groups world, biome, player.
struct Environment {
  int time = 6000;  ///< ticks 0..23999
  int day = 0;
  float rain = 0, thunder = 0;
  std::string biome = "minecraft:plains";
  std::string dimension = "minecraft:overworld";
  int renderDistance = 128;  ///< blocks, uniform `far`
  float temperature = 0.8f, rainfall = 0.4f;
  glm::vec3 fogColor{0.7f, 0.8f, 1.0f}, skyColor{0.47f, 0.65f, 1.0f};
  Clouds clouds = Clouds::Off;  ///< a pack's `clouds` goes before it
  Player player;
  StatedValues stated;  ///< uniforms that follow from nothing else here
};

struct SetBlock {
  glm::ivec3 at;
  BlockState state;
};
struct MoveCamera {
  Camera camera;
};
struct SetOption {
  std::string name, value;
};
struct SetTime {
  int time;
};
/// What changes of the entity of that name.
struct ChangeEntity {
  std::string name;
  std::optional<glm::dvec3> position;
  std::optional<float> yaw;
  std::optional<bool> walking, hurt;
};
struct StrikeLightning {
  glm::dvec3 at{0};
  int frames = 12;  ///< for so many it is seen
};
/// Something that happens before the given frame (first frame: 0) is drawn.
struct Event {
  int frame = 0;
  std::variant<SetBlock, MoveCamera, SetOption, SetTime, ChangeEntity, StrikeLightning> action;
};

struct World {
  std::string name;
  std::string exercises;  ///< one line: what this world is for
  BlockWorld blocks;
  std::vector<Camera> cameras;  ///< at least one; the first is the default
  Environment environment;
  WorldContent content;
  std::vector<Event> events;  ///< sorted by frame
  std::shared_ptr<const BiomeGrid> biomes;  ///< of a save; nullptr: the environment's everywhere
  /// Folders, zips or jars that give its blocks their look; the first goes before the others.
  std::vector<std::string> resourcePacks;

  const Camera* camera(std::string_view name) const;
};

/// What of a save is loaded.
struct SavePart {
  std::optional<glm::ivec2> at;  ///< a block, x and z as the game shows them; nullopt for where the player is, or begins
  std::optional<int> radius;     ///< chunks, 0 to limits::kSaveRadius
  std::string dimension{};       ///< a name with its namespace; "" for the one that the path names
};
constexpr int kDefaultSaveRadius = 8;

/// Loads a folder with world.json, a world.json, a Sponge .schem, a part of a save or of a Luanti world, or random:SEED (random_room.h). Numeric limits:
/// 512 blocks an axis and 2^25 blocks in all, but of saves. `seed` drives generated worlds. The palette
/// also holds the states that events set, so that facts and textures made from it serve every frame.
std::optional<World> loadWorld(const std::string& path, unsigned seed, Diagnostics& diagnostics,
                               const SavePart& part = {});

/// Cameras for a world without any: "default" looks at the box from a corner outside, "inside" from
/// a free spot near its middle.
std::vector<Camera> defaultCameras(const BlockWorld& blocks);

}  // namespace orris
