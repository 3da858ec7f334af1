#include <gmock/gmock.h>
#include <orris/world/blocks/block_facts.h>
#include <orris/world/content/entity_models.h>
#include <orris/world/saved_things/entity_figures.h>
#include <orris/world/saved_things/saved_text.h>
#include <orris/world/saved_things/saved_things.h>

#include <limits>

#include "region_builder.h"

namespace orris {
namespace {

using Doubles = std::vector<double>;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

NbtTag tagOf(const std::string& members) {
  NbtError error;
  const auto root = parseNbt(nbtCompound("", members), error);
  EXPECT_TRUE(root) << error.message;
  return root.value_or(NbtTag{});
}

SavedThings thingsOf(const std::string& members) {
  SavedThings things;
  readEntities({tagOf(members)}, things);
  return things;
}

/// The one entity that `members` are, with a kind and a place.
Entity entityOf(const std::string& id, const std::string& members,
                const Doubles& place = {2.5, 3.5, 4.5}) {
  const SavedThings things = thingsOf(nbtString("id", id) + nbtDoubles("Pos", place) + members);
  EXPECT_EQ(things.entities.size(), 1u);
  return things.entities.empty() ? Entity{} : things.entities[0];
}

void expectNear(const glm::dvec3& a, const glm::dvec3& b) {
  EXPECT_LT(glm::distance(a, b), 1e-5) << a.x << " " << a.y << " " << a.z;
}

TEST(EntityFigures, each_is_a_model_that_is_there) {
  for (const char* kind : {"armor_stand", "arrow", "cow", "item", "item_frame", "player", "slime",
                           "spider", "pig", "zombie", "glow_item_frame", "magma_cube"}) {
    const EntityFigure* figure = findFigure("minecraft:" + std::string(kind));
    ASSERT_TRUE(figure) << kind;
    EXPECT_TRUE(findEntityModel(figure->model)) << kind;
  }
  EXPECT_FALSE(findFigure("minecraft:bat"));
  EXPECT_FALSE(findFigure("mod:cow")) << "a mod's cow may look like anything";
  EXPECT_TRUE(isUnseenKind("minecraft:marker"));
}

TEST(EntityFigures, names_of_old_games_become_those_of_today) {
  EXPECT_EQ(currentKind("Cow"), "minecraft:cow");
  EXPECT_EQ(currentKind("MushroomCow"), "minecraft:mooshroom");
  EXPECT_EQ(currentKind("PigZombie"), "minecraft:zombified_piglin");
  EXPECT_EQ(currentKind("minecraft:zombie_pigman"), "minecraft:zombified_piglin");
  EXPECT_EQ(currentKind("ItemFrame"), "minecraft:item_frame");
  EXPECT_EQ(currentKind("mod:thing"), "mod:thing");
  EXPECT_EQ(currentKind(""), "");
  EXPECT_EQ(currentKind("a b"), "");
  EXPECT_EQ(currentKind(std::string(1000, 'a')), "");
}

TEST(SavedEntities, keep_their_kind_and_take_a_model_and_its_size) {
  const Entity pig = entityOf("minecraft:pig", nbtFloats("Rotation", {350, 40}));
  EXPECT_EQ(pig.kind, "minecraft:pig");
  EXPECT_EQ(pig.model, "cow");
  EXPECT_EQ(pig.scale, 0.65f);
  EXPECT_EQ(pig.yaw, -10);
  EXPECT_EQ(pig.pitch, 0) << "it is the head that looks down";
  EXPECT_EQ(entityOf("minecraft:cow", nbtInt("Age", -100)).scale, 0.5f);
  EXPECT_EQ(entityOf("minecraft:zombie", nbtByte("IsBaby", 1)).scale, 0.5f);
  // Half a block wide for each size; our figure has three quarters of a block.
  EXPECT_FLOAT_EQ(entityOf("minecraft:slime", nbtInt("Size", 2)).scale, 2);
  EXPECT_FLOAT_EQ(entityOf("minecraft:slime", nbtInt("Size", 2000000000)).scale, 127 / 1.5f);
}

TEST(SavedEntities, name_tag_hurt_and_leash) {
  const std::string name = nbtString("CustomName", R"({"text":"Bessy"})");
  EXPECT_EQ(entityOf("Cow", name).tag, "") << "only where the game shows it";
  EXPECT_EQ(entityOf("Cow", name + nbtByte("CustomNameVisible", 1)).tag, "Bessy");
  EXPECT_TRUE(entityOf("Cow", nbtShort("HurtTime", 3)).hurt);
  const auto tied =
      entityOf("Cow", nbtCompound("Leash", nbtInt("X", 1) + nbtInt("Y", 2) + nbtInt("Z", 3)));
  EXPECT_EQ(tied.leash, glm::dvec3(1.5, 2.5, 3.5));
  const std::string knot = bigEndian(3, 4) + bigEndian(1, 4) + bigEndian(2, 4) + bigEndian(3, 4);
  EXPECT_EQ(entityOf("Cow", nbtTag(11, "leash", knot)).leash, glm::dvec3(1.5, 2.5, 3.5));
  EXPECT_FALSE(entityOf("Cow", nbtCompound("Leash", nbtInt("UUIDMost", 1))).leash);
}

TEST(SavedEntities, frames_hang_on_walls_floors_and_ceilings) {
  const std::string item =
      nbtCompound("Item", nbtString("id", "minecraft:stone")) + nbtByte("ItemRotation", 3);
  // Where the game has them: a thirty-second of a block off the side.
  const Entity wall =
      entityOf("minecraft:item_frame", item + nbtFloats("Rotation", {180, 0}), {2.5, 3.5, 4.96875});
  EXPECT_EQ(wall.item, "minecraft:stone");
  EXPECT_EQ(wall.itemTurn, 135);
  expectNear(wall.position, {2.5, 3.5, 5});
  const Entity floor =
      entityOf("minecraft:glow_item_frame", nbtFloats("Rotation", {0, -90}), {2.5, 3.03125, 4.5});
  EXPECT_EQ(floor.kind, "minecraft:glow_item_frame");
  EXPECT_EQ(floor.pitch, -90);
  expectNear(floor.position, {2.5, 3, 4.5});
  const Entity ceiling =
      entityOf("minecraft:item_frame", nbtByte("Invisible", 1) + nbtFloats("Rotation", {0, 90}),
               {2.5, 3.96875, 4.5});
  EXPECT_TRUE(ceiling.hidden);
  expectNear(ceiling.position, {2.5, 4, 4.5});
}

TEST(SavedEntities, arrows_turn_the_other_way_round) {
  const Entity arrow = entityOf("minecraft:arrow", nbtFloats("Rotation", {90, 30}));
  EXPECT_EQ(arrow.yaw, -90);
  EXPECT_EQ(arrow.pitch, -30);
}

TEST(SavedEntities, figures_show_what_they_wear) {
  const auto piece = [](const std::string& id, const std::string& more = "") {
    return closed(nbtString("id", id) + more);
  };
  const auto stand = [](const std::string& more) {
    return entityOf("minecraft:armor_stand", more);
  };
  EXPECT_THAT(stand("").armour, IsEmpty());
  EXPECT_THAT(stand(nbtList("ArmorItems", 10, {piece("minecraft:golden_boots"), closed(""), piece("minecraft:stone"),
                                               piece("minecraft:iron_helmet")}))
                  .armour,
              ElementsAre("minecraft:golden_boots", "minecraft:iron_helmet"));
  EXPECT_THAT(stand(nbtCompound("equipment", nbtCompound("chest", nbtString("id", "minecraft:iron_chestplate")) +
                                                 nbtCompound("mainhand", nbtString("id", "minecraft:iron_boots"))))
                  .armour,
              ElementsAre("minecraft:iron_chestplate"));
  EXPECT_THAT(entityOf("minecraft:zombie", nbtList("ArmorItems", 10, {piece("minecraft:iron_leggings")})).armour,
              ElementsAre("minecraft:iron_leggings"));
  EXPECT_THAT(entityOf("minecraft:cow", nbtList("ArmorItems", 10, {piece("minecraft:iron_leggings")})).armour, IsEmpty());
  EXPECT_EQ(stand(nbtList("ArmorItems", 10, std::vector<std::string>(9, piece("minecraft:iron_boots")))).armour.size(), 4u);
  const std::string charm = nbtCompound("tag", nbtList("Enchantments", 10, {closed("")}));
  const Entity charmed = stand(nbtList("ArmorItems", 10, {piece("minecraft:iron_helmet", charm)}) +
                               nbtByte("Invisible", 1) + nbtByte("Small", 1));
  EXPECT_TRUE(charmed.glint);
  EXPECT_TRUE(charmed.hidden);
  EXPECT_EQ(charmed.scale, 0.5f);
}

TEST(SavedEntities, items_of_old_and_new_games) {
  const auto dropped = [](const std::string& item) {
    return entityOf("minecraft:item", nbtCompound("Item", item) + nbtShort("Age", -32768));
  };
  EXPECT_EQ(dropped(nbtString("id", "minecraft:iron_sword")).item, "minecraft:iron_sword");
  EXPECT_EQ(dropped(nbtShort("id", 1)).item, "minecraft:stone");
  EXPECT_EQ(dropped(nbtString("id", "minecraft:air")).item, "");
  EXPECT_EQ(dropped(nbtString("id", "../../x y")).item, "");
  EXPECT_EQ(dropped(nbtString("id", "stone")).scale, 1) << "an item's age is another";
  EXPECT_FALSE(dropped(nbtString("id", "stone")).glint);
  const std::string levels = nbtCompound("levels", nbtInt("minecraft:power", 1));
  EXPECT_TRUE(dropped(nbtString("id", "bow") +
                      nbtCompound("components", nbtCompound("minecraft:enchantments", levels)))
                  .glint);
  EXPECT_FALSE(dropped(nbtString("id", "bow") +
                       nbtCompound("components", nbtCompound("minecraft:enchantments",
                                                             nbtCompound("levels", ""))))
                   .glint);
}

TEST(SavedEntities, figures_hold_what_the_save_gives_them) {
  const std::string bow = nbtString("id", "minecraft:bow"), torch = nbtString("id", "minecraft:torch");
  const Entity before = entityOf("minecraft:skeleton", nbtList("HandItems", 10, {closed(bow), closed(torch)}));
  EXPECT_EQ(before.mainHand, "minecraft:bow");
  EXPECT_EQ(before.offHand, "minecraft:torch");
  EXPECT_FALSE(before.glint);
  const Entity now = entityOf("minecraft:skeleton",
                              nbtCompound("equipment", nbtCompound("offhand", torch) + nbtCompound("mainhand", bow)));
  EXPECT_EQ(now.mainHand, "minecraft:bow");
  EXPECT_EQ(now.offHand, "minecraft:torch");
  const std::string charm = nbtCompound("tag", nbtList("Enchantments", 10, {closed("")}));
  const Entity charmed = entityOf("minecraft:zombie", nbtList("HandItems", 10, {closed(bow + charm)}));
  EXPECT_TRUE(charmed.glint);
  EXPECT_EQ(charmed.offHand, "");
  EXPECT_EQ(entityOf("minecraft:zombie", nbtList("Equipment", 10, {closed(bow)})).mainHand, "minecraft:bow");
  EXPECT_EQ(entityOf("minecraft:cow", nbtList("HandItems", 10, {closed(bow)})).mainHand, "");
}

TEST(SavedEntities, dyes_of_old_and_new_games) {
  const auto dye = [](const std::string& more) {
    return entityOf("minecraft:item", nbtCompound("Item", nbtString("id", "minecraft:leather_boots") + more)).dye;
  };
  const glm::vec3 red(1, 0, 51 / 255.0f);
  constexpr int kRed = 0xff0033;
  EXPECT_FALSE(dye(""));
  EXPECT_EQ(dye(nbtCompound("tag", nbtCompound("display", nbtInt("color", kRed)))), red);
  EXPECT_EQ(dye(nbtCompound("tag", nbtInt("CustomPotionColor", kRed))), red);
  EXPECT_EQ(dye(nbtCompound("components", nbtInt("minecraft:dyed_color", kRed))), red);
  EXPECT_EQ(dye(nbtCompound("components", nbtCompound("minecraft:dyed_color", nbtInt("rgb", kRed)))), red);
  EXPECT_EQ(dye(nbtCompound("components", nbtCompound("minecraft:potion_contents", nbtInt("custom_color", kRed)))), red);
  EXPECT_FALSE(dye(nbtCompound("components", nbtString("minecraft:dyed_color", "red"))));
}

TEST(SavedEntities, riders_are_read_and_damaged_ones_counted) {
  const std::string rider =
      closed(nbtString("id", "minecraft:zombie") + nbtDoubles("Pos", {1, 2, 3}));
  const SavedThings things =
      thingsOf(nbtString("id", "minecraft:boat") + nbtDoubles("Pos", {1, 2, 3}) +
               nbtList("Passengers", 10, {rider}));
  ASSERT_EQ(things.entities.size(), 1u);
  EXPECT_EQ(things.entities[0].kind, "minecraft:zombie");
  EXPECT_EQ(things.figureless.at("minecraft:boat"), 1u);
  const double inf = std::numeric_limits<double>::infinity();
  for (const std::string& pos : {std::string(), nbtDoubles("Pos", {1, 2}),
                                 nbtDoubles("Pos", {1, inf, 2}), nbtString("Pos", "1 2 3")})
    EXPECT_EQ(thingsOf(nbtString("id", "minecraft:cow") + pos).damaged, 1u);
  EXPECT_EQ(thingsOf(nbtInt("id", 3) + nbtDoubles("Pos", {1, 2, 3})).damaged, 1u);
  const Entity still = entityOf(
      "minecraft:cow", nbtFloats("Rotation", {std::numeric_limits<float>::quiet_NaN(), 0}));
  EXPECT_EQ(still.yaw, 0);
}

TEST(SavedText, plain_json_and_tags_become_glyphs) {
  const auto drawn = [](const std::string& member) { return drawnText(*tagOf(member).find("t")); };
  EXPECT_EQ(drawn(nbtString("t", "Plain text ")), "Plain text");
  EXPECT_EQ(drawn(nbtString("t", R"("In quotes")")), "In quotes");
  EXPECT_EQ(drawn(nbtString("t", R"({"text":"A","extra":[{"text":"B","color":"red"},"C"]})")),
            "ABC");
  EXPECT_EQ(drawn(nbtString("t", R"({"text":"cut)")), R"({"text":"cut)");
  EXPECT_EQ(drawn(nbtCompound(
                "t", nbtString("text", "A") + nbtList("extra", 10, {closed(nbtString("", "B"))}))),
            "AB");
  EXPECT_EQ(drawn(nbtString("t",
                            "\xc2\xa7"
                            "cRed")),
            "Red");
  EXPECT_EQ(drawn(nbtString("t", "caf\xc3\xa9 1\n2")), "caf  1 2");
  EXPECT_EQ(drawn(nbtString("t", std::string(1000, 'A'))), std::string(64, 'A'));
  EXPECT_EQ(drawn(nbtInt("t", 3)), "");
}

SavedThings signsOf(const std::string& members) {
  SavedThings things;
  readSigns({tagOf(nbtInt("x", 10) + nbtInt("y", 20) + nbtInt("z", 30) + members)}, things);
  return things;
}

std::string side(const std::string& name, const std::string& line, const std::string& more = "") {
  const auto text = [](const std::string& t) { return bigEndian(t.size(), 2) + t; };
  return nbtCompound(name, nbtList("messages", 8, {text("\"\""), text(line)}) + more);
}

TEST(SavedSigns, texts_of_both_sides_and_of_games_before) {
  SavedThings things = signsOf(
      side("front_text", "\"A\"", nbtString("color", "red")) +
      side("back_text", "\"B\"", nbtString("color", "red") + nbtByte("has_glowing_text", 1)));
  ASSERT_EQ(things.signs.size(), 1u);
  EXPECT_EQ(things.signs[0].at, glm::ivec3(10, 20, 30));
  EXPECT_EQ(things.signs[0].front.lines[1], "A");
  EXPECT_EQ(things.signs[0].back.lines[1], "B");
  EXPECT_EQ(things.signs[0].front.color, glm::vec3(0.4f, 0, 0));
  EXPECT_EQ(things.signs[0].back.color, glm::vec3(1, 0, 0)) << "it glows";
  things = signsOf(nbtString("Text1", "{\"text\":\"OLD\"}"));
  ASSERT_EQ(things.signs.size(), 1u);
  EXPECT_EQ(things.signs[0].front.lines[0], "OLD");
  EXPECT_TRUE(signsOf(nbtString("Text1", "\"\"")).signs.empty()) << "nothing is written on it";
  things = {};
  readSigns({tagOf(nbtInt("x", 2000000000) + nbtString("Text1", "A"))}, things);
  EXPECT_TRUE(things.signs.empty());
  EXPECT_EQ(things.damaged, 1u);
}

/// How far the text is in front of the board of the block, along where the text looks to.
TEST(SavedSigns, texts_lie_just_before_the_board_that_is_drawn) {
  const BlockTable table;
  SavedSign sign;
  sign.front.lines = {"ONE", "", "", "FOUR"};
  sign.back.lines[0] = "BACK";
  for (const char* name :
       {"minecraft:oak_sign[rotation=1]", "minecraft:oak_sign[rotation=4]",
        "minecraft:oak_sign[rotation=14]", "minecraft:oak_wall_sign[facing=west]",
        "minecraft:oak_wall_sign[facing=north]", "minecraft:oak_hanging_sign[rotation=8]",
        "minecraft:oak_wall_hanging_sign[facing=south]"}) {
    const BlockState state = *parseBlockState(name);
    const std::vector<BlockText> texts = textsOf(sign, state);
    ASSERT_EQ(texts.size(), 3u) << name;
    // The board is the widest box.
    const std::vector<ShapeBox> boxes = table.factsOf(state).boxes;
    ASSERT_FALSE(boxes.empty()) << name;
    const ShapeBox* board = &boxes[0];
    const auto area = [](const ShapeBox& box) {
      return (box.to - box.from).y * std::max((box.to - box.from).x, (box.to - box.from).z);
    };
    for (const ShapeBox& box : boxes)
      if (area(box) > area(*board)) board = &box;
    for (const BlockText& text : texts) {
      const double turn = glm::radians(double(text.yaw));
      const glm::dvec3 front(-std::sin(turn), 0, std::cos(turn));
      const glm::dvec3 from(board->from / 16.0f), to(board->to / 16.0f);
      const double surface = std::max(glm::dot(from, front), glm::dot(to, front));
      const double before = glm::dot(text.position, front) - surface;
      EXPECT_GT(before, 0.004) << name << " " << text.text;
      EXPECT_LT(before, 0.008) << name << " " << text.text;
      EXPECT_LT(text.position.y + text.size / 2, to.y) << name;
      EXPECT_GT(text.position.y - text.size / 2, from.y) << name;
    }
    EXPECT_GT(texts[0].position.y, texts[1].position.y) << name;
    EXPECT_NEAR(std::abs(texts[0].yaw - texts[2].yaw), 180, 1e-4) << name;
  }
  EXPECT_TRUE(textsOf(sign, {"minecraft:stone", {}}).empty());
}

TEST(SavedSigns, a_long_line_is_made_to_fit) {
  SavedSign sign;
  sign.front.lines[0] = std::string(40, 'A');
  const std::vector<BlockText> texts = textsOf(sign, {"minecraft:oak_sign", {{"rotation", "0"}}});
  ASSERT_EQ(texts.size(), 1u);
  EXPECT_LE(texts[0].size * kGlyphAdvance * 40, 0.941);
  EXPECT_GT(texts[0].size, 0.01);
}

}  // namespace
}  // namespace orris
