// Blockstates and models of resource packs that these tests make, right, wrong and huge.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <orris/core/limits.h>
#include <orris/world/resources/block_models.h>

#include "resource_helpers.h"

namespace orris {
namespace {

using testing::HasSubstr;

/// How many parts each state of a multipart block has.
std::size_t partsOf(const std::string& when, const std::string& state) {
  TestPack pack = stonePack();
  pack.state("oak_fence", R"({"multipart": [{"apply": {"model": "block/stone"}}, {"when": )" +
                              when + R"(, "apply": {"model": "block/stone"}}]})");
  const BlockLook look = pack.look(oneBlock("oak_fence[" + state + "]"));
  EXPECT_EQ(pack.errors, "");
  return look.models[1].parts.size();
}

TEST(block_models, parts_are_drawn_on_their_condition) {
  EXPECT_EQ(partsOf(R"({"north": "true"})", "north=true"), 2u);
  EXPECT_EQ(partsOf(R"({"north": true})", "north=true"), 2u);
  EXPECT_EQ(partsOf(R"({"north": "true"})", "north=false"), 1u);
  EXPECT_EQ(partsOf(R"({"north": "low|tall"})", "north=tall"), 2u);
  EXPECT_EQ(partsOf(R"({"north": "!none"})", "north=none"), 1u);
  EXPECT_EQ(partsOf(R"({"north": "!none"})", "north=low"), 2u);
  EXPECT_EQ(partsOf(R"({"north": "true", "east": "true"})", "north=true,east=false"), 1u);
  const std::string either = R"({"OR": [{"north": "true"}, {"east": "true", "west": "true"}]})";
  EXPECT_EQ(partsOf(either, "north=false,east=true,west=true"), 2u);
  EXPECT_EQ(partsOf(either, "north=false,east=true,west=false"), 1u);
  const std::string both =
      R"({"AND": [{"north": "true"}, {"OR": [{"east": "true"}, {"west": "true"}]}]})";
  EXPECT_EQ(partsOf(both, "north=true,east=false,west=true"), 2u);
  EXPECT_EQ(partsOf(both, "north=true,east=false,west=false"), 1u);
}

TEST(block_models, a_variant_is_chosen_by_the_states_properties) {
  TestPack pack = stonePack();
  pack.model("flat", R"({"parent": "block/stone", "elements": [{"from": [0,0,0], "to": [16,1,16],
    "faces": {"up": {"texture": "#all"}}}]})");
  pack.state(
      "oak_slab",
      R"({"variants": {"type=top": {"model": "block/stone"}, "type=bottom": {"model": "block/flat"}}})");
  EXPECT_EQ(pack.faces("oak_slab[type=top]").size(), 6u);
  EXPECT_EQ(pack.faces("oak_slab[type=bottom]").size(), 1u);
  EXPECT_EQ(pack.faces("oak_slab").size(), 1u);  // the default that a state may leave out
}

TEST(block_models, weighted_variants_stand_where_the_dice_put_them) {
  TestPack pack = stonePack();
  pack.model("green", R"({"parent": "block/cube_all", "textures": {"all": "block/green"}})");
  pack.texture("block/green", pngOf(16, kGreen));
  pack.state(
      "stone",
      R"({"variants": {"": [{"model": "block/stone"}, {"model": "block/green", "weight": 3}]}})");
  Scene scene({9, 1, 9});
  for (int x = 0; x < 9; x += 2)
    for (int z = 0; z < 9; z += 2) scene.set({x, 0, z}, "stone");
  const ReadMesh mesh = pack.mesh(scene);
  const AtlasTile green = pack.atlas.tile("minecraft:block/green");
  const auto isGreen = [&](const BlockVertex& v) {
    return glm::all(glm::greaterThanEqual(v.midUv, green.min)) &&
           glm::all(glm::lessThanEqual(v.midUv, green.max));
  };
  const auto count = std::count_if(mesh.vertices.begin(), mesh.vertices.end(), isGreen) / 24;
  EXPECT_GT(count, 12);
  EXPECT_LT(count, 25);
}

