// Items drawn with resource packs that these tests make.
#include <orris/world/items/item_looks.h>

#include <gmock/gmock.h>

#include "resource_helpers.h"

namespace orris {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

struct ItemTest {
  TestPack pack{};
  BlockAtlas atlas{};
  std::string errors{};

  void item(const std::string& name, const std::string& json) {
    pack.files["/minecraft/models/item/" + name + ".json"] = json;
  }
  void definition(const std::string& name, const std::string& json) {
    pack.files["/minecraft/items/" + name + ".json"] = json;
  }

  /// nullopt: the item keeps the look of Orris.
  std::optional<ItemLook> look(const std::string& item, int times = 1) {
    Diagnostics diagnostics;
    const ResourceStack resources = pack.stack();
    LookTextures textures(resources, diagnostics);
    BlockFacts facts = BlockTable().factsOf({item, {}});
    if (!facts.known) facts.boxes.clear();
    auto looks = makeItemLooks(resources, {{item, {&facts, times}}}, textures, diagnostics);
    textures.finish(atlas);
    errors = joined(diagnostics);
    const auto found = looks.find(item);
    return found == looks.end() ? std::nullopt : std::optional(found->second);
  }
};

constexpr Texel8 kNothing{0, 0, 0, 0};

TEST(item_looks, a_flat_item_has_front_back_and_the_edges_of_its_texels) {
  ItemTest test;
  test.item("stick", R"({"parent": "item/handheld", "textures": {"layer0": "item/stick"}})");
  // Two texels beside each other in the second row, one below them.
  test.pack.texture("item/stick", pngOf(16, 16, [](int x, int y) {
                      return (y == 1 && (x == 4 || x == 5)) || (y == 2 && x == 4) ? kRed : kNothing;
                    }));
  const auto look = test.look("minecraft:stick");
  EXPECT_EQ(test.errors, "");
  ASSERT_TRUE(look.has_value());
  ASSERT_THAT(*look->faces, SizeIs(2 + 1 + 2 + 1 + 2))
      << "edges in a line are one";
  for (const ModelFace& face : *look->faces) {
    const glm::vec3 down = face.corners[1] - face.corners[0],
                    across = face.corners[3] - face.corners[0];
    EXPECT_GT(glm::dot(glm::cross(down, across), face.normal), 0) << int(face.direction);
    EXPECT_EQ(face.texture, "minecraft:item/stick");
  }
  const ModelFace& up = (*look->faces)[2];
  EXPECT_EQ(up.direction, FaceDirection::Up);
  EXPECT_EQ(up.corners[1], glm::vec3(4 / 16.0f, 15 / 16.0f, 8.5f / 16));
  EXPECT_EQ(up.corners[3], glm::vec3(6 / 16.0f, 15 / 16.0f, 7.5f / 16));
  EXPECT_EQ(up.uv[0], glm::vec2(4, 1) / 16.0f);
  EXPECT_EQ(up.uv[2], glm::vec2(6, 2) / 16.0f);
}

TEST(item_looks, layers_lie_over_each_other_and_large_textures_have_no_edges) {
  ItemTest test;
  test.item("potion", R"({"parent": "item/generated",
    "textures": {"layer0": "item/a", "layer1": "item/b", "layer3": "item/never"}})");
  test.pack.texture("item/a", pngOf(128, kRed));
  test.pack.texture("item/b", pngOf(128, kBlue));
  const auto look = test.look("minecraft:potion");
  ASSERT_TRUE(look.has_value());
  ASSERT_THAT(*look->faces, SizeIs(4));
  EXPECT_GT((*look->faces)[2].corners[0].z, (*look->faces)[0].corners[0].z);
  EXPECT_EQ(texelAt(test.atlas.albedo, test.atlas, "minecraft:item/b", {0.5f, 0.5f}), kBlue);
}

