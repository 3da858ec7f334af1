#include <orris/world/content/content_json.h>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include <orris/core/limits.h>
#include <orris/world/content/armour.h>
#include <orris/world/content/entity_models.h>

namespace orris {
namespace {

constexpr RealRange kPlaces{-30000000, 30000000};
constexpr IntegerRange kCells{-30000000, 30000000};
constexpr RealRange kTurns{-360, 360};

/// Reads each value of the list at `key`.
template <class T, class Read>
std::vector<T> readList(JsonReader& reader, const JsonNode& root, const char* key, Read read) {
  std::vector<T> things;
  const JsonNode* list = root.find(key);
  if (list == nullptr || !reader.array(*list, fmt::format("\"{}\"", key))) return things;
  if (list->items.size() > limits::kWorldThings) {
    reader.error(list->items[limits::kWorldThings].offset,
                 fmt::format("more than {} {}", limits::kWorldThings, key));
    return things;
  }
  for (const JsonNode& node : list->items) things.push_back(read(node));
  return things;
}

glm::dvec3 readPlace(JsonReader& reader, const JsonNode& object, const char* key,
                     const char* what) {
  const JsonNode* node = reader.required(object, key, what);
  if (node == nullptr) return glm::dvec3(0);
  return reader.vector(*node, fmt::format("\"{}\"", key), kPlaces).value_or(glm::dvec3(0));
}

glm::ivec3 readBlockPlace(JsonReader& reader, const JsonNode& object, const char* what,
                          const BlockWorld& blocks) {
  const JsonNode* node = reader.required(object, "at", what);
  if (node == nullptr) return glm::ivec3(0);
  const auto cell = reader.cell(*node, "\"at\"", kCells);
  if (cell && !blocks.contains(*cell)) reader.error(node->offset, "\"at\" is outside the world");
  return cell.value_or(glm::ivec3(0));
}

std::string withNamespace(std::string name) {
  return name.find(':') == std::string::npos ? "minecraft:" + name : name;
}

void checkGlyphs(JsonReader& reader, const JsonNode& node, const std::string& text) {
  if (text.size() > limits::kWorldTextGlyphs)
    reader.error(node.offset, fmt::format("a text of {} glyphs: expected at most {}", text.size(),
                                          limits::kWorldTextGlyphs));
}

void readArmour(JsonReader& reader, const JsonNode& node, Entity& entity) {
  const JsonNode* list = node.find("armour");
  if (list == nullptr) {
    if (entity.kind == "minecraft:armor_stand") entity.armour = {"minecraft:iron_helmet", "minecraft:iron_chestplate"};
    return;
  }
  const EntityModel* model = findEntityModel(entity.model);
  if (model != nullptr && !model->wearsArmour)
    return reader.error(list->offset, fmt::format("{} wears no armour: only armor_stand and player do", entity.model));
  if (!reader.array(*list, "\"armour\"")) return;
  for (const JsonNode& item : list->items) {
    std::string name = reader.string(item, "a piece of \"armour\"").value_or("");
    const bool known = armourPieceOf(name).has_value();
    if (item.kind == JsonNode::Kind::String && !known)
      reader.expected(item, "a piece of \"armour\"", "an item whose name ends in _helmet, _chestplate, _leggings or _boots");
    if (known && entity.armour.size() < 4) entity.armour.push_back(withNamespace(std::move(name)));
  }
}

Entity readEntity(JsonReader& reader, const JsonNode& node) {
  Entity entity;
  const char* what = "an entity";
  if (!reader.object(
          node, what,
          {"kind", "name", "position", "yaw", "walking", "hurt", "glint", "tag", "item", "mainHand", "offHand", "armour",
           "dye", "leash"}))
    return entity;
  const JsonNode* kind = reader.required(node, "kind", what);
  reader.optional(node, "kind", entity.kind);
  if (kind != nullptr && findEntityModel(entity.kind) == nullptr)
    reader.error(kind->offset, fmt::format("no entity \"{}\": expected one of {}", entity.kind,
                                           fmt::join(entityKinds(), ", ")));
  entity.model = entity.kind;
  entity.kind = withNamespace(entity.kind);
  entity.position = readPlace(reader, node, "position", what);
  reader.optional(node, "name", entity.name);
  reader.optional(node, "yaw", kTurns, entity.yaw);
  reader.optional(node, "walking", entity.walking);
  reader.optional(node, "hurt", entity.hurt);
  reader.optional(node, "glint", entity.glint);
  if (const JsonNode* tag = node.find("tag")) {
    entity.tag = reader.string(*tag, "\"tag\"").value_or("");
    checkGlyphs(reader, *tag, entity.tag);
  }
  entity.item = readItem(reader, node, "item");
  entity.mainHand = readItem(reader, node, "mainHand");
  entity.offHand = readItem(reader, node, "offHand");
  readArmour(reader, node, entity);
  if (node.find("dye") != nullptr) reader.optional(node, "dye", RealRange{0, 1}, entity.dye.emplace());
  if (node.find("leash") != nullptr) entity.leash = readPlace(reader, node, "leash", what);
  return entity;
}

ParticleSource readParticles(JsonReader& reader, const JsonNode& node) {
  static const std::map<std::string, ParticleKind> kKinds{{"flame", ParticleKind::Flame},
                                                          {"smoke", ParticleKind::Smoke},
                                                          {"spark", ParticleKind::Spark}};
  ParticleSource source;
  const char* what = "a source of particles";
  if (!reader.object(node, what, {"kind", "position", "count", "spread"})) return source;
  if (const JsonNode* kind = reader.required(node, "kind", what)) {
    const auto found = kKinds.find(kind->text);
    if (kind->kind == JsonNode::Kind::String && found != kKinds.end())
      source.kind = found->second;
    else
      reader.expected(*kind, "\"kind\"", "flame, smoke or spark");
  }
  source.position = readPlace(reader, node, "position", what);
  reader.optional(node, "count", IntegerRange{1, 1000}, source.count);
  reader.optional(node, "spread", RealRange{0, 64}, source.spread);
  return source;
}

BeaconBeam readBeam(JsonReader& reader, const JsonNode& node, const BlockWorld& blocks) {
  BeaconBeam beam;
  if (!reader.object(node, "a beam", {"at", "color"})) return beam;
  beam.at = readBlockPlace(reader, node, "a beam", blocks);
  reader.optional(node, "color", RealRange{0, 1}, beam.color);
  return beam;
}

DamagedBlock readDamage(JsonReader& reader, const JsonNode& node, const BlockWorld& blocks) {
  DamagedBlock damage;
  if (!reader.object(node, "a damaged block", {"at", "stage"})) return damage;
  damage.at = readBlockPlace(reader, node, "a damaged block", blocks);
  reader.optional(node, "stage", IntegerRange{0, 9}, damage.stage);
  return damage;
}

BlockText readText(JsonReader& reader, const JsonNode& node, const BlockWorld& blocks) {
  BlockText text;
  const char* what = "a text";
  if (!reader.object(node, what, {"text", "at", "position", "yaw", "size", "color"})) return text;
  reader.required(node, "text", what);
  reader.optional(node, "text", text.text);
  text.at = readBlockPlace(reader, node, what, blocks);
  text.position = readPlace(reader, node, "position", what);
  reader.optional(node, "yaw", kTurns, text.yaw);
  reader.optional(node, "size", RealRange{0.01, 16}, text.size);
  reader.optional(node, "color", RealRange{0, 1}, text.color);
  checkGlyphs(reader, node, text.text);
  return text;
}

std::optional<WorldBorder> readBorder(JsonReader& reader, const JsonNode& root) {
  const JsonNode* node = root.find("border");
  if (node == nullptr || !reader.object(*node, "\"border\"", {"min", "max"})) return std::nullopt;
  WorldBorder border;
  const std::pair<const char*, glm::dvec2*> corners[] = {{"min", &border.low},
                                                         {"max", &border.high}};
  for (const auto& [key, corner] : corners) {
    const JsonNode* pair = reader.required(*node, key, "\"border\"");
    if (pair == nullptr) continue;
    if (pair->kind != JsonNode::Kind::Array || pair->items.size() != 2) {
      reader.expected(*pair, fmt::format("\"{}\"", key), "[x, z]");
      continue;
    }
    for (int i = 0; i < 2; ++i)
      (*corner)[i] =
          reader.number(pair->items[std::size_t(i)], "a coordinate", kPlaces).value_or(0);
  }
  if (!reader.failed() && !(border.low.x < border.high.x && border.low.y < border.high.y))
    reader.error(node->offset, "\"border\" is empty: expected \"min\" below \"max\"");
  return border;
}

}  // namespace

const std::vector<std::string>& contentKeys() {
  static const std::vector<std::string> kKeys = {"entities", "particles", "beams", "damaged",
                                                 "texts",    "selected",  "border"};
  return kKeys;
}

std::string readItem(JsonReader& reader, const JsonNode& object, const std::string& key) {
  std::string item;
  reader.optional(object, key, item);
  return item.empty() ? item : withNamespace(item);
}

WorldContent readContent(JsonReader& reader, const JsonNode& root, const BlockWorld& blocks) {
  WorldContent content;
  content.entities = readList<Entity>(
      reader, root, "entities", [&](const JsonNode& node) { return readEntity(reader, node); });
  content.particles = readList<ParticleSource>(
      reader, root, "particles", [&](const JsonNode& node) { return readParticles(reader, node); });
  content.beams = readList<BeaconBeam>(
      reader, root, "beams", [&](const JsonNode& node) { return readBeam(reader, node, blocks); });
  content.damaged = readList<DamagedBlock>(reader, root, "damaged", [&](const JsonNode& node) {
    return readDamage(reader, node, blocks);
  });
  content.texts = readList<BlockText>(
      reader, root, "texts", [&](const JsonNode& node) { return readText(reader, node, blocks); });
  if (const JsonNode* selected = root.find("selected")) {
    content.selected = reader.cell(*selected, "\"selected\"", kCells);
    if (content.selected && !blocks.contains(*content.selected))
      reader.error(selected->offset, "\"selected\" is outside the world");
  }
  content.border = readBorder(reader, root);
  return content;
}

ChangeEntity readEntityChange(JsonReader& reader, const JsonNode& node,
                              const WorldContent& content) {
  ChangeEntity change;
  if (!reader.object(node, "\"entity\"", {"name", "position", "yaw", "walking", "hurt"}))
    return change;
  const JsonNode* name = reader.required(node, "name", "\"entity\"");
  reader.optional(node, "name", change.name);
  const bool known = std::any_of(content.entities.begin(), content.entities.end(),
                                 [&](const Entity& entity) { return entity.name == change.name; });
  if (name != nullptr && (!known || change.name.empty()))
    reader.error(name->offset, fmt::format("no entity is named \"{}\"", change.name));
  if (const JsonNode* position = node.find("position"))
    change.position = reader.vector(*position, "\"position\"", kPlaces);
  if (const JsonNode* yaw = node.find("yaw")) {
    if (const auto value = reader.number(*yaw, "\"yaw\"", kTurns)) change.yaw = float(*value);
  }
  const std::pair<const char*, std::optional<bool>*> states[] = {{"walking", &change.walking},
                                                                 {"hurt", &change.hurt}};
  for (const auto& [key, state] : states) {
    if (node.find(key) != nullptr) reader.optional(node, key, state->emplace());
  }
  return change;
}

StrikeLightning readLightning(JsonReader& reader, const JsonNode& node) {
  StrikeLightning stroke;
  if (!reader.object(node, "\"lightning\"", {"at", "frames"})) return stroke;
  stroke.at = readPlace(reader, node, "at", "\"lightning\"");
  reader.optional(node, "frames", IntegerRange{1, 1000000}, stroke.frames);
  return stroke;
}

}  // namespace orris
