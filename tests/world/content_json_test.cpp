// Entities and the rest besides blocks in world.json: values, and messages with their place.
#include <gmock/gmock.h>

#include <orris/core/limits.h>
#include <orris/world/content/entity_models.h>
#include "world_helpers.h"

namespace orris {
namespace {

WorldContent contentOf(const std::string& members) {
  const ParsedWorld parsed = parseWorld("{\"size\": [4, 4, 4],\n" + members + "}");
  EXPECT_TRUE(parsed.world) << parsed.errors;
  return parsed.world ? parsed.world->content : WorldContent();
}

/// The first message and its place, of members on the second line.
std::string contentError(const std::string& members) {
  const ParsedWorld parsed = parseWorld("{\"size\": [4, 4, 4],\n" + members + "}");
  EXPECT_FALSE(parsed.world);
  return parsed.errors.substr(0, parsed.errors.find('\n'));
}

TEST(ContentJson, an_entity_has_what_its_object_says) {
  const WorldContent content = contentOf(
      R"("entities": [{"kind": "cow", "name": "bess", "position": [1, 2, 3.5], "yaw": 90,
          "walking": true, "hurt": true, "glint": true, "leash": [0, 1, 0]},
          {"kind": "minecraft:item", "position": [0, 0, 0], "item": "torch"}])");
  ASSERT_EQ(content.entities.size(), 2u);
  const Entity& cow = content.entities[0];
  EXPECT_EQ(cow.kind, "minecraft:cow");
  EXPECT_EQ(cow.name, "bess");
  EXPECT_EQ(cow.position, glm::dvec3(1, 2, 3.5));
  EXPECT_EQ(cow.yaw, 90);
  EXPECT_TRUE(cow.walking && cow.hurt && cow.glint);
  EXPECT_EQ(cow.leash, glm::dvec3(0, 1, 0));
  EXPECT_EQ(content.entities[1].item, "minecraft:torch");
}

TEST(ContentJson, the_rest_has_what_its_objects_say) {
  const WorldContent content = contentOf(
      R"("particles": [{"kind": "spark", "position": [1, 1, 1], "count": 3}],
         "beams": [{"at": [1, 0, 1], "color": [1, 0, 0]}], "damaged": [{"at": [2, 0, 2], "stage": 9}],
         "texts": [{"text": "A1", "at": [0, 0, 0], "position": [0.5, 0.5, 1]}],
         "selected": [3, 3, 3], "border": {"min": [-1, -1], "max": [5, 5]})");
  ASSERT_EQ(content.particles.size(), 1u);
  EXPECT_EQ(content.particles[0].kind, ParticleKind::Spark);
  EXPECT_EQ(content.particles[0].count, 3);
  ASSERT_EQ(content.beams.size(), 1u);
  EXPECT_EQ(content.beams[0].color, glm::vec3(1, 0, 0));
  ASSERT_EQ(content.damaged.size(), 1u);
  EXPECT_EQ(content.damaged[0].stage, 9);
  ASSERT_EQ(content.texts.size(), 1u);
  EXPECT_EQ(content.texts[0].text, "A1");
  EXPECT_EQ(content.selected, glm::ivec3(3));
  ASSERT_TRUE(content.border);
  EXPECT_EQ(content.border->high, glm::dvec2(5));
}

TEST(ContentJson, a_hand_shows_unless_the_world_hides_it) {
  const auto hideGui = [](const std::string& player) {
    const ParsedWorld parsed =
        parseWorld("{\"size\": [1, 1, 1], \"environment\": {\"player\": {" + player + "}}}");
    EXPECT_TRUE(parsed.world) << parsed.errors;
    return parsed.world->environment.player.hideGui;
  };
  EXPECT_TRUE(hideGui(""));
  EXPECT_FALSE(hideGui("\"mainHand\": \"torch\""));
  EXPECT_FALSE(hideGui("\"offHand\": \"air\""));
  EXPECT_TRUE(hideGui("\"mainHand\": \"torch\", \"hideGui\": true"));
}

TEST(ContentJson, figures_wear_the_armour_that_is_named_and_stands_some_of_iron) {
  const auto armourOf = [](const std::string& members) {
    const ParsedWorld parsed =
        parseWorld("{\"size\": [1, 1, 1], \"entities\": [{\"position\": [0, 0, 0], " + members + "}]}");
    EXPECT_TRUE(parsed.world) << parsed.errors;
    return parsed.world->content.entities.at(0).armour;
  };
  EXPECT_THAT(armourOf(R"("kind": "player")"), testing::IsEmpty());
  EXPECT_THAT(armourOf(R"("kind": "player", "armour": ["iron_boots", "mod:tin_helmet"])"),
              testing::ElementsAre("minecraft:iron_boots", "mod:tin_helmet"));
  EXPECT_THAT(armourOf(R"("kind": "armor_stand")"), testing::SizeIs(2));
  EXPECT_THAT(armourOf(R"("kind": "armor_stand", "armour": [])"), testing::IsEmpty());
}

