#include <orris/world/content/entity_models.h>

#include <algorithm>
#include <array>
#include <set>

namespace orris {
namespace {

using L = ModelLayer;

constexpr ModelBox kPlayer[] = {
    {{-2, -12, -2}, {2, 0, 2}, {-2, 12, 0}, "figure_trousers", {}, L::Body, {}, 32},
    {{-2, -12, -2}, {2, 0, 2}, {2, 12, 0}, "figure_trousers", {}, L::Body, {}, -32},
    {{-4, 0, -2}, {4, 12, 2}, {0, 12, 0}, "figure_shirt", {}},
    {{-2, -10, -2}, {2, 2, 2}, {-6, 22, 0}, "figure_sleeve", {}, L::Body, {}, -28},
    {{-2, -10, -2}, {2, 2, 2}, {6, 22, 0}, "figure_sleeve", {}, L::Body, {}, 28},
    {{-4, 0, -4}, {4, 8, 4}, {0, 24, 0}, "figure_hair", "figure_face"}};
constexpr ModelBox kCow[] = {
    {{-2, -12, -2}, {2, 0, 2}, {-4, 12, -7}, "cow_hide", {}, L::Body, {}, 24},
    {{-2, -12, -2}, {2, 0, 2}, {4, 12, -7}, "cow_hide", {}, L::Body, {}, -24},
    {{-2, -12, -2}, {2, 0, 2}, {-4, 12, 6}, "cow_hide", {}, L::Body, {}, -24},
    {{-2, -12, -2}, {2, 0, 2}, {4, 12, 6}, "cow_hide", {}, L::Body, {}, 24},
    {{-6, 0, -9}, {6, 10, 9}, {0, 11, 0}, "cow_hide", {}},
    {{-4, -4, 0}, {4, 4, 6}, {0, 20, 8}, "cow_hide", "cow_face"},
    {{-5, 3, 2}, {-4, 6, 3}, {0, 20, 8}, "bone", {}},
    {{4, 3, 2}, {5, 6, 3}, {0, 20, 8}, "bone", {}}};
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
constexpr ModelBox kSlime[] = {{{-3, 1, -3}, {3, 7, 3}, {}, "slime_core", "slime_face"},
                               {{-4, 0, -4}, {4, 8, 4}, {}, "slime_skin", {}, L::Translucent}};
constexpr ModelBox kStand[] = {
    {{-6, 0, -6}, {6, 1, 6}, {}, "smooth_stone", {}},
    {{-1, 1, -1}, {1, 12, 1}, {-2, 0, 0}, "oak_planks", {}},
    {{-1, 1, -1}, {1, 12, 1}, {2, 0, 0}, "oak_planks", {}},
    {{-4, 12, -1}, {4, 14, 1}, {}, "oak_planks", {}},
    {{-1, 14, -1}, {1, 30, 1}, {}, "oak_planks", {}},
    {{-6, 21, -1.5f}, {6, 24, 1.5f}, {}, "oak_planks", {}},
    {{-4.5f, 11.5f, -2.5f}, {4.5f, 24.5f, 2.5f}, {}, "armour_plate", {}, L::Body, {}, 0, true},
    {{-8.5f, 17, -2.5f}, {-4.5f, 24.5f, 2.5f}, {}, "armour_plate", {}, L::Body, {}, 0, true},
    {{4.5f, 17, -2.5f}, {8.5f, 24.5f, 2.5f}, {}, "armour_plate", {}, L::Body, {}, 0, true},
    {{-4.5f, 24.5f, -4.5f},
     {4.5f, 32.5f, 4.5f},
     {},
     "armour_plate",
     "armour_helmet",
     L::Body,
     {},
     0,
     true}};
constexpr ModelBox kArrow[] = {{{-0.5f, -0.5f, -6}, {0.5f, 0.5f, 6}, {0, 1, 0}, "oak_planks", {}},
                               {{-1, -1, 6}, {1, 1, 8}, {0, 1, 0}, "stone", {}},
                               {{-2, -0.5f, -8}, {2, 0.5f, -5}, {0, 1, 0}, "white_wool", {}}};
constexpr ModelBox kFrame[] = {{{-6, -6, 0}, {6, 6, 1}, {}, "oak_planks", "frame_leather"}};

constexpr std::array<EntityModel, 8> kModels{{{"armor_stand", 1, kStand},
                                              {"arrow", 1, kArrow},
                                              {"cow", 1, kCow},
                                              {"item", 1, {}, true},
                                              {"item_frame", 1, kFrame, true},
                                              {"player", 0.9375f, kPlayer},
                                              {"slime", 1.5f, kSlime},
                                              {"spider", 1, kSpider}}};

}  // namespace

const EntityModel* findEntityModel(std::string_view kind) {
  constexpr std::string_view kNamespace = "minecraft:";
  if (kind.starts_with(kNamespace)) kind.remove_prefix(kNamespace.size());
  const auto* found = std::ranges::find(kModels, kind, &EntityModel::kind);
  return found == kModels.end() ? nullptr : found;
}

std::vector<std::string> entityKinds() {
  std::vector<std::string> kinds;
  for (const EntityModel& model : kModels) kinds.emplace_back(model.kind);
  return kinds;
}

std::vector<std::string> texturesOf(const EntityModel& model) {
  std::set<std::string> names;
  for (const ModelBox& box : model.boxes)
    for (const std::string_view name : {box.side, box.front})
      if (!name.empty()) names.emplace(name);
  return {names.begin(), names.end()};
}

std::vector<std::string> contentTextureNames() {
  std::set<std::string> names = {"item_sprite",    "flame_particle", "smoke_particle",
                                 "spark_particle", "glyph", "rain",           "snow_flakes",
                                 "beacon_beam",    "glint",          "world_border"};
  for (int stage = 0; stage < 10; ++stage) names.insert(crackTexture(stage));
  for (const EntityModel& model : kModels)
    for (const std::string& name : texturesOf(model)) names.insert(name);
  return {names.begin(), names.end()};
}

std::string crackTexture(int stage) { return "crack_" + std::to_string(stage); }

}  // namespace orris
