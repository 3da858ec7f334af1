#include <orris/world/items/item_tints.h>

#include <array>
#include <string_view>

#include <orris/world/resources/biome_tint.h>

namespace orris {
namespace {

constexpr glm::u8vec3 kWhite(255);

glm::u8vec3 colorOf(std::int64_t rgb) {
  return {std::uint8_t(rgb >> 16), std::uint8_t(rgb >> 8), std::uint8_t(rgb)};
}

/// A number 0xAARRGGBB with or without sign, or three parts from 0 to 1.
glm::u8vec3 parseColor(const JsonNode& node, const std::string& what, JsonReader& reader) {
  if (node.kind == JsonNode::Kind::Integer) return colorOf(node.integer);
  if (node.kind != JsonNode::Kind::Array) {
    reader.expected(node, what, "a number 0xRRGGBB or three numbers from 0 to 1");
    return kWhite;
  }
  const auto parts = reader.vector(node, what, RealRange{0, 1});
  return parts ? glm::u8vec3(glm::round(*parts * 255.0)) : kWhite;
}

struct NamedTint {
  const char* item;
  int index;  ///< those of 0 take a dye
  std::int64_t rgb;
};
constexpr std::int64_t kLeather = 0xA06540, kWaterBottle = 0x385DC6;
constexpr std::array<NamedTint, 11> kNamedTints = {{
    {"minecraft:leather_helmet", 0, kLeather},
    {"minecraft:leather_chestplate", 0, kLeather},
    {"minecraft:leather_leggings", 0, kLeather},
    {"minecraft:leather_boots", 0, kLeather},
    {"minecraft:leather_horse_armor", 0, kLeather},
    {"minecraft:potion", 0, kWaterBottle},
    {"minecraft:splash_potion", 0, kWaterBottle},
    {"minecraft:lingering_potion", 0, kWaterBottle},
    {"minecraft:tipped_arrow", 0, kWaterBottle},
    {"minecraft:firework_star", 1, 0x8A8A8A},
    {"minecraft:filled_map", 1, 0x46402E},
}};

}  // namespace

ItemTint parseItemTint(const JsonNode& node, JsonReader& reader) {
  const JsonNode* type = node.find("type");
  if (!type) {
    reader.expected(node, "an entry of \"tints\"", "an object with \"type\"");
    return {};
  }
  constexpr std::string_view kGame = "minecraft:";
  std::string name = reader.string(*type, "\"type\"").value_or("");
  if (name.starts_with(kGame)) name.erase(0, kGame.size());
  if (name == "grass") return {plainsTint(Tint::Grass)};
  ItemTint tint{kWhite, name == "dye" || name == "potion"};
  for (const char* key : {"value", "default"}) {
    const JsonNode* color = node.find(key);
    if (!color) continue;
    tint.color = parseColor(*color, "\"" + std::string(key) + "\"", reader);
    break;
  }
  return tint;
}

ItemTint itemTintByName(const std::string& item, const BlockFacts& facts, int index) {
  for (const NamedTint& tint : kNamedTints)
    if (item == tint.item && index == tint.index) return {colorOf(tint.rgb), tint.index == 0};
  constexpr float kTemperature = 0.8f, kRainfall = 0.4f;
  return {modelTint({item, {}}, facts, index,
                    biomeTint("minecraft:plains", kTemperature, kRainfall, ColorMaps{}))};
}

}  // namespace orris