TEST(block_models, of_alternatives_those_without_a_model_are_never_chosen) {
  TestPack pack = stonePack();
  pack.state("stone",
             R"({"variants": {"": [{"model": "block/nowhere"}, {"model": "block/stone"}]}})");
  Scene scene({9, 1, 1});
  for (int x = 0; x < 9; x += 2) scene.set({x, 0, 0}, "stone");
  EXPECT_EQ(faceCount(pack.mesh(scene)), 5u * 6u);
}

TEST(block_models, a_model_goes_before_its_parents) {
  TestPack pack = stonePack();
  pack.model("stone", R"({"parent": "block/middle", "textures": {"side": "block/stone"}})");
  pack.model("middle", R"({"parent": "block/cube_all", "ambientocclusion": false,
    "textures": {"all": "#side", "side": "block/other"}})");
  const auto faces = pack.faces("stone");
  ASSERT_EQ(faces.size(), 6u);
  EXPECT_EQ(faces[0].texture, "minecraft:block/stone");
  EXPECT_FALSE(faces[0].smooth);
}

TEST(block_models, parents_of_the_game_that_no_pack_has_are_built_in) {
  TestPack pack;
  const auto facesOf = [&](const std::string& parent, const std::string& textures) {
    pack.state("stone", R"({"variants": {"": {"model": "block/own"}}})");
    pack.model("own", R"({"parent": "block/)" + parent + R"(", "textures": {)" + textures + "}}");
    return pack.faces("stone");
  };
  const auto column = facesOf("cube_column", R"("end": "block/a", "side": "block/b")");
  ASSERT_EQ(column.size(), 6u);
  EXPECT_EQ(column[int(FaceDirection::Up)].texture, "minecraft:block/a");
  EXPECT_EQ(column[int(FaceDirection::West)].texture, "minecraft:block/b");
  EXPECT_EQ(column[int(FaceDirection::West)].cull, FaceDirection::West);
  const auto slab = facesOf("slab", R"("bottom": "block/a", "top": "block/a", "side": "block/b")");
  ASSERT_EQ(slab.size(), 6u);
  EXPECT_EQ(slab[int(FaceDirection::Up)].corners[0].y, 0.5f);
  EXPECT_FALSE(slab[int(FaceDirection::Up)].cull);
  EXPECT_EQ(facesOf("tinted_cross", R"("cross": "block/a")").at(3).tintIndex, 0);
  EXPECT_EQ(facesOf("leaves", R"("all": "block/a")").at(5).tintIndex, 0);
  EXPECT_TRUE(facesOf("nothing_of_ours", R"("all": "block/a")").empty());
}