TEST(item_looks, moving_textures_have_the_edges_of_all_their_frames) {
  ItemTest test;
  test.item("clock", R"({"parent": "item/generated", "textures": {"layer0": "item/clock"}})");
  // One texel in the first frame, another in the second.
  test.pack.texture("item/clock", pngOf(16, 32, [](int x, int y) {
                      return (x == 2 && y == 2) || (x == 9 && y == 16 + 9) ? kRed : kNothing;
                    }));
  test.pack.files["/minecraft/textures/item/clock.png.mcmeta"] = R"({"animation": {}})";
  const auto look = test.look("minecraft:clock");
  EXPECT_EQ(test.errors, "");
  ASSERT_TRUE(look.has_value());
  EXPECT_THAT(*look->faces, SizeIs(2 + 2 * 4));
  ASSERT_NE(test.atlas.animations, nullptr);
  EXPECT_THAT(test.atlas.animations->front().frames, SizeIs(2));
}

TEST(item_looks, the_texture_of_its_name_is_enough) {
  ItemTest test;
  test.pack.texture("item/apple", pngOf(16, kGreen));
  const auto look = test.look("minecraft:apple");
  ASSERT_TRUE(look.has_value());
  EXPECT_EQ(look->poseOf(DisplayPlace::Ground).scale, glm::vec3(0.5f)) << "of the game's item/generated";
  EXPECT_FALSE(test.look("minecraft:stick").has_value());
  EXPECT_EQ(test.errors, "");
}

TEST(item_looks, a_block_is_held_as_its_model_or_as_its_blockstates_say) {
  ItemTest test;
  test.pack = stonePack();
  const auto byState = test.look("minecraft:stone");
  ASSERT_TRUE(byState.has_value());
  EXPECT_EQ(byState->poseOf(DisplayPlace::Ground).scale, glm::vec3(0.25f)) << "of block/block";
  EXPECT_THAT(*byState->faces, SizeIs(6));
  test.item("stone", R"({"elements": [{"from": [0,0,0], "to": [16,4,16],
    "faces": {"up": {"texture": "#a"}}}], "textures": {"a": "block/stone"}})");
  const auto byItem = test.look("minecraft:stone");
  ASSERT_TRUE(byItem.has_value());
  EXPECT_THAT(*byItem->faces, SizeIs(1));
  EXPECT_EQ(texelAt(test.atlas.albedo, test.atlas, "minecraft:block/stone", {0.5f, 0.5f}), kRed);
}

TEST(item_looks, a_definition_names_the_model_of_an_item_that_nobody_uses) {
  ItemTest test;
  test.pack.texture("item/quiet", pngOf(16, kGreen));
  test.pack.texture("item/pulled", pngOf(16, kRed));
  for (const char* name : {"quiet", "pulled"})
    test.item(name, fmt::format(
                        R"({{"parent": "item/generated", "textures": {{"layer0": "item/{}"}}}})", name));
  const std::string quiet = R"({"type": "model", "model": "item/quiet"})",
                    pulled = R"({"type": "model", "model": "item/pulled"})";
  for (const std::string& model :
       {quiet, fmt::format(R"({{"on_true": {}, "on_false": {}}})", pulled, quiet),
        fmt::format(R"({{"cases": [{{"when": "a", "model": {}}}], "fallback": {}}})", pulled, quiet),
        fmt::format(R"({{"entries": [{{"threshold": 1, "model": {}}}]}})", quiet),
        fmt::format(R"({{"models": [{}, {}]}})", quiet, pulled)}) {
    test.definition("bow", "{\"model\": " + model + "}");
    const auto look = test.look("minecraft:bow");
    ASSERT_TRUE(look.has_value()) << model;
    EXPECT_EQ(look->faces->front().texture, "minecraft:item/quiet") << model;
  }
  test.definition("bow", R"({"model": {"type": "special"}})");
  EXPECT_FALSE(test.look("minecraft:bow").has_value());
  EXPECT_EQ(test.errors, "");
}

