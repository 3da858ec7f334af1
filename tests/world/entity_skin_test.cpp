// Where the game's textures of entities have the sides of our boxes.
#include <orris/world/content/entity_models.h>

#include <gmock/gmock.h>

#include <orris/world/blocks/block_facts.h>
#include <orris/world/content/armour.h>

namespace orris {
namespace {

using ::testing::ElementsAre;

/// Top left, bottom left, bottom right, top right, as the side is seen.
std::vector<glm::vec2> uvOf(const ModelBox& box, const BoxSkin& skin, FaceDirection side) {
  const auto uv = skinUv(box, skin, static_cast<int>(side));
  return {uv.begin(), uv.end()};
}

using P = glm::vec2;

TEST(EntitySkin, a_standing_box_has_its_front_beside_its_right_side) {
  const ModelBox head{{-4, 0, -4}, {4, 8, 4}};
  const BoxSkin skin{"skin_player", 0, 0};
  EXPECT_THAT(uvOf(head, skin, FaceDirection::South), ElementsAre(P(8, 8), P(8, 16), P(16, 16), P(16, 8)));
  EXPECT_THAT(uvOf(head, skin, FaceDirection::West), ElementsAre(P(0, 8), P(0, 16), P(8, 16), P(8, 8)));
  EXPECT_THAT(uvOf(head, skin, FaceDirection::East),
              ElementsAre(P(16, 8), P(16, 16), P(24, 16), P(24, 8)));
  EXPECT_THAT(uvOf(head, skin, FaceDirection::North),
              ElementsAre(P(24, 8), P(24, 16), P(32, 16), P(32, 8)));
  EXPECT_THAT(uvOf(head, skin, FaceDirection::Up), ElementsAre(P(8, 0), P(8, 8), P(16, 8), P(16, 0)));
  // The game has the bottom as if seen from above.
  EXPECT_THAT(uvOf(head, skin, FaceDirection::Down),
              ElementsAre(P(16, 8), P(16, 0), P(24, 0), P(24, 8)));
}

TEST(EntitySkin, width_height_and_depth_are_those_of_the_box) {
  const ModelBox body{{-4, 0, -2}, {4, 12, 2}};
  const BoxSkin skin{"skin_player", 16, 16};
  EXPECT_THAT(uvOf(body, skin, FaceDirection::South),
              ElementsAre(P(20, 20), P(20, 32), P(28, 32), P(28, 20)));
  EXPECT_THAT(uvOf(body, skin, FaceDirection::North),
              ElementsAre(P(32, 20), P(32, 32), P(40, 32), P(40, 20)));
  EXPECT_THAT(uvOf(body, skin, FaceDirection::Up),
              ElementsAre(P(20, 16), P(20, 20), P(28, 20), P(28, 16)));
}

TEST(EntitySkin, a_mirrored_box_wears_the_other_side) {
  const ModelBox leg{{-2, -12, -2}, {2, 0, 2}};
  const BoxSkin skin{"skin_stand", 0, 16, BoxFold::Mirrored};
  EXPECT_THAT(uvOf(leg, skin, FaceDirection::East), ElementsAre(P(4, 20), P(4, 32), P(0, 32), P(0, 20)));
  EXPECT_THAT(uvOf(leg, skin, FaceDirection::South), ElementsAre(P(8, 20), P(8, 32), P(4, 32), P(4, 20)));
}

// The game stands a cow's body on its end and tips it over: its top is seen in front, its back above.
TEST(EntitySkin, a_lying_box_was_unwrapped_upright) {
  const ModelBox body{{-6, 0, -9}, {6, 10, 9}};
  const BoxSkin skin{"skin_cow", 18, 4, BoxFold::Lying};
  EXPECT_THAT(uvOf(body, skin, FaceDirection::South),
              ElementsAre(P(28, 4), P(28, 14), P(40, 14), P(40, 4)));
  EXPECT_THAT(uvOf(body, skin, FaceDirection::Up),
              ElementsAre(P(62, 32), P(62, 14), P(50, 14), P(50, 32)));
  EXPECT_THAT(uvOf(body, skin, FaceDirection::Down),
              ElementsAre(P(28, 14), P(28, 32), P(40, 32), P(40, 14)));
  EXPECT_THAT(uvOf(body, skin, FaceDirection::West),
              ElementsAre(P(18, 32), P(28, 32), P(28, 14), P(18, 14)));
  EXPECT_THAT(uvOf(body, skin, FaceDirection::East),
              ElementsAre(P(50, 14), P(40, 14), P(40, 32), P(50, 32)));
}

TEST(EntitySkin, a_sheet_has_the_same_on_both_sides) {
  const ModelBox shaft{{-12, -2, 0}, {4, 2, 0}};
  const BoxSkin skin{"skin_arrow", 0, 0, BoxFold::Standing, {16, 5, 0}};
  EXPECT_THAT(uvOf(shaft, skin, FaceDirection::South), ElementsAre(P(0, 0), P(0, 5), P(16, 5), P(16, 0)));
  EXPECT_THAT(uvOf(shaft, skin, FaceDirection::North), ElementsAre(P(16, 0), P(16, 5), P(0, 5), P(0, 0)));
}

// In a texture of at most 64 rows no side reaches beyond it.
TEST(EntitySkin, every_side_of_every_model_lies_in_its_texture) {
  for (const std::string& kind : entityKinds()) {
    const EntityModel& model = *findEntityModel(kind);
    for (std::size_t i = 0; i < model.skins.size(); ++i) {
      const BoxSkin& skin = model.skins[i];
      const EntityTexture* texture = findEntityTexture(skin.texture);
      ASSERT_NE(texture, nullptr) << kind;
      for (int side = 0; side < 6 && skin.u != BoxSkin::kNone; ++side)
        for (const glm::vec2& uv : skinUv(model.boxes[i], skin, side)) {
          EXPECT_GE(uv.x, 0) << kind << i;
          EXPECT_LE(uv.x, texture->width) << kind << i;
          EXPECT_GE(uv.y, 0) << kind << i;
          EXPECT_LE(uv.y, texture->width) << kind << i;
        }
    }
  }
}

// Of armour textures are half as high.
TEST(EntitySkin, every_side_of_armour_lies_in_its_texture) {
  for (const ArmourPart& part : armourParts())
    for (int side = 0; side < 6 && part.skin.u != BoxSkin::kNone; ++side)
      for (const glm::vec2& uv : skinUv(part.box, part.skin, side)) {
        EXPECT_GE(uv.x, 0);
        EXPECT_LE(uv.x, 64);
        EXPECT_GE(uv.y, 0);
        EXPECT_LE(uv.y, 32);
      }
}

TEST(Armour, names_of_items_say_slot_and_material) {
  const auto skin = [](const char* item) {
    const auto piece = armourPieceOf(item);
    return piece ? std::string(piece->skin) : "";
  };
  EXPECT_EQ(armourPieceOf("minecraft:iron_helmet")->slot, ArmourSlot::Head);
  EXPECT_EQ(armourPieceOf("golden_boots")->slot, ArmourSlot::Feet);
  EXPECT_EQ(skin("minecraft:golden_boots"), "armour_gold");
  EXPECT_EQ(skin("minecraft:diamond_leggings"), "leggings_diamond");
  EXPECT_EQ(skin("minecraft:turtle_helmet"), "armour_turtle");
  EXPECT_EQ(skin("mod:mithril_chestplate"), "armour_iron") << "unknown";
  EXPECT_TRUE(armourPieceOf("leather_boots")->takesDye);
  EXPECT_EQ(skin("minecraft:iron_horse_armor"), "");
  EXPECT_EQ(skin("minecraft:stone"), "");
}

// So that any of them has a texture.
TEST(Armour, every_material_names_a_texture) {
  for (const char* material : {"leather", "chainmail", "iron", "golden", "diamond", "netherite", "copper", "turtle", "x"})
    for (const char* slot : {"helmet", "chestplate", "leggings", "boots"}) {
      const auto piece = armourPieceOf(std::string(material) + "_" + slot);
      ASSERT_TRUE(piece) << material;
      EXPECT_NE(findEntityTexture(piece->skin), nullptr) << material << slot;
    }
}

}  // namespace
}  // namespace orris
