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
  EXPECT_TRUE(look->flat);
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

TEST(item_looks, the_texture_of_its_name_is_enough) {
  ItemTest test;
  test.pack.texture("item/apple", pngOf(16, kGreen));
  const auto look = test.look("minecraft:apple");
  ASSERT_TRUE(look.has_value());
  EXPECT_TRUE(look->flat);
  EXPECT_FALSE(test.look("minecraft:stick").has_value());
  EXPECT_EQ(test.errors, "");
}

TEST(item_looks, a_block_is_held_as_its_model_or_as_its_blockstates_say) {
  ItemTest test;
  test.pack = stonePack();
  const auto byState = test.look("minecraft:stone");
  ASSERT_TRUE(byState.has_value());
  EXPECT_FALSE(byState->flat);
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