TEST(ContentJson, mistakes_are_reported_at_their_place) {
  const std::pair<std::string, std::string> rows[] = {
      {R"("entities": [{"kind": "cat", "position": [0, 0, 0]}])",
       "world.json:2:23: error: no entity \"cat\": expected one of armor_stand, arrow, cow, item, "
       "item_frame, player, slime, spider"},
      {R"("entities": [{"position": [0, 0, 0]}])",
       "world.json:2:14: error: an entity has no \"kind\""},
      {R"("entities": [{"kind": "player", "position": [0, 0, 0], "armour": ["iron_horse_armor"]}])",
       "world.json:2:67: error: a piece of \"armour\" is \"iron_horse_armor\": expected an item whose name ends in _helmet, "
       "_chestplate, _leggings or _boots"},
      {R"("entities": [{"kind": "cow", "position": [0, 0, 0], "armour": ["iron_boots"]}])",
       "world.json:2:63: error: cow wears no armour: only armor_stand and player do"},
      {R"("particles": [{"kind": "snow", "position": [0, 0, 0]}])",
       "world.json:2:24: error: \"kind\" is \"snow\": expected flame, smoke or spark"},
      {R"("particles": [{"kind": "smoke", "position": [0, 0, 0], "count": 0}])",
       "world.json:2:65: error: \"count\" is 0: expected an integer from 1 to 1000"},
      {R"("beams": [{"at": [9, 0, 0]}])", "world.json:2:18: error: \"at\" is outside the world"},
      {R"("damaged": [{"at": [0, 0, 0], "stage": 10}])",
       "world.json:2:40: error: \"stage\" is 10: expected an integer from 0 to 9"},
      {R"("selected": [4, 0, 0])", "world.json:2:13: error: \"selected\" is outside the world"},
      {R"("border": {"min": [5, 5], "max": [5, 9]})",
       "world.json:2:11: error: \"border\" is empty: expected \"min\" below \"max\""},
      {R"("border": {"min": 3, "max": [5, 9]})",
       "world.json:2:19: error: \"min\" is 3: expected [x, z]"},
      {R"("events": [{"frame": 0, "entity": {"name": "bess"}}])",
       "world.json:2:44: error: no entity is named \"bess\""},
      {R"("events": [{"frame": 0, "lightning": {"frames": 3}}])",
       "world.json:2:38: error: \"lightning\" has no \"at\""}};
  for (const auto& [members, message] : rows) EXPECT_EQ(contentError(members), message);
}

TEST(ContentJson, lists_and_texts_are_bounded) {
  std::string sources;
  for (std::size_t i = 0; i <= limits::kWorldThings; ++i)
    sources += std::string(i == 0 ? "" : ",") + R"({"kind":"smoke","position":[0,0,0]})";
  EXPECT_NE(contentError("\"particles\": [" + sources + "]").find("more than 1000 particles"),
            std::string::npos);
  const std::string text(limits::kWorldTextGlyphs + 1, 'A');
  EXPECT_NE(contentError("\"texts\": [{\"text\": \"" + text +
                         R"(", "at": [0, 0, 0], "position": [0, 0, 0]}])")
                .find("a text of 65 glyphs: expected at most 64"),
            std::string::npos);
}

TEST(EntityModels, each_kind_has_boxes_or_shows_an_item) {
  for (const std::string& kind : entityKinds()) {
    const EntityModel* model = findEntityModel("minecraft:" + kind);
    ASSERT_NE(model, nullptr) << kind;
    EXPECT_TRUE(!model->boxes.empty() || model->carriesItem) << kind;
    ASSERT_TRUE(model->skins.empty() || model->skins.size() == model->boxes.size()) << kind;
    for (std::size_t i = 0; i < model->boxes.size(); ++i) {
      const ModelBox& box = model->boxes[i];
      const bool own = !box.side.empty() || !box.front.empty();
      if (own) {
        EXPECT_TRUE(glm::all(glm::lessThan(box.from, box.to))) << kind;
      } else {
        ASSERT_FALSE(model->skins.empty()) << kind << ": a box without any texture";
        EXPECT_NE(model->skins[i].u, BoxSkin::kNone) << kind << ": a box without any texture";
      }
    }
  }
  EXPECT_EQ(findEntityModel("minecraft:cat"), nullptr);
}

}  // namespace
}  // namespace orris