/// The colour of the faces with a texture, as hexadecimal digits.
std::string tintOf(const std::optional<ItemLook>& look, const std::string& texture) {
  if (!look) return "no look";
  for (const ModelFace& face : *look->faces)
    if (face.texture == texture) {
      const glm::ivec3 rgb(glm::round(look->tintOf(face.tintIndex) * 255.0f));
      return fmt::format("{:02x}{:02x}{:02x}", rgb.r, rgb.g, rgb.b);
    }
  return "no face";
}

TEST(item_looks, layers_have_the_colours_of_the_definition) {
  ItemTest test;
  for (const char* name : {"item/a", "item/b", "item/c"}) test.pack.texture(name, pngOf(16, kRed));
  test.item("potion", R"({"parent": "item/generated",
    "textures": {"layer0": "item/a", "layer1": "item/b", "layer2": "item/c"}})");
  const auto tints = [&](const std::string& first, const std::string& second) {
    test.definition("potion", fmt::format(R"({{"model": {{"type": "model", "model": "item/potion",
      "tints": [{}, {}]}}}})", first, second));
    const auto look = test.look("minecraft:potion");
    EXPECT_EQ(tintOf(look, "minecraft:item/c"), "ffffff") << "beyond the list";
    return tintOf(look, "minecraft:item/a") + " " + tintOf(look, "minecraft:item/b");
  };
  EXPECT_EQ(tints(R"({"type": "minecraft:potion", "default": -13083194})",
                  R"({"type": "constant", "value": 255})"),
            "385dc6 0000ff");
  EXPECT_EQ(tints(R"({"type": "dye", "default": [1, 0.5, 0]})",
                  R"({"type": "minecraft:grass", "temperature": 0.5, "downfall": 1})"),
            "ff8000 91bd59");
  EXPECT_EQ(tints(R"({"type": "of_a_mod"})", R"({"type": "team", "default": 16711680})"),
            "ffffff ff0000");
  EXPECT_EQ(test.errors, "");
  test.definition("potion", R"({"model": {"model": "item/potion"}})");
  EXPECT_EQ(tintOf(test.look("minecraft:potion"), "minecraft:item/a"), "ffffff")
      << "a definition says all";
}

TEST(item_looks, packs_without_definitions_have_the_colours_of_older_games) {
  ItemTest test;
  for (const char* name : {"item/a", "item/b"}) test.pack.texture(name, pngOf(16, kRed));
  const auto tints = [&](const std::string& name) {
    test.item(name, R"({"parent": "item/generated",
      "textures": {"layer0": "item/a", "layer1": "item/b"}})");
    const auto look = test.look("minecraft:" + name);
    return tintOf(look, "minecraft:item/a") + " " + tintOf(look, "minecraft:item/b");
  };
  EXPECT_EQ(tints("leather_boots"), "a06540 ffffff");
  EXPECT_EQ(tints("splash_potion"), "385dc6 ffffff");
  EXPECT_EQ(tints("firework_star"), "ffffff 8a8a8a");
  EXPECT_EQ(tints("stick"), "ffffff ffffff");
}

TEST(item_looks, blocks_in_a_hand_have_the_colours_of_the_plains) {
  ItemTest test;
  test.pack.texture("block/a", pngOf(16, kRed));
  test.pack.texture("block/b", pngOf(16, kRed));
  const auto tints = [&](const std::string& name) {
    test.item(name, R"({"elements": [{"from": [0,0,0], "to": [16,16,16],
      "faces": {"up": {"texture": "#a", "tintindex": 0}, "down": {"texture": "#b"}}}],
      "textures": {"a": "block/a", "b": "block/b"}})");
    const auto look = test.look("minecraft:" + name);
    return tintOf(look, "minecraft:block/a") + " " + tintOf(look, "minecraft:block/b");
  };
  EXPECT_EQ(tints("grass_block"), "91bd59 ffffff");
  EXPECT_EQ(tints("birch_leaves"), "80a755 ffffff");
  test.definition("birch_leaves", R"({"model": {"model": "item/birch_leaves",
    "tints": [{"type": "constant", "value": -8345771}]}})");
  EXPECT_EQ(tints("birch_leaves"), "80a755 ffffff");
}