TEST(block_models, a_texture_variable_that_leads_nowhere_is_the_missing_texture) {
  TestPack pack = stonePack();
  pack.model("stone",
             R"({"parent": "block/cube_all", "textures": {"all": "#a", "a": "#b", "b": "#a"}})");
  EXPECT_EQ(pack.faces("stone").at(0).texture, "missing");
}

TEST(block_models, a_model_that_is_its_own_parent_is_reported_at_its_place) {
  TestPack pack = stonePack();
  pack.model("stone", "{\n  \"parent\": \"block/a\"\n}");
  pack.model("a", R"({"parent": "block/stone"})");
  EXPECT_TRUE(pack.faces("stone").empty());
  EXPECT_THAT(pack.errors,
              HasSubstr("pack/assets/minecraft/models/block/a.json:1:12: warning: the model "
                        "\"block/stone\" is its own parent"));
}

TEST(block_models, models_that_no_pack_has_are_named_once) {
  TestPack pack = stonePack();
  pack.model("stone", R"({"parent": "block/nowhere"})");
  pack.state("dirt", R"({"variants": {"": {"model": "block/nowhere"}}})");
  Scene scene({2, 1, 1});
  scene.set({0, 0, 0}, "stone");
  scene.set({1, 0, 0}, "dirt");
  pack.look(scene);
  EXPECT_THAT(pack.errors,
              HasSubstr("warning: a model that blocks of this world use is in none of the resource "
                        "packs: minecraft:block/nowhere"));
}

TEST(block_models, mistakes_have_a_line_and_a_column) {
  TestPack pack = stonePack();
  pack.model("stone",
             "{\"elements\": [\n {\"from\": [0, 0, 40], \"to\": [1, 1, 1], \"faces\": {}}]}");
  EXPECT_TRUE(pack.faces("stone").empty());
  EXPECT_THAT(
      pack.errors,
      HasSubstr("pack/assets/minecraft/models/block/stone.json:2:18: warning: \"from\" is 40: "
                "expected a number from -16 to 32"));
  pack.model("stone", "{\"parent\": \"../../secret\"}");
  pack.faces("stone");
  EXPECT_THAT(pack.errors,
              HasSubstr("stone.json:1:12: warning: \"../../secret\" is no name of a model"));
  pack.state("stone", "{\n\"variants\": {\"\": {\"model\": }}}");
  pack.faces("stone");
  EXPECT_THAT(pack.errors, HasSubstr("blockstates/stone.json:2:"));
}

std::string repeated(const std::string& text, std::size_t count) {
  std::string all = text;
  all.reserve((text.size() + 1) * count);
  for (std::size_t i = 1; i < count; ++i) all += "," + text;
  return all;
}

TEST(block_models, too_many_elements_variants_and_bytes_are_refused) {
  TestPack pack = stonePack();
  pack.model("stone", "{\"elements\": [" + repeated("{}", limits::kModelElements + 1) + "]}");
  EXPECT_TRUE(pack.faces("stone").empty());
  EXPECT_THAT(pack.errors, HasSubstr("the model has 4097 elements: expected at most 4096"));
  pack.model("stone", "{\"elements\": [" + repeated("{}", 1'000'000) + "]}");
  pack.faces("stone");
  EXPECT_THAT(pack.errors,
              HasSubstr("stone.json:1:1500009: warning: more than 500000 values up to here"));
  std::string variants = "{\"variants\": {";
  for (int i = 0; i < 100'000; ++i) variants += fmt::format("\"a={}\": {{\"model\": \"b\"}},", i);
  pack.state("stone", variants + "\"\": {\"model\": \"b\"}}}");
  pack.faces("stone");
  EXPECT_THAT(pack.errors, HasSubstr("more than 4096 variants and parts up to here"));
  pack.state("stone", std::string(limits::kResourceJsonBytes + 1, ' '));
  pack.faces("stone");
  EXPECT_THAT(pack.errors, HasSubstr("the file has 4194305 bytes: expected at most 4194304"));
}

TEST(block_models, a_chain_of_parents_ends) {
  TestPack pack = stonePack();
  for (int i = 0; i < 200; ++i)
    pack.model(fmt::format("m{}", i), fmt::format(R"({{"parent": "block/m{}"}})", i + 1));
  pack.model("stone", R"({"parent": "block/m0"})");
  EXPECT_TRUE(pack.faces("stone").empty());
  EXPECT_THAT(pack.errors, HasSubstr("more than 64 models inherit from each other"));
}

TEST(block_models, a_model_of_thousands_of_faces_everywhere_is_left_out) {
  TestPack pack = stonePack();
  pack.model(
      "stone",
      "{\"textures\": {\"all\": \"block/stone\"}, \"elements\": [" +
          repeated(R"({"from": [0,0,0], "to": [1,1,1], "faces": {"up": {"texture": "#all"}}})",
                   limits::kModelElements) +
          "]}");
  Scene scene({11, 10, 10});
  scene.fill({0, 0, 0}, {10, 9, 9}, "stone");
  const BlockLook look = pack.look(scene);
  EXPECT_EQ(look.modelled, 0u);
  EXPECT_THAT(
      pack.errors,
      HasSubstr("minecraft:stone has a model of 4096 faces and stands 1100 times in the world"));
}

}  // namespace
}  // namespace orris
