// Entities, their eyes, armour, glint and leashes, and where they have items.
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include <orris/plan/lists/list_writer.h>
#include <orris/world/content/armour.h>
#include <orris/world/content/entity_models.h>

namespace orris {
namespace {

constexpr float kModelTexels = 16;
// The game's overlay of what is hurt. Iris: entityColor.
constexpr glm::vec4 kHurt(1, 0, 0, 0.302f);

/// Right and up of each side of a box as seen from outside, in the order of FaceDirection.
constexpr glm::vec3 kRight[] = {{1, 0, 0}, {1, 0, 0}, {-1, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, 0, -1}};
constexpr glm::vec3 kUp[] = {{0, 0, 1}, {0, 0, -1}, {0, 1, 0}, {0, 1, 0}, {0, 1, 0}, {0, 1, 0}};

glm::mat4 turned(const glm::vec3& degrees) {
  glm::mat4 m(1);
  for (const int axis : {2, 1, 0}) {
    glm::vec3 around(0);
    around[axis] = 1;
    m = glm::rotate(m, glm::radians(degrees[axis]), around);
  }
  return m;
}

glm::mat4 standing(const ListWriter& writer, const glm::dvec3& position, float yaw,
                   float pitch = 0) {
  const glm::mat4 moved = glm::translate(glm::mat4(1), writer.local(position));
  const glm::mat4 turned = glm::rotate(moved, glm::radians(-yaw), glm::vec3(0, 1, 0));
  return glm::rotate(turned, glm::radians(pitch), glm::vec3(1, 0, 0));
}

glm::mat4 boxMatrix(const ModelBox& box, float step) {
  glm::vec3 turn = box.turn;
  turn.x += box.swing * step;
  return glm::translate(glm::mat4(1), box.pivot) * turned(turn);
}

/// One side of a box; texels of the texture are as large as those of the model.
ContentQuad boxSide(const ModelBox& box, int side, const glm::mat4& place) {
  const glm::vec3 middle = (box.from + box.to) * 0.5f, half = (box.to - box.from) * 0.5f;
  const glm::vec3 right = kRight[side] * half, up = kUp[side] * half;
  const glm::vec3 out = glm::cross(kRight[side], kUp[side]) * half;
  ContentQuad quad;
  const glm::vec3 corners[] = {up - right, -up - right, right - up, right + up};
  for (int i = 0; i < 4; ++i)
    quad.corners[static_cast<std::size_t>(i)] =
        glm::vec3(place * glm::vec4(middle + out + corners[i], 1));
  return quad;
}

glm::vec2 sideSize(const ModelBox& box, int side) {
  const glm::vec3 size = box.to - box.from;
  return {std::abs(glm::dot(kRight[side], size)), std::abs(glm::dot(kUp[side], size))};
}

bool hasOwnTextures(const ModelBox& box) { return !box.side.empty() || !box.front.empty(); }

/// How a box is seen: in its skin, where a resource pack has that, or with textures of ours.
struct BoxLook {
  const BoxSkin* skin = nullptr;
  const AtlasTile* tile = nullptr;  ///< of the skin
  bool seen = true;
};

/// Keeps a pointer to `skin`.
BoxLook lookOf(const ListWriter& writer, const ModelBox& box, const BoxSkin& skin) {
  const auto& tiles = writer.scene.content.atlas.tiles;
  const auto tile = tiles.find(std::string(skin.texture));
  if (tile == tiles.end()) return {nullptr, nullptr, hasOwnTextures(box)};
  return {&skin, &tile->second, skin.u != BoxSkin::kNone};
}

/// The part of the atlas that a side of a box in its skin wears.
std::array<glm::vec2, 4> skinUvOf(const ListWriter& writer, const ModelBox& box,
                                  const BoxLook& look, int side) {
  const Image8& atlas = writer.scene.content.atlas.albedo;
  const glm::vec2 size(atlas.width, atlas.height);
  const float texels = (look.tile->max.x - look.tile->min.x) * size.x;
  const glm::vec2 scale =
      texels / static_cast<float>(findEntityTexture(look.skin->texture)->width) / size;
  std::array<glm::vec2, 4> uv = skinUv(box, *look.skin, side);
  for (glm::vec2& place : uv) place = glm::min(look.tile->min + place * scale, look.tile->max);
  return uv;
}

/// The sides of a box. `m` places it; `like`: light and colour of each side.
void addBox(ListWriter& writer, const ModelBox& box, const BoxLook& look, const glm::mat4& m, const ContentQuad& like) {
  constexpr int kFront = static_cast<int>(FaceDirection::South);
  for (int side = 0; side < 6; ++side) {
    const glm::vec2 size = sideSize(box, side);
    if (size.x * size.y == 0) continue;
    ContentQuad quad = boxSide(box, side, m);
    quad.light = like.light;
    quad.color = like.color;
    if (look.skin) {
      quad.uv = skinUvOf(writer, box, look, side);
    } else {
      if (box.layer == ModelLayer::Eyes && side != kFront) continue;
      const std::string_view name = side == kFront && !box.front.empty() ? box.front : box.side;
      const glm::vec2 part = glm::min(size / kModelTexels, glm::vec2(1));
      quad.uv = tileUv(writer.scene.content.atlas.tile(std::string(name)), glm::vec2(0), part);
    }
    writer.quad(quad);
  }
}

void addBoxes(ListWriter& writer, const Entity& entity, const EntityModel& model, ModelLayer layer,
              const glm::mat4& place, float step, glm::ivec2 light) {
  static constexpr BoxSkin kNoSkin{};
  ContentQuad like;
  like.light = light;
  for (std::size_t i = 0; i < model.boxes.size() && !entity.hidden; ++i) {
    const ModelBox& box = model.boxes[i];
    const BoxSkin& skin = model.skins.empty() ? kNoSkin : model.skins[i];
    const BoxLook look = lookOf(writer, box, skin);
    if (box.layer == layer && look.seen) addBox(writer, box, look, place * boxMatrix(box, step), like);
  }
}

/// Calls `part(box, look)` for all that is seen of a piece of armour.
template <class Part>
void forParts(const ListWriter& writer, const ArmourPiece& piece, Part part) {
  for (const ArmourPart& each : armourParts()) {
    if (each.slot != piece.slot) continue;
    BoxSkin skin = each.skin;
    skin.texture = piece.skin;
    const BoxLook look = lookOf(writer, each.box, skin);
    if (look.seen) part(each.box, look);
  }
}

/// The same sides that wear armour, with coordinates for the texture of the glint.
void addArmourGlint(ListWriter& writer, const Entity& entity, const glm::mat4& place, float step) {
  for (const WornPiece& worn : wornBy(entity))
    forParts(writer, worn.piece, [&](const ModelBox& box, const BoxLook&) {
      const glm::mat4 m = place * boxMatrix(box, step);
      for (int side = 0; side < 6; ++side) {
        ContentQuad quad = boxSide(box, side, m);
        quad.uv = tileUv({glm::vec2(0), sideSize(box, side) / kModelTexels});
        writer.quad(quad);
      }
    });
}

float stepOf(const Entity& entity, const FrameState& state) {
  constexpr float kStepsPerSecond = 1.1f;
  // A still that shows a step, not the moment between two.
  constexpr float kFirst = 0.2f;
  if (!entity.walking) return 0;
  return std::sin((state.frameTimeCounter * kStepsPerSecond + kFirst) * 6.2831853f);
}

bool isDropped(const Entity& entity) { return findEntityModel(entity.model)->kind == "item"; }

/// Where a model's item is, as a cube 0..1, that resource packs draw: as the game puts it.
glm::mat4 posedMatrix(const ListWriter& writer, const Entity& entity, const ItemLook& look) {
  constexpr float kFrameDepth = 1 / 16.0f, kFramed = 0.5f;
  glm::mat4 m = standing(writer, entity.position, entity.yaw, entity.pitch);
  if (isDropped(entity)) {
    const float t = writer.state.frameTimeCounter;
    const float height = 0.1f + 0.25f * look.poseOf(DisplayPlace::Ground).scale.y;
    m = glm::translate(m, {0, height + 0.1f * std::sin(t * 2), 0});
    return glm::rotate(m, t, glm::vec3(0, 1, 0)) * look.posed(DisplayPlace::Ground);
  }
  // The game's frames look to -z.
  m = glm::translate(m, {0, 0, kFrameDepth});
  m = glm::rotate(m, glm::radians(180.0f), glm::vec3(0, 1, 0));
  m = glm::rotate(m, glm::radians(entity.itemTurn), glm::vec3(0, 0, 1));
  return glm::scale(m, glm::vec3(kFramed)) * look.posed(DisplayPlace::Fixed);
}

/// The same of any item.
glm::mat4 itemMatrix(const ListWriter& writer, const Entity& entity) {
  if (const ItemLook* look = writer.scene.content.lookOf(entity.item))
    return posedMatrix(writer, entity, *look);
  const bool block = !writer.scene.content.items.at(entity.item).boxes.empty();
  glm::mat4 m = standing(writer, entity.position, entity.yaw, entity.pitch);
  float size = block ? 0.25f : 0.5f;
  if (isDropped(entity)) {
    const float t = writer.state.frameTimeCounter;
    m = glm::translate(m, {0, 0.3f + 0.1f * std::sin(t * 2), 0});
    m = glm::rotate(m, t, glm::vec3(0, 1, 0));
  } else {
    m = glm::translate(m, {0, 0, 0.14f});
    m = glm::rotate(m, glm::radians(-entity.itemTurn), glm::vec3(0, 0, 1));
    size = 0.4f;
  }
  return glm::translate(glm::scale(m, glm::vec3(size)), glm::vec3(-0.5f));
}

/// How a third person holds an item that no resource pack draws.
DisplayPose ownPose(const BlockFacts& facts) {
  // The game's block/block and item/generated.
  if (!facts.boxes.empty()) return {{75, 45, 0}, {0, 2.5f, 0}, glm::vec3(0.375f)};
  return {{0, 0, 0}, {0, 3, 1}, glm::vec3(0.55f)};
}

/// Where an arm holds an item, as a cube 0..1. The game: ItemInHandLayer, whose models look to -z with y down.
glm::mat4 thirdPersonMatrix(const ListWriter& writer, const ModelBox& arm, const std::string& item, bool left,
                     const glm::mat4& place, float step) {
  const float side = left ? -1.0f : 1.0f;
  const glm::vec3 inHand(side, 2, -10);
  glm::mat4 m = place * boxMatrix(arm, step);
  m = glm::translate(m, {side, 0, 0});  // the game's arm hangs from its inner side
  m = glm::rotate(m, glm::radians(90.0f), glm::vec3(1, 0, 0));
  m = glm::rotate(m, glm::radians(180.0f), glm::vec3(0, 1, 0));
  m = glm::scale(glm::translate(m, inHand), glm::vec3(kModelTexels));
  const DisplayPlace hand = left ? DisplayPlace::ThirdLeft : DisplayPlace::ThirdRight;
  if (const ItemLook* look = writer.scene.content.lookOf(item)) return m * look->posed(hand);
  const DisplayPose pose = ownPose(writer.scene.content.items.at(item));
  return m * poseMatrix(left ? mirroredPose(pose) : pose);
}

struct HeldItem {
  const std::string* item = nullptr;
  glm::mat4 place{1};
};
std::vector<HeldItem> heldItems(const ListWriter& writer, const EntityModel& model, const Entity& entity,
                                const glm::mat4& place, float step) {
  std::vector<HeldItem> held;
  const std::string* items[] = {&entity.mainHand, &entity.offHand};
  for (std::size_t i = 0; i < model.arms.size(); ++i) {
    if (model.arms[i] < 0 || items[i]->empty()) continue;
    const ModelBox& arm = model.boxes[std::size_t(model.arms[i])];
    held.push_back({items[i], thirdPersonMatrix(writer, arm, *items[i], i == 1, place, step)});
  }
  return held;
}

/// What a layer of an entity's model is drawn as, with the uniforms of that entity.
ContentDraw drawOf(const ListWriter& writer, Geometry geometry, const Entity& entity) {
  ContentDraw draw;
  draw.geometry = geometry;
  draw.middle = writer.local(entity.position);
  draw.entity = entity.kind;
  if (entity.hurt) draw.entityColor = kHurt;
  return draw;
}

/// Each piece is a draw of its own, as packs know it by its item (Iris: currentRenderedItemId).
void addArmour(ListWriter& writer, const Entity& entity, const glm::mat4& place, float step, glm::ivec2 light) {
  for (const auto& [item, piece] : wornBy(entity)) {
    ContentDraw draw = drawOf(writer, Geometry::Entities, entity);
    draw.item = item;
    writer.begin(draw);
    ContentQuad like;
    like.light = light;
    forParts(writer, piece, [&, &worn = piece](const ModelBox& box, const BoxLook& look) {
      const glm::vec3 color = look.skin ? worn.skinColor : worn.color;
      like.color = glm::vec4(worn.takesDye ? entity.dye.value_or(color) : color, 1);
      addBox(writer, box, look, place * boxMatrix(box, step), like);
    });
  }
}

float heightOf(const EntityModel& model) {
  float height = 0;
  for (const ModelBox& box : model.boxes)
    if (hasOwnTextures(box))
      height = std::max(height, (box.pivot.y + box.to.y) * model.scale / kModelTexels);
  return height;
}

/// Faces the eye, as the game's do, on a dark board that is seen through.
void addTag(ListWriter& writer, const Entity& entity, float height, glm::ivec2 light) {
  constexpr float kOver = 0.5f, kCapital = 0.175f, kMargin = 0.3f, kBoardAlpha = 0.25f;
  // In front of the board.
  constexpr float kNearer = 0.01f;
  const glm::mat4 towards(glm::mat3(writer.state.gbufferModelViewInverse));
  const glm::vec3 middle = writer.local(entity.position + glm::dvec3(0, height + kOver, 0));
  const glm::mat4 place =
      glm::scale(glm::translate(glm::mat4(1), middle) * towards, glm::vec3(kCapital));
  ContentDraw draw = drawOf(writer, Geometry::EntitiesTranslucent, entity);
  draw.entity = "minecraft:name_tag";  // as Iris names it
  draw.entityColor = glm::vec4(0);  // the name of what is hurt is not red
  writer.begin(draw);
  ContentQuad square;
  const glm::vec2 half(glyphsWidth(entity.tag) / 2 + kMargin, 0.5f + kMargin);
  const glm::vec2 corners[] = {{-half.x, half.y}, -half, {half.x, -half.y}, half};
  for (std::size_t i = 0; i < 4; ++i)
    square.corners[i] = glm::vec3(place * glm::vec4(corners[i], 0, 1));
  square.uv = tileUv(writer.scene.content.atlas.tile("glyph"));
  square.color = glm::vec4(0, 0, 0, kBoardAlpha);
  square.light = light;
  writer.quad(square);
  square.color = glm::vec4(1);
  addGlyphs(writer, entity.tag, glm::translate(place, {0, 0, kNearer / kCapital}), square);
}

void addEntity(ListWriter& writer, const Entity& entity) {
  const EntityModel* model = findEntityModel(entity.model);
  if (model == nullptr) return;
  const glm::ivec2 light = writer.lightAt(entity.position + glm::dvec3(0, 0.5, 0));
  const float step = stepOf(entity, writer.state);
  const glm::mat4 place =
      glm::scale(standing(writer, entity.position, entity.yaw, entity.pitch),
                 glm::vec3(model->scale * entity.scale / kModelTexels));
  writer.begin(drawOf(writer, Geometry::Entities, entity));
  addBoxes(writer, entity, *model, ModelLayer::Body, place, step, light);
  addArmour(writer, entity, place, step, light);
  writer.begin(drawOf(writer, Geometry::EntitiesTranslucent, entity));
  addBoxes(writer, entity, *model, ModelLayer::Translucent, place, step, light);
  writer.begin(drawOf(writer, Geometry::Eyes, entity));
  addBoxes(writer, entity, *model, ModelLayer::Eyes, place, step, {240, 240});
  if (model->carriesItem && !entity.item.empty()) {
    const bool translucent = isTranslucentItem(writer.scene, entity.item);
    ContentDraw draw =
        drawOf(writer, translucent ? Geometry::EntitiesTranslucent : Geometry::Entities, entity);
    draw.item = entity.item;
    writer.begin(draw);
    addItem(writer, entity.item, itemMatrix(writer, entity), light, entity.dye);
  }
  for (const HeldItem& held : heldItems(writer, *model, entity, place, step)) {
    const bool translucent = isTranslucentItem(writer.scene, *held.item);
    ContentDraw draw =
        drawOf(writer, translucent ? Geometry::EntitiesTranslucent : Geometry::Entities, entity);
    draw.item = *held.item;
    writer.begin(draw);
    addItem(writer, *held.item, held.place, light, entity.dye);
  }
  if (!entity.tag.empty()) addTag(writer, entity, heightOf(*model) * entity.scale, light);
  if (!entity.glint) return;
  writer.begin(drawOf(writer, Geometry::Glint, entity));
  addArmourGlint(writer, entity, place, step);
  if (model->carriesItem && !entity.item.empty())
    addItem(writer, entity.item, itemMatrix(writer, entity), light);
  for (const HeldItem& held : heldItems(writer, *model, entity, place, step)) addItem(writer, *held.item, held.place, light);
}

/// Two ribbons that cross, hanging through.
void addLeash(ListWriter& writer, const Entity& entity) {
  constexpr int kParts = 24;
  constexpr float kWidth = 0.025f, kHeight = 0.9f, kSag = 0.4f;
  const glm::vec3 from = writer.local(entity.position + glm::dvec3(0, kHeight, 0));
  const glm::vec3 to = writer.local(*entity.leash);
  const auto at = [&](int i) {
    const float t = static_cast<float>(i) / kParts;
    return glm::mix(from, to, t) - glm::vec3(0, kSag * 4 * t * (1 - t), 0);
  };
  writer.begin(drawOf(writer, Geometry::Leash, entity));
  for (int i = 0; i < kParts; ++i) {
    const float tone = i % 2 == 0 ? 1.0f : 0.7f;
    for (const glm::vec3& side : {glm::vec3(0, kWidth, 0), glm::vec3(kWidth, 0, kWidth)}) {
      ContentQuad quad;
      quad.corners = {at(i) + side, at(i) - side, at(i + 1) - side, at(i + 1) + side};
      quad.color = glm::vec4(glm::vec3(0.5f, 0.4f, 0.3f) * tone, 1);
      quad.light = writer.lightAt(entity.position + glm::dvec3(0, kHeight, 0));
      quad.hasNormal = false;
      writer.quad(quad);
    }
  }
}

void addBody(ListWriter& writer) {
  constexpr double kEyeHeight = 1.62;
  const EntityModel* model = findEntityModel("player");
  Entity player;
  player.kind = "minecraft:player";
  player.model = "player";
  player.position = writer.state.cameraPosition - glm::dvec3(0, kEyeHeight, 0);
  writer.begin(drawOf(writer, Geometry::PlayerBody, player));
  const glm::mat4 place = glm::scale(standing(writer, player.position, writer.state.camera.yaw),
                                     glm::vec3(model->scale / kModelTexels));
  addBoxes(writer, player, *model, ModelLayer::Body, place, 0, writer.lightAt(player.position));
}

}  // namespace

void addEntities(ListWriter& writer) {
  for (const Entity& entity : writer.scene.world.content.entities) {
    if (entity.leash) addLeash(writer, entity);
    addEntity(writer, entity);
  }
  if (writer.scene.world.environment.player.body) addBody(writer);
}

}  // namespace orris