TEST(item_looks, mistakes_in_colours_have_their_place_and_the_item_is_white) {
  for (const auto& [tints, column] : {std::pair{"{}", 46}, {"[7]", 47},
                                      {R"([{"type": "dye", "default": "red"}])", 74},
                                      {R"([{"type": "dye", "default": [2, 0, 0]}])", 75}}) {
    ItemTest test;
    test.pack.texture("item/a", pngOf(16, kRed));
    test.item("bow", R"({"parent": "item/generated", "textures": {"layer0": "item/a"}})");
    test.definition("bow", R"({"model": {"model": "item/bow", "tints":     )" + std::string(tints) + "}}");
    EXPECT_EQ(tintOf(test.look("minecraft:bow"), "minecraft:item/a"), "ffffff") << tints;
    EXPECT_THAT(test.errors, HasSubstr(fmt::format("items/bow.json:1:{}: warning", column))) << tints;
  }
}

/// Three numbers of a place, as "0 45 0".
std::string text(const glm::vec3& v) { return fmt::format("{:g} {:g} {:g}", v.x, v.y, v.z); }

TEST(item_looks, poses_come_place_by_place_from_the_nearest_model) {
  ItemTest test;
  test.pack.texture("item/a", pngOf(16, kRed));
  test.item("stick", R"({"parent": "item/rod", "textures": {"layer0": "item/a"},
    "display": {"ground": {"rotation": [1, 2, 3]}, "head": {"rotation": "left to others"}}})");
  test.item("rod", R"({"parent": "item/handheld", "display": {
    "ground": {"rotation": [9, 9, 9]}, "fixed": {"translation": [200, -200, 1], "scale": [9, -9, 0.5]}}})");
  const auto look = test.look("minecraft:stick");
  EXPECT_EQ(test.errors, "");
  ASSERT_TRUE(look.has_value());
  EXPECT_EQ(text(look->poseOf(DisplayPlace::Ground).degrees), "1 2 3");
  EXPECT_EQ(text(look->poseOf(DisplayPlace::Ground).scale), "1 1 1") << "a place is taken whole";
  EXPECT_EQ(text(look->poseOf(DisplayPlace::Fixed).translation), "80 -80 1");
  EXPECT_EQ(text(look->poseOf(DisplayPlace::Fixed).scale), "4 -4 0.5");
  EXPECT_EQ(text(look->poseOf(DisplayPlace::FirstRight).degrees), "0 -90 25") << "item/handheld of the game";
  test.item("handheld", R"({"parent": "builtin/generated"})");
  EXPECT_EQ(text(test.look("minecraft:stick")->poseOf(DisplayPlace::FirstRight).degrees), "0 0 0")
      << "that of the pack says nothing";
}

TEST(item_looks, the_left_hand_mirrors_the_right_one) {
  ItemTest test;
  test.pack.texture("item/a", pngOf(16, kRed));
  const auto left = [&](const std::string& display) {
    test.item("stick", R"({"parent": "item/handheld", "textures": {"layer0": "item/a"}, "display": {)" + display + "}}");
    return test.look("minecraft:stick")->poseOf(DisplayPlace::FirstLeft);
  };
  const std::string right = R"("firstperson_righthand": {"rotation": [10, 20, 30], "translation": [1, 2, 3]})";
  EXPECT_EQ(text(left(right).degrees), "10 -20 -30") << "before the parent is asked";
  EXPECT_EQ(text(left(right).translation), "-1 2 3");
  EXPECT_EQ(text(left(right + R"(, "firstperson_lefthand": {"rotation": [5, 6, 7]})").degrees), "5 -6 -7");
}

