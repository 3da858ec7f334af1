#include <orris/world/blocks/block_state.h>
#include <orris/world/content/armour.h>
#include <orris/world/saved_things/entity_figures.h>
#include <orris/world/saved_things/saved_text.h>
#include <orris/world/saved_things/saved_things.h>
#include <orris/world/saves/legacy_blocks.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace orris {
namespace {

constexpr double kFarthestEntity = 3.0e7;  // the game's border, blocks
// A save with more kinds than this in a chunk is none of the game or of a mod.
constexpr std::size_t kMostKinds = 256;

std::optional<glm::dvec3> placeIn(const NbtTag& tag, std::string_view name) {
  const std::vector<double> place = tag.numbersAt(name);
  const bool sane = std::ranges::all_of(place, [](double value) {
    return std::isfinite(value) && std::abs(value) < kFarthestEntity;
  });
  if (place.size() != 3 || !sane) return std::nullopt;
  return glm::dvec3(place[0], place[1], place[2]);
}

/// Yaw and pitch, degrees; 0 where they are no angles.
glm::vec2 anglesOf(const NbtTag& tag) {
  const std::vector<double> angles = tag.numbersAt("Rotation");
  if (angles.size() != 2 || !std::isfinite(angles[0]) || !std::isfinite(angles[1])) return {0, 0};
  return {std::remainder(angles[0], 360.0), std::remainder(angles[1], 360.0)};
}

/// "minecraft:stone"; before 1.8 a number. "" for none, and where it is no name.
std::string itemIn(const NbtTag& tag) {
  constexpr std::int64_t kNumbers = 4096;
  const NbtTag* id = tag.find("id");
  if (!id) return "";
  if (id->integer() && *id->integer() > 0 && *id->integer() < kNumbers)
    return legacyState(int(*id->integer()), int(tag.integerAt("Damage") & 15)).name;
  const std::string name = id->string() ? currentKind(*id->string()) : "";
  return name == "minecraft:air" ? "" : name;
}

bool isEnchanted(const NbtTag& item) {
  if (const NbtTag* components = item.find("components")) {
    const NbtTag* found = components->find("minecraft:enchantments");
    if (found && found->find("levels")) found = found->find("levels");
    return found && found->compound() && !found->compound()->empty();
  }
  const NbtTag* tag = item.find("tag");
  if (!tag) return false;
  const NbtList* found = tag->listAt("Enchantments");
  if (!found) found = tag->listAt("ench");
  return found && !found->empty();
}

glm::vec3 rgbColor(std::int64_t rgb) {
  return glm::vec3(float(rgb >> 16 & 255), float(rgb >> 8 & 255), float(rgb & 255)) / 255.0f;
}

/// Of leather, and of what somebody has brewed.
std::optional<glm::vec3> dyeOf(const NbtTag& item) {
  const auto integerIn = [](const NbtTag* tag, const char* name) -> std::optional<std::int64_t> {
    const NbtTag* member = tag ? tag->find(name) : nullptr;
    return member && member->integer() ? std::optional(*member->integer()) : std::nullopt;
  };
  // Since 1.20.5, where a dye was an object at first, and before.
  const NbtTag *components = item.find("components"), *tag = item.find("tag");
  const auto among = [](const NbtTag* holder, const char* name) { return holder ? holder->find(name) : nullptr; };
  for (const auto& rgb : {integerIn(components, "minecraft:dyed_color"),
                          integerIn(among(components, "minecraft:dyed_color"), "rgb"),
                          integerIn(among(components, "minecraft:potion_contents"), "custom_color"),
                          integerIn(among(tag, "display"), "color"), integerIn(tag, "CustomPotionColor")})
    if (rgb) return rgbColor(*rgb);
  return std::nullopt;
}

/// What somebody holds in both hands.
void setHands(const NbtTag& tag, Entity& entity) {
  std::string* hands[] = {&entity.mainHand, &entity.offHand};
  const auto hold = [&](std::size_t hand, const NbtTag& item) {
    *hands[hand] = itemIn(item);
    entity.glint = entity.glint || (!hands[hand]->empty() && isEnchanted(item));
  };
  // 1.9 to 1.21.4, since, and before.
  if (const NbtList* items = tag.listAt("HandItems"))
    for (std::size_t i = 0; i < std::min<std::size_t>(items->size(), 2); ++i) hold(i, (*items)[i]);
  if (const NbtTag* equipment = tag.find("equipment")) {
    if (const NbtTag* item = equipment->find("mainhand")) hold(0, *item);
    if (const NbtTag* item = equipment->find("offhand")) hold(1, *item);
  }
  if (const NbtList* items = tag.listAt("Equipment"); items && !items->empty()) hold(0, items->front());
}

/// What somebody wears.
void setArmour(const NbtTag& tag, Entity& entity) {
  constexpr std::size_t kMost = 4;
  const auto add = [&](const NbtTag& item) {
    const std::string name = itemIn(item);
    if (!armourPieceOf(name) || entity.armour.size() == kMost) return;
    entity.armour.push_back(name);
    entity.glint = entity.glint || isEnchanted(item);
    if (const auto dye = dyeOf(item)) entity.dye = dye;
  };
  // 1.9 to 1.21.4, before, and since.
  for (const char* name : {"ArmorItems", "Equipment"}) {
    if (const NbtList* list = tag.listAt(name)) std::ranges::for_each(*list, add);
  }
  if (const NbtTag* equipment = tag.find("equipment"); equipment && equipment->compound()) {
    for (const auto& [slot, item] : *equipment->compound())
      if (slot != "mainhand" && slot != "offhand") add(item);
  }
}

/// The knot that a leash is tied to; nullopt where it is held by somebody.
std::optional<glm::dvec3> leashOf(const NbtTag& tag) {
  const NbtTag* leash = tag.find("Leash");
  std::optional<glm::dvec3> block;
  if (leash && leash->find("X") && leash->find("Y") && leash->find("Z"))
    block = glm::dvec3(leash->integerAt("X"), leash->integerAt("Y"), leash->integerAt("Z"));
  else
    block = placeIn(tag, "leash");
  if (!block || glm::any(glm::greaterThan(glm::abs(*block), glm::dvec3(kFarthestEntity))))
    return std::nullopt;
  return *block + 0.5;
}

/// On the middle of the side of its block that it hangs on, as far as our figure is thick.
glm::dvec3 placeOfFrame(const Entity& frame) {
  const double yaw = glm::radians(double(frame.yaw)), pitch = glm::radians(double(frame.pitch));
  const glm::dvec3 front(-std::sin(yaw) * std::cos(pitch), -std::sin(pitch),
                         std::cos(yaw) * std::cos(pitch));
  return glm::floor(frame.position) + 0.5 - front * 0.5;
}

float sizeOf(const NbtTag& tag, const EntityFigure& figure) {
  constexpr float kYoung = 0.5f;
  // Of a slime: one of size 1, whose tag is 0, is half a block wide, and our figure three quarters.
  constexpr float kOfSmallest = 0.5f / 0.75f;
  constexpr std::int64_t kLargest = 126;
  if (figure.model == "slime")
    return float(std::clamp<std::int64_t>(tag.integerAt("Size"), 0, kLargest) + 1) * kOfSmallest;
  const bool young =
      tag.integerAt("Age") < 0 || tag.integerAt("IsBaby") != 0 || tag.integerAt("Small") != 0;
  const bool grows = figure.model != "item";  // whose "Age" is another
  return figure.scale * (young && grows ? kYoung : 1);
}

void setItem(const NbtTag& tag, Entity& entity) {
  const NbtTag* item = tag.find("Item");
  if (!item) return;
  entity.item = itemIn(*item);
  entity.glint = isEnchanted(*item);
  entity.dye = dyeOf(*item);
  entity.itemTurn = float(tag.integerAt("ItemRotation") & 7) * 45;
}

Entity entityOf(const NbtTag& tag, const std::string& kind, const EntityFigure& figure,
                const glm::dvec3& position) {
  Entity entity;
  entity.kind = kind;
  entity.model = figure.model;
  entity.position = position;
  entity.scale = sizeOf(tag, figure);
  const glm::vec2 angles = anglesOf(tag);
  entity.yaw = angles.x;
  entity.hurt = tag.integerAt("HurtTime") > 0;
  entity.hidden = tag.integerAt("Invisible") != 0;
  entity.leash = leashOf(tag);
  if (const NbtTag* name = tag.find("CustomName"); name && tag.integerAt("CustomNameVisible") != 0)
    entity.tag = drawnText(*name);
  if (figure.model == "item") {
    setItem(tag, entity);
  } else if (figure.model == "item_frame") {
    setItem(tag, entity);
    entity.pitch = angles.y;
    entity.position = placeOfFrame(entity);
  } else if (figure.model == "arrow") {
    // The game's arrows measure both angles the other way round.
    entity.yaw = -angles.x;
    entity.pitch = -angles.y;
  } else if (figure.model == "player") {
    setHands(tag, entity);
    setArmour(tag, entity);
  } else if (figure.model == "armor_stand") {
    setArmour(tag, entity);
  }
  return entity;
}

void readSavedEntity(const NbtTag& tag, SavedThings& things) {
  const std::string kind = currentKind(tag.stringAt("id"));
  const auto position = placeIn(tag, "Pos");
  const EntityFigure* figure = findFigure(kind);
  if (kind.empty() || !position) {
    ++things.damaged;
  } else if (figure) {
    things.entities.push_back(entityOf(tag, kind, *figure, *position));
  } else if (!isUnseenKind(kind)) {
    const bool room = things.figureless.size() < kMostKinds || things.figureless.contains(kind);
    ++(room ? things.figureless[kind] : things.damaged);
  }
  if (const NbtList* riders = tag.listAt("Passengers")) readEntities(*riders, things);
}

}  // namespace

void readEntities(const NbtList& list, SavedThings& things) {
  for (const NbtTag& tag : list) readSavedEntity(tag, things);
}

void readEntityChunk(std::string_view tags, SavedThings& things) {
  NbtError error;
  const std::optional<NbtTag> root = parseNbt(tags, error);
  const NbtList* list = root ? root->listAt("Entities") : nullptr;
  if (list) return readEntities(*list, things);
  if (things.unreadableChunks++ == 0)
    things.problem = root ? "it has no list \"Entities\"" : error.message;
}

}  // namespace orris
