#include <orris/world/content/entity_models.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <utility>

#include <orris/world/blocks/block_facts.h>

namespace orris {
namespace {

using L = ModelLayer;

constexpr ModelBox kPlayer[] = {
    {{-2, -12, -2}, {2, 0, 2}, {-2, 12, 0}, "figure_trousers", {}, L::Body, {}, 32},
    {{-2, -12, -2}, {2, 0, 2}, {2, 12, 0}, "figure_trousers", {}, L::Body, {}, -32},
    {{-4, 0, -2}, {4, 12, 2}, {0, 12, 0}, "figure_shirt", {}},
    {{-2, -10, -2}, {2, 2, 2}, {-6, 22, 0}, "figure_sleeve", {}, L::Body, {}, -28},
    {{-2, -10, -2}, {2, 2, 2}, {6, 22, 0}, "figure_sleeve", {}, L::Body, {}, 28},
    {{-4, 0, -4}, {4, 8, 4}, {0, 24, 0}, "figure_hair", "figure_face"},
    // The outer layer.
    {{-2.25f, -12.25f, -2.25f}, {2.25f, 0.25f, 2.25f}, {-2, 12, 0}, {}, {}, L::Body, {}, 32},
    {{-2.25f, -12.25f, -2.25f}, {2.25f, 0.25f, 2.25f}, {2, 12, 0}, {}, {}, L::Body, {}, -32},
    {{-4.25f, -0.25f, -2.25f}, {4.25f, 12.25f, 2.25f}, {0, 12, 0}, {}, {}},
    {{-2.25f, -10.25f, -2.25f}, {2.25f, 2.25f, 2.25f}, {-6, 22, 0}, {}, {}, L::Body, {}, -28},
    {{-2.25f, -10.25f, -2.25f}, {2.25f, 2.25f, 2.25f}, {6, 22, 0}, {}, {}, L::Body, {}, 28},
    {{-4.5f, -0.5f, -4.5f}, {4.5f, 8.5f, 4.5f}, {0, 24, 0}, {}, {}}};
constexpr glm::ivec3 kLimb(4, 12, 4), kChest(8, 12, 4), kHead(8, 8, 8);
constexpr BoxSkin kPlayerSkin[] = {{"skin_player", 0, 16},
                                   {"skin_player", 16, 48},
                                   {"skin_player", 16, 16},
                                   {"skin_player", 40, 16},
                                   {"skin_player", 32, 48},
                                   {"skin_player", 0, 0},
                                   {"skin_player", 0, 32, BoxFold::Standing, kLimb},
                                   {"skin_player", 0, 48, BoxFold::Standing, kLimb},
                                   {"skin_player", 16, 32, BoxFold::Standing, kChest},
                                   {"skin_player", 40, 32, BoxFold::Standing, kLimb},
                                   {"skin_player", 48, 48, BoxFold::Standing, kLimb},
                                   {"skin_player", 32, 0, BoxFold::Standing, kHead}};
constexpr ModelBox kCow[] = {
    {{-2, -12, -2}, {2, 0, 2}, {-4, 12, -7}, "cow_hide", {}, L::Body, {}, 24},
    {{-2, -12, -2}, {2, 0, 2}, {4, 12, -7}, "cow_hide", {}, L::Body, {}, -24},
    {{-2, -12, -2}, {2, 0, 2}, {-4, 12, 6}, "cow_hide", {}, L::Body, {}, -24},
    {{-2, -12, -2}, {2, 0, 2}, {4, 12, 6}, "cow_hide", {}, L::Body, {}, 24},
    {{-6, 0, -9}, {6, 10, 9}, {0, 11, 0}, "cow_hide", {}},
    {{-4, -4, 0}, {4, 4, 6}, {0, 20, 8}, "cow_hide", "cow_face"},
    {{-5, 3, 2}, {-4, 6, 3}, {0, 20, 8}, "bone", {}},
    {{4, 3, 2}, {5, 6, 3}, {0, 20, 8}, "bone", {}},
    {{-2, -1, -3}, {2, 0, 3}, {0, 11, -6}, {}, {}}};
constexpr BoxSkin kCowSkin[] = {
    {"skin_cow", 0, 16},  {"skin_cow", 0, 16}, {"skin_cow", 0, 16},
    {"skin_cow", 0, 16},  {"skin_cow", 18, 4, BoxFold::Lying},
    {"skin_cow", 0, 0},   {"skin_cow", 22, 0}, {"skin_cow", 22, 0},
    {"skin_cow", 52, 0, BoxFold::Lying}};
constexpr ModelBox kSpider[] = {
    {{-4, -4, 0}, {4, 4, 8}, {0, 9, 3}, "spider_hide", {}},
    {{-4, -4, 0}, {4, 4, 8}, {0, 9, 3}, {}, "spider_eyes", L::Eyes},
    {{-3, -3, -3}, {3, 3, 3}, {0, 9, 0}, "spider_hide", {}},
    {{-5, -4, -12}, {5, 4, 0}, {0, 9, -3}, "spider_hide", {}},
    {{0, -1, -1}, {16, 1, 1}, {4, 9, 2}, "spider_hide", {}, L::Body, {0, -35, -30}, 10},
    {{0, -1, -1}, {16, 1, 1}, {4, 9, 1}, "spider_hide", {}, L::Body, {0, -12, -34}, -10},
    {{0, -1, -1}, {16, 1, 1}, {4, 9, 0}, "spider_hide", {}, L::Body, {0, 12, -34}, 10},
    {{0, -1, -1}, {16, 1, 1}, {4, 9, -1}, "spider_hide", {}, L::Body, {0, 35, -30}, -10},
    {{-16, -1, -1}, {0, 1, 1}, {-4, 9, 2}, "spider_hide", {}, L::Body, {0, 35, 30}, -10},
    {{-16, -1, -1}, {0, 1, 1}, {-4, 9, 1}, "spider_hide", {}, L::Body, {0, 12, 34}, 10},
    {{-16, -1, -1}, {0, 1, 1}, {-4, 9, 0}, "spider_hide", {}, L::Body, {0, -12, 34}, -10},
    {{-16, -1, -1}, {0, 1, 1}, {-4, 9, -1}, "spider_hide", {}, L::Body, {0, -35, 30}, 10}};
constexpr BoxSkin kSpiderSkin[] = {{"skin_spider", 32, 4},
                                   {"skin_spider_eyes", 32, 4},
                                   {"skin_spider", 0, 0},
                                   {"skin_spider", 0, 12},
                                   {"skin_spider", 18, 0, BoxFold::Mirrored},
                                   {"skin_spider", 18, 0, BoxFold::Mirrored},
                                   {"skin_spider", 18, 0, BoxFold::Mirrored},
                                   {"skin_spider", 18, 0, BoxFold::Mirrored},
                                   {"skin_spider", 18, 0},
                                   {"skin_spider", 18, 0},
                                   {"skin_spider", 18, 0},
                                   {"skin_spider", 18, 0}};
constexpr ModelBox kSlime[] = {{{-3, 1, -3}, {3, 7, 3}, {}, "slime_core", "slime_face"},
                               {{-4, 0, -4}, {4, 8, 4}, {}, "slime_skin", {}, L::Translucent},
                               {{-3.25f, 4, 1.5f}, {-1.25f, 6, 3.5f}, {}, {}, {}},
                               {{1.25f, 4, 1.5f}, {3.25f, 6, 3.5f}, {}, {}, {}},
                               {{0, 2, 2.5f}, {1, 3, 3.5f}, {}, {}, {}}};
constexpr BoxSkin kSlimeSkin[] = {{"skin_slime", 0, 16},
                                  {"skin_slime", 0, 0},
                                  {"skin_slime", 32, 0},
                                  {"skin_slime", 32, 4},
                                  {"skin_slime", 32, 8}};
constexpr ModelBox kStand[] = {
    {{-6, 0, -6}, {6, 1, 6}, {}, "smooth_stone", {}},
    {{-1, 1, -1}, {1, 12, 1}, {-2, 0, 0}, "oak_planks", {}},
    {{-1, 1, -1}, {1, 12, 1}, {2, 0, 0}, "oak_planks", {}},
    {{-4, 12, -1}, {4, 14, 1}, {}, "oak_planks", {}},
    {{-1, 14, -1}, {1, 30, 1}, {}, "oak_planks", {}},
    {{-6, 21, -1.5f}, {6, 24, 1.5f}, {}, "oak_planks", {}},
    {{-3, 14, -1}, {-1, 21, 1}, {}, {}, {}},
    {{1, 14, -1}, {3, 21, 1}, {}, {}, {}},
    {{-1, 23, -1}, {1, 30, 1}, {}, {}, {}}};
constexpr BoxSkin kStandSkin[] = {{"skin_stand", 0, 32},
                                  {"skin_stand", 8, 0},
                                  {"skin_stand", 40, 16, BoxFold::Mirrored},
                                  {"skin_stand", 0, 48},
                                  {"skin_stand"},
                                  {"skin_stand", 0, 26},
                                  {"skin_stand", 16, 0},
                                  {"skin_stand", 48, 16},
                                  {"skin_stand", 0, 0}};
constexpr ModelBox kArrow[] = {{{-0.5f, -0.5f, -6}, {0.5f, 0.5f, 6}, {0, 1, 0}, "oak_planks", {}},
                               {{-1, -1, 6}, {1, 1, 8}, {0, 1, 0}, "stone", {}},
                               {{-2, -0.5f, -8}, {2, 0.5f, -5}, {0, 1, 0}, "white_wool", {}},
                               {{-12, -2, 0}, {4, 2, 0}, {0, 1, 0}, {}, {}, L::Body, {45, -90, 0}},
                               {{-12, -2, 0}, {4, 2, 0}, {0, 1, 0}, {}, {}, L::Body, {-45, -90, 0}},
                               {{-11, -2, -2}, {-11, 2, 2}, {0, 1, 0}, {}, {}, L::Body, {45, -90, 0}}};
constexpr BoxSkin kArrowSkin[] = {{"skin_arrow"},
                                  {"skin_arrow"},
                                  {"skin_arrow"},
                                  {"skin_arrow", 0, 0, BoxFold::Standing, {16, 5, 0}},
                                  {"skin_arrow", 0, 0, BoxFold::Standing, {16, 5, 0}},
                                  {"skin_arrow", 0, 0, BoxFold::Standing, {0, 5, 5}}};
constexpr ModelBox kFrame[] = {{{-6, -6, 0}, {6, 6, 1}, {}, "oak_planks", "frame_leather"}};

constexpr EntityTexture kEntityTextures[] = {
    {"armour_iron", {"entity/equipment/humanoid/iron", "models/armor/iron_layer_1"}},
    {"leggings_iron", {"entity/equipment/humanoid_leggings/iron", "models/armor/iron_layer_2"}},
    {"armour_leather", {"entity/equipment/humanoid/leather", "models/armor/leather_layer_1"}},
    {"leggings_leather", {"entity/equipment/humanoid_leggings/leather", "models/armor/leather_layer_2"}},
    {"armour_chainmail", {"entity/equipment/humanoid/chainmail", "models/armor/chainmail_layer_1"}},
    {"leggings_chainmail", {"entity/equipment/humanoid_leggings/chainmail", "models/armor/chainmail_layer_2"}},
    {"armour_copper", {"entity/equipment/humanoid/copper", "models/armor/copper_layer_1"}},
    {"leggings_copper", {"entity/equipment/humanoid_leggings/copper", "models/armor/copper_layer_2"}},
    {"armour_gold", {"entity/equipment/humanoid/gold", "models/armor/gold_layer_1"}},
    {"leggings_gold", {"entity/equipment/humanoid_leggings/gold", "models/armor/gold_layer_2"}},
    {"armour_diamond", {"entity/equipment/humanoid/diamond", "models/armor/diamond_layer_1"}},
    {"leggings_diamond", {"entity/equipment/humanoid_leggings/diamond", "models/armor/diamond_layer_2"}},
    {"armour_netherite", {"entity/equipment/humanoid/netherite", "models/armor/netherite_layer_1"}},
    {"leggings_netherite", {"entity/equipment/humanoid_leggings/netherite", "models/armor/netherite_layer_2"}},
    {"armour_turtle", {"entity/equipment/humanoid/turtle_scute", "models/armor/turtle_layer_1"}},
    {"skin_arrow", {"entity/projectiles/arrow", ""}, 32},
    {"skin_cow", {"entity/cow/temperate_cow", "entity/cow/cow"}},
    {"skin_player", {"entity/player/wide/steve", "entity/steve"}},
    {"skin_slime", {"entity/slime/slime", ""}},
    {"skin_spider", {"entity/spider/spider", ""}},
    {"skin_spider_eyes", {"entity/spider_eyes", ""}},
    {"skin_stand", {"entity/armorstand/wood", ""}}};

static_assert(std::size(kPlayer) == std::size(kPlayerSkin));
static_assert(std::size(kCow) == std::size(kCowSkin));
static_assert(std::size(kSpider) == std::size(kSpiderSkin));
static_assert(std::size(kSlime) == std::size(kSlimeSkin));
static_assert(std::size(kStand) == std::size(kStandSkin));
static_assert(std::size(kArrow) == std::size(kArrowSkin));

constexpr std::array<EntityModel, 8> kEntityModels{{{"armor_stand", 1, kStand, false, kStandSkin, {-1, -1}, true},
                                              {"arrow", 1, kArrow, false, kArrowSkin},
                                              {"cow", 1, kCow, false, kCowSkin},
                                              {"item", 1, {}, true},
                                              {"item_frame", 1, kFrame, true},
                                              {"player", 0.9375f, kPlayer, false, kPlayerSkin, {3, 4}, true},
                                              {"slime", 1.5f, kSlime, false, kSlimeSkin},
                                              {"spider", 1, kSpider, false, kSpiderSkin}}};

/// Corners of each side, -1 or 1 along x, y and z, in the order that skinUv() gives.
constexpr int kSideCorners[6][4][3] = {
    {{-1, -1, 1}, {-1, -1, -1}, {1, -1, -1}, {1, -1, 1}},  // down
    {{-1, 1, -1}, {-1, 1, 1}, {1, 1, 1}, {1, 1, -1}},      // up
    {{1, 1, -1}, {1, -1, -1}, {-1, -1, -1}, {-1, 1, -1}},  // north
    {{-1, 1, 1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}},      // south
    {{-1, 1, -1}, {-1, -1, -1}, {-1, -1, 1}, {-1, 1, 1}},  // west
    {{1, 1, 1}, {1, -1, 1}, {1, -1, -1}, {1, 1, -1}},      // east
};

/// The direction in the box as it was unwrapped, upright, of one in the box as it is.
glm::ivec3 unwrapped(const glm::ivec3& v, BoxFold fold) {
  if (fold == BoxFold::Lying) return {v.x, v.z, -v.y};
  return fold == BoxFold::Mirrored ? glm::ivec3(-v.x, v.y, v.z) : v;
}

/// The game's unwrapping: top and bottom over right side, front, left side and back. A box without
/// thickness has the same on both of its sides.
glm::vec2 placeOnSkin(const glm::ivec3& out, const glm::ivec3& corner, const glm::ivec3& size) {
  const glm::vec3 low = (glm::vec3(corner) + 1.0f) * 0.5f * glm::vec3(size);
  const glm::vec3 high = glm::vec3(size) - low;
  const auto w = float(size.x), d = float(size.z);
  if (out.y != 0) return {d + (out.y > 0 ? 0 : w) + low.x, low.z};
  if (out.x < 0 || (out.x > 0 && size.x == 0)) return {low.z, d + high.y};
  if (out.x > 0) return {d + w + high.z, d + high.y};
  if (out.z > 0 || size.z == 0) return {d + low.x, d + high.y};
  return {d + w + d + high.x, d + high.y};
}

}  // namespace

const EntityModel* findEntityModel(std::string_view kind) {
  constexpr std::string_view kNamespace = "minecraft:";
  if (kind.starts_with(kNamespace)) kind.remove_prefix(kNamespace.size());
  const auto* found = std::ranges::find(kEntityModels, kind, &EntityModel::kind);
  return found == kEntityModels.end() ? nullptr : found;
}

std::vector<std::string> entityKinds() {
  std::vector<std::string> kinds;
  for (const EntityModel& model : kEntityModels) kinds.emplace_back(model.kind);
  return kinds;
}

std::vector<std::string> texturesOf(const EntityModel& model) {
  std::set<std::string> names;
  for (const ModelBox& box : model.boxes)
    for (const std::string_view name : {box.side, box.front})
      if (!name.empty()) names.emplace(name);
  return {names.begin(), names.end()};
}

std::vector<const EntityTexture*> skinsOf(const EntityModel& model) {
  std::vector<const EntityTexture*> skins;
  for (const BoxSkin& skin : model.skins) {
    const EntityTexture* texture = findEntityTexture(skin.texture);
    if (std::ranges::find(skins, texture) == skins.end()) skins.push_back(texture);
  }
  return skins;
}

const EntityTexture* findEntityTexture(std::string_view name) {
  const auto* found = std::ranges::find(kEntityTextures, name, &EntityTexture::name);
  return found == std::end(kEntityTextures) ? nullptr : found;
}

std::array<glm::vec2, 4> skinUv(const ModelBox& box, const BoxSkin& skin, int side) {
  glm::ivec3 size = skin.size;
  if (size == glm::ivec3(0)) {
    size = glm::ivec3(box.to - box.from);
    if (skin.fold == BoxFold::Lying) std::swap(size.y, size.z);
  }
  const glm::ivec3 out = unwrapped(normalOf(FaceDirection(side)), skin.fold);
  std::array<glm::vec2, 4> uv;
  for (std::size_t i = 0; i < uv.size(); ++i) {
    const int* corner = kSideCorners[side][i];
    uv[i] = glm::vec2(skin.u, skin.v) +
            placeOnSkin(out, unwrapped({corner[0], corner[1], corner[2]}, skin.fold), size);
  }
  return uv;
}

std::vector<std::string> contentTextureNames() {
  std::set<std::string> names = {"item_sprite",    "flame_particle", "smoke_particle",
                                 "spark_particle", "glyph", "rain",           "snow_flakes",
                                 "beacon_beam",    "glint",          "world_border", "armour_plate", "armour_helmet"};
  for (int stage = 0; stage < 10; ++stage) names.insert(crackTexture(stage));
  for (const EntityModel& model : kEntityModels)
    for (const std::string& name : texturesOf(model)) names.insert(name);
  return {names.begin(), names.end()};
}

std::string crackTexture(int stage) { return "crack_" + std::to_string(stage); }

}  // namespace orris
