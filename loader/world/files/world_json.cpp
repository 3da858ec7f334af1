#include <orris/world/files/world_json.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>

#include <orris/core/limits.h>
#include <orris/world/content/content_json.h>
#include <orris/world/content/stated_json.h>
#include <orris/world/dimension_look.h>
#include <orris/world/files/world_json_blocks.h>

namespace orris {
namespace {

constexpr RealRange kPositionRange{-30000000, 30000000};
constexpr IntegerRange kTimeRange{0, 23999};
constexpr double kDegrees = 57.29577951308232;

/// Yaw and pitch of the direction from the camera to a target, in the game's convention.
void lookAt(Camera& camera, glm::dvec3 target) {
  const glm::dvec3 d = target - camera.position;
  const double horizontal = std::hypot(d.x, d.z);
  if (horizontal > 0) camera.yaw = float(std::atan2(-d.x, d.z) * kDegrees);
  camera.pitch = float(-std::atan2(d.y, horizontal) * kDegrees);
}

Camera readCamera(JsonReader& reader, const JsonNode& node, bool named) {
  Camera camera;
  const char* what = "a camera";
  if (!reader.object(node, what, {"name", "position", "yaw", "pitch", "target", "fov"}))
    return camera;
  if (named) reader.required(node, "name", what);
  reader.optional(node, "name", camera.name);
  if (const JsonNode* position = reader.required(node, "position", what)) {
    camera.position =
        reader.vector(*position, "\"position\"", kPositionRange).value_or(glm::dvec3(0));
  }
  reader.optional(node, "yaw", RealRange{-360, 360}, camera.yaw);
  reader.optional(node, "pitch", RealRange{-90, 90}, camera.pitch);
  reader.optional(node, "fov", RealRange{1, 170}, camera.fov);
  if (const JsonNode* target = node.find("target")) {
    if (node.find("yaw") || node.find("pitch")) {
      reader.error(target->offset, "a camera has either \"target\" or \"yaw\" and \"pitch\"");
    }
    if (const auto point = reader.vector(*target, "\"target\"", kPositionRange)) {
      if (*point == camera.position) reader.error(target->offset, "\"target\" equals \"position\"");
      lookAt(camera, *point);
    }
  }
  return camera;
}

std::vector<Camera> readCameras(JsonReader& reader, const JsonNode& root) {
  std::vector<Camera> cameras;
  const JsonNode* list = root.find("cameras");
  if (!list || !reader.array(*list, "\"cameras\"")) return cameras;
  std::set<std::string> names;
  if (list->items.size() > limits::kWorldCameras) {
    reader.error(list->items[limits::kWorldCameras].offset,
                 fmt::format("more than {} cameras", limits::kWorldCameras));
    return cameras;
  }
  for (const JsonNode& node : list->items) {
    Camera camera = readCamera(reader, node, true);
    if (!names.insert(camera.name).second) {
      reader.error(node.offset, fmt::format("a second camera is named \"{}\"", camera.name));
    }
    cameras.push_back(std::move(camera));
  }
  return cameras;
}

Player readPlayer(JsonReader& reader, const JsonNode& environment) {
  Player player;
  const JsonNode* node = environment.find("player");
  if (!node) return player;
  reader.object(*node, "\"player\"",
                {"blindness", "nightVision", "darkness", "darknessLight", "brightness", "heldLight",
                 "heldLight2", "sneaking", "sprinting", "hurt", "invisible", "burning", "onGround",
                 "hideGui", "mainHand", "offHand", "glint", "body"});
  const std::pair<const char*, float*> amounts[] = {{"blindness", &player.blindness},
                                                    {"nightVision", &player.nightVision},
                                                    {"darkness", &player.darkness},
                                                    {"darknessLight", &player.darknessLight},
                                                    {"brightness", &player.brightness}};
  for (const auto& [key, target] : amounts) reader.optional(*node, key, RealRange{0, 1}, *target);
  reader.optional(*node, "heldLight", IntegerRange{0, 15}, player.heldLight);
  reader.optional(*node, "heldLight2", IntegerRange{0, 15}, player.heldLight2);
  const std::pair<const char*, bool*> states[] = {
      {"sneaking", &player.sneaking}, {"sprinting", &player.sprinting},
      {"hurt", &player.hurt},         {"invisible", &player.invisible},
      {"burning", &player.burning},   {"onGround", &player.onGround},
      {"hideGui", &player.hideGui},   {"body", &player.body}};
  reader.optional(*node, "glint", player.handGlint);
  player.mainHand = readItem(reader, *node, "mainHand");
  player.offHand = readItem(reader, *node, "offHand");
  // The game hides hands along with the rest of what belongs to the player.
  player.hideGui = player.mainHand.empty() && player.offHand.empty();
  for (const auto& [key, target] : states) reader.optional(*node, key, *target);
  return player;
}

Clouds readClouds(JsonReader& reader, const JsonNode& node) {
  const JsonNode* text = node.find("clouds");
  if (!text) return Clouds::Off;
  static const std::map<std::string, Clouds> kClouds{
      {"off", Clouds::Off}, {"fast", Clouds::Fast}, {"fancy", Clouds::Fancy}};
  const auto found = kClouds.find(text->text);
  if (text->kind == JsonNode::Kind::String && found != kClouds.end()) return found->second;
  reader.expected(*text, "\"clouds\"", "off, fast or fancy");
  return Clouds::Off;
}

Environment readEnvironment(JsonReader& reader, const JsonNode& root) {
  Environment environment;
  const JsonNode* node = root.find("environment");
  if (!node) return environment;
  reader.object(*node, "\"environment\"",
                {"time", "day", "rain", "thunder", "biome", "dimension", "renderDistance",
                 "temperature", "rainfall", "fogColor", "skyColor", "clouds", "player", "uniforms"});
  reader.optional(*node, "time", kTimeRange, environment.time);
  reader.optional(*node, "day", IntegerRange{0, 1000000}, environment.day);
  reader.optional(*node, "rain", RealRange{0, 1}, environment.rain);
  reader.optional(*node, "thunder", RealRange{0, 1}, environment.thunder);
  std::string dimension = environment.dimension;
  reader.optional(*node, "dimension", dimension);
  setDimension(dimension, environment);
  reader.optional(*node, "biome", environment.biome);
  reader.optional(*node, "renderDistance", IntegerRange{16, 1024}, environment.renderDistance);
  reader.optional(*node, "temperature", RealRange{-2, 2}, environment.temperature);
  reader.optional(*node, "rainfall", RealRange{0, 1}, environment.rainfall);
  reader.optional(*node, "fogColor", RealRange{0, 1}, environment.fogColor);
  reader.optional(*node, "skyColor", RealRange{0, 1}, environment.skyColor);
  environment.clouds = readClouds(reader, *node);
  environment.player = readPlayer(reader, *node);
  environment.stated = readStatedValues(reader, *node);
  return environment;
}

SetBlock readSetBlock(JsonReader& reader, const JsonNode& node, const BlockWorld& blocks) {
  SetBlock action{};
  if (!reader.object(node, "\"set\"", {"block", "at"})) return action;
  const JsonNode* block = reader.required(node, "block", "\"set\"");
  const JsonNode* at = reader.required(node, "at", "\"set\"");
  if (block) action.state = reader.block(*block, "\"block\"").value_or(BlockState{});
  const auto cell = at ? reader.cell(*at, "\"at\"", kCellRange) : std::nullopt;
  if (cell && !blocks.contains(*cell)) reader.error(at->offset, "\"at\" is outside the world");
  action.at = cell.value_or(glm::ivec3(0));
  return action;
}

/// The name of a camera of this world, or a camera of its own.
MoveCamera readMoveCamera(JsonReader& reader, const JsonNode& node,
                          const std::vector<Camera>& cameras) {
  if (node.kind != JsonNode::Kind::String) return {readCamera(reader, node, false)};
  for (const Camera& camera : cameras) {
    if (camera.name == node.text) return {camera};
  }
  reader.error(node.offset, fmt::format("no camera is named \"{}\"", node.text));
  return {};
}

SetOption readSetOption(JsonReader& reader, const JsonNode& node) {
  SetOption action;
  if (!reader.object(node, "\"option\"", {"name", "value"})) return action;
  reader.required(node, "name", "\"option\"");
  reader.required(node, "value", "\"option\"");
  reader.optional(node, "name", action.name);
  reader.optional(node, "value", action.value);
  return action;
}

std::optional<Event> readEvent(JsonReader& reader, const JsonNode& node, const World& world) {
  if (!reader.object(node, "an event", {"frame", "set", "camera", "option", "time", "entity", "lightning"})) return {};
  Event event;
  reader.required(node, "frame", "an event");
  reader.optional(node, "frame", IntegerRange{0, 1000000000}, event.frame);
  if (node.members.size() != 2) {
    reader.error(node.offset,
                 "an event has \"frame\" and one of \"set\", \"camera\", \"option\", \"time\", "
                 "\"entity\", \"lightning\"");
    return {};
  }
  if (const JsonNode* set = node.find("set")) {
    event.action = readSetBlock(reader, *set, world.blocks);
  } else if (const JsonNode* camera = node.find("camera")) {
    event.action = readMoveCamera(reader, *camera, world.cameras);
  } else if (const JsonNode* option = node.find("option")) {
    event.action = readSetOption(reader, *option);
  } else if (const JsonNode* time = node.find("time")) {
    event.action = SetTime{reader.integer(*time, "\"time\"", kTimeRange).value_or(0)};
  } else if (const JsonNode* entity = node.find("entity")) {
    event.action = readEntityChange(reader, *entity, world.content);
  } else if (const JsonNode* lightning = node.find("lightning")) {
    event.action = readLightning(reader, *lightning);
  }
  return event;
}

std::vector<Event> readEvents(JsonReader& reader, const JsonNode& root, const World& world) {
  std::vector<Event> events;
  const JsonNode* list = root.find("events");
  if (!list || !reader.array(*list, "\"events\"")) return events;
  for (const JsonNode& node : list->items) {
    if (auto event = readEvent(reader, node, world)) events.push_back(std::move(*event));
  }
  // Events of one frame keep their order in the file.
  std::stable_sort(events.begin(), events.end(),
                   [](const Event& a, const Event& b) { return a.frame < b.frame; });
  return events;
}

}  // namespace

std::optional<World> parseWorldJson(const WorldJson& json, Diagnostics& diagnostics) {
  const JsonText source{json.text, json.file};
  const std::optional<JsonNode> root = parseLocatedJson(source, diagnostics);
  if (!root) return std::nullopt;
  JsonReader reader(source, diagnostics);
  std::vector<std::string> keys = {"name",   "exercises", "origin",      "size",  "from", "palette",
                                   "blocks", "cameras",   "environment", "events"};
  keys.insert(keys.end(), contentKeys().begin(), contentKeys().end());
  if (!reader.object(*root, "the world", keys) &&
      root->kind != JsonNode::Kind::Object) {
    return std::nullopt;
  }
  World world;
  world.name = json.defaultName;
  reader.optional(*root, "name", world.name);
  reader.optional(*root, "exercises", world.exercises);
  std::optional<BlockWorld> blocks = readBlocks(reader, *root, json);
  if (!blocks) return std::nullopt;
  world.blocks = std::move(*blocks);
  world.environment = readEnvironment(reader, *root);
  world.cameras = readCameras(reader, *root);
  if (world.cameras.empty()) world.cameras = defaultCameras(world.blocks);
  world.content = readContent(reader, *root, world.blocks);
  world.events = readEvents(reader, *root, world);
  const std::size_t states = world.blocks.palette().size();
  if (states > kMaxPalette) {
    reader.error(root->offset,
                 fmt::format("{} block states: expected at most {}", states, kMaxPalette));
  }
  if (reader.failed()) return std::nullopt;
  return world;
}

}  // namespace orris