TEST(item_looks, a_pose_turns_about_z_then_y_then_x_and_is_moved) {
  ItemLook look;
  look.poses[std::size_t(DisplayPlace::Ground)] = {{90, 0, 90}, {0, 16, 0}, {2, 1, 1}};
  const glm::mat4 m = look.posed(DisplayPlace::Ground);
  const auto at = [&](const glm::vec3& place) { return glm::vec3(m * glm::vec4(place, 1)); };
  EXPECT_LT(glm::length(at(glm::vec3(0.5f)) - glm::vec3(0, 1, 0)), 1e-5f) << "the middle";
  EXPECT_LT(glm::length(at({1, 0.5f, 0.5f}) - glm::vec3(0, 1, 1)), 1e-5f) << "from x to y, and then to z";
}

TEST(item_looks, models_whose_parent_is_absent_have_the_poses_of_blocks) {
  ItemTest test;
  test.pack.texture("item/a", pngOf(16, kRed));
  const auto scale = [&](const std::string& parent) {
    test.item("stick", R"({)" + parent + R"("elements": [{"from": [0,0,0], "to": [16,4,16],
      "faces": {"up": {"texture": "#a"}}}], "textures": {"a": "item/a"}})");
    return test.look("minecraft:stick")->poseOf(DisplayPlace::Fixed).scale.x;
  };
  EXPECT_EQ(scale(R"("parent": "item/absent", )"), 0.5f);
  EXPECT_EQ(scale(R"("parent": "block/cube", )"), 0.5f);
  EXPECT_EQ(scale(""), 1.0f);
}

TEST(item_looks, mistakes_in_poses_have_their_place) {
  for (const auto& [display, message] : {std::pair{"[]", "1:45: warning"},
                                         {R"({"ground": 1})", "1:56: warning"},
                                         {R"({"ground": {"scale": [1, 1]}})", "1:66: warning"},
                                         {R"({"fixed": {"rotation": [1, 1e9, 1]}})", "1:72: warning"}}) {
    ItemTest test;
    test.item("bow", R"({"parent": "item/generated",     "display": )" + std::string(display) + "}");
    EXPECT_FALSE(test.look("minecraft:bow").has_value());
    EXPECT_THAT(test.errors, HasSubstr(message)) << display;
  }
}

TEST(item_looks, mistakes_are_warnings_and_the_item_keeps_its_look) {
  ItemTest test;
  test.definition("bow", R"({"model": ["item/bow"]})");
  EXPECT_FALSE(test.look("minecraft:bow").has_value());
  EXPECT_THAT(test.errors, HasSubstr("items/bow.json:1:11: warning"));
  test.definition("bow", R"({"model": {"model": "item/bow"}})");
  test.item("bow", R"({"elements": [{"from": [0,0,0], "to": [16,4,16],
    "faces": {"up": {"texture": "#a"}}}], "textures": {"a": "item/absent"}})");
  EXPECT_FALSE(test.look("minecraft:bow").has_value());
  EXPECT_THAT(test.errors, HasSubstr("keep the look of Orris: item/bow"));
}

TEST(item_looks, deep_definitions_and_many_faces_end) {
  ItemTest test;
  test.pack.texture("item/bow", pngOf(16, kGreen));
  std::string deep = R"({"model": "item/none"})";
  for (int i = 0; i < 90; ++i) deep = "{\"fallback\": " + deep + "}";
  test.definition("bow", "{\"model\": " + deep + "}");
  EXPECT_TRUE(test.look("minecraft:bow").has_value()) << "by its texture";
  EXPECT_FALSE(test.look("minecraft:bow", 100'000).has_value());
  EXPECT_THAT(test.errors, HasSubstr("200000"));
}

}  // namespace
}  // namespace orris
