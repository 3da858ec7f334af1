#include <orris/world/content/armour.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace orris {
namespace {

using L = ModelLayer;
using S = ArmourSlot;

// Sizes that were unwrapped: of what is worn on.
constexpr glm::ivec3 kLimbUnder(4, 12, 4), kChestUnder(8, 12, 4), kHeadUnder(8, 8, 8);
constexpr BoxSkin kOursAlone{};  // not there where the texture is

// Ours first; then the game's: its boxes grown by 1, leggings by half.
constexpr ArmourPart kParts[] = {
    {S::Head, {{-4.6f, -0.6f, -4.6f}, {4.6f, 8.6f, 4.6f}, {0, 24, 0}, "armour_plate", "armour_helmet"}, kOursAlone},
    {S::Chest, {{-4.6f, 0, -2.6f}, {4.6f, 12.5f, 2.6f}, {0, 12, 0}, "armour_plate", {}}, kOursAlone},
    {S::Chest, {{-2.6f, -5, -2.6f}, {2.6f, 2.6f, 2.6f}, {-6, 22, 0}, "armour_plate", {}, L::Body, {}, -28}, kOursAlone},
    {S::Chest, {{-2.6f, -5, -2.6f}, {2.6f, 2.6f, 2.6f}, {6, 22, 0}, "armour_plate", {}, L::Body, {}, 28}, kOursAlone},
    {S::Legs, {{-4.45f, -0.4f, -2.45f}, {4.45f, 4, 2.45f}, {0, 12, 0}, "armour_plate", {}}, kOursAlone},
    {S::Legs, {{-2.4f, -7, -2.4f}, {2.4f, 0.3f, 2.4f}, {-2, 12, 0}, "armour_plate", {}, L::Body, {}, 32}, kOursAlone},
    {S::Legs, {{-2.4f, -7, -2.4f}, {2.4f, 0.3f, 2.4f}, {2, 12, 0}, "armour_plate", {}, L::Body, {}, -32}, kOursAlone},
    {S::Feet, {{-2.6f, -12.4f, -2.6f}, {2.6f, -7, 2.6f}, {-2, 12, 0}, "armour_plate", {}, L::Body, {}, 32}, kOursAlone},
    {S::Feet, {{-2.6f, -12.4f, -2.6f}, {2.6f, -7, 2.6f}, {2, 12, 0}, "armour_plate", {}, L::Body, {}, -32}, kOursAlone},
    {S::Head, {{-5, -1, -5}, {5, 9, 5}, {0, 24, 0}, {}, {}}, {{}, 0, 0, BoxFold::Standing, kHeadUnder}},
    {S::Chest, {{-5, -1, -3}, {5, 13, 3}, {0, 12, 0}, {}, {}}, {{}, 16, 16, BoxFold::Standing, kChestUnder}},
    {S::Chest, {{-3, -11, -3}, {3, 3, 3}, {-6, 22, 0}, {}, {}, L::Body, {}, -28}, {{}, 40, 16, BoxFold::Standing, kLimbUnder}},
    {S::Chest, {{-3, -11, -3}, {3, 3, 3}, {6, 22, 0}, {}, {}, L::Body, {}, 28}, {{}, 40, 16, BoxFold::Mirrored, kLimbUnder}},
    {S::Legs, {{-4.5f, -0.5f, -2.5f}, {4.5f, 12.5f, 2.5f}, {0, 12, 0}, {}, {}}, {{}, 16, 16, BoxFold::Standing, kChestUnder}},
    {S::Legs, {{-2.5f, -12.5f, -2.5f}, {2.5f, 0.5f, 2.5f}, {-2, 12, 0}, {}, {}, L::Body, {}, 32}, {{}, 0, 16, BoxFold::Standing, kLimbUnder}},
    {S::Legs, {{-2.5f, -12.5f, -2.5f}, {2.5f, 0.5f, 2.5f}, {2, 12, 0}, {}, {}, L::Body, {}, -32}, {{}, 0, 16, BoxFold::Mirrored, kLimbUnder}},
    {S::Feet, {{-3, -13, -3}, {3, 1, 3}, {-2, 12, 0}, {}, {}, L::Body, {}, 32}, {{}, 0, 16, BoxFold::Standing, kLimbUnder}},
    {S::Feet, {{-3, -13, -3}, {3, 1, 3}, {2, 12, 0}, {}, {}, L::Body, {}, -32}, {{}, 0, 16, BoxFold::Mirrored, kLimbUnder}}};

struct SlotEnding {
  std::string_view ending;
  ArmourSlot slot;
};
constexpr SlotEnding kEndings[] = {
    {"_helmet", S::Head}, {"_chestplate", S::Chest}, {"_leggings", S::Legs}, {"_boots", S::Feet}};

struct Material {
  std::string_view item;  ///< how names of items begin
  std::string_view skin, leggings;
  glm::vec3 color;
};
constexpr glm::vec3 kUndyed(0.627f, 0.396f, 0.251f);
// The first is what all others look like.
constexpr Material kArmourMaterials[] = {{"iron", "armour_iron", "leggings_iron", {1, 1, 1}},
                                   {"leather", "armour_leather", "leggings_leather", kUndyed},
                                   {"chainmail", "armour_chainmail", "leggings_chainmail", {0.6f, 0.6f, 0.65f}},
                                   {"copper", "armour_copper", "leggings_copper", {0.85f, 0.5f, 0.35f}},
                                   {"golden", "armour_gold", "leggings_gold", {1, 0.85f, 0.3f}},
                                   {"diamond", "armour_diamond", "leggings_diamond", {0.4f, 0.95f, 0.9f}},
                                   {"netherite", "armour_netherite", "leggings_netherite", {0.35f, 0.3f, 0.33f}},
                                   {"turtle", "armour_turtle", "leggings_iron", {0.35f, 0.75f, 0.35f}}};

}  // namespace

std::optional<ArmourPiece> armourPieceOf(std::string_view item) {
  item.remove_prefix(item.find(':') + 1);  // npos + 1 is 0
  const auto* const end = std::ranges::find_if(kEndings, [&](const SlotEnding& e) { return item.ends_with(e.ending); });
  if (end == std::end(kEndings)) return std::nullopt;
  item.remove_suffix(end->ending.size());
  const auto* known = std::ranges::find(kArmourMaterials, item, &Material::item);
  const Material& material = known == std::end(kArmourMaterials) ? kArmourMaterials[0] : *known;
  ArmourPiece piece{end->slot, end->slot == S::Legs ? material.leggings : material.skin, material.color};
  piece.takesDye = material.item == "leather";
  if (piece.takesDye) piece.skinColor = kUndyed;
  return piece;
}

std::vector<WornPiece> wornBy(const Entity& entity) {
  const EntityModel* model = findEntityModel(entity.model);
  std::vector<WornPiece> worn;
  if (model == nullptr || !model->wearsArmour) return worn;
  for (const std::string& item : entity.armour)
    if (const auto piece = armourPieceOf(item)) worn.push_back({item, *piece});
  return worn;
}

std::span<const ArmourPart> armourParts() { return kParts; }

}  // namespace orris
