// Blocks drawn with resource packs that these tests make.
#include <orris/world/resources/block_look.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

#include "resource_helpers.h"

namespace orris {
namespace {

using testing::HasSubstr;

bool sameBytes(const BlockVertex& a, const BlockVertex& b) {
  const auto same = [](const auto& x, const auto& y) { return std::memcmp(&x, &y, sizeof x) == 0; };
  return same(a.position, b.position) && same(a.uv, b.uv) && same(a.midUv, b.midUv) &&
         same(a.normal, b.normal) && same(a.tangent, b.tangent) && same(a.tint, b.tint) &&
         same(a.light, b.light) && same(a.midBlock, b.midBlock) && a.state == b.state &&
         a.fluid == b.fluid;
}

TEST(block_look, a_full_cube_by_model_has_the_bytes_of_ours) {
  Scene scene({4, 3, 4});
  scene.fill({0, 0, 0}, {3, 0, 3}, "stone");
  scene.set({1, 1, 1}, "stone");
  TestPack pack = stonePack();
  const ReadMesh modelled = pack.mesh(scene);
  EXPECT_EQ(pack.errors, "");
  BlockAtlas atlas = pack.atlas;
  atlas.tiles["stone"] = atlas.tiles.at("minecraft:block/stone");
  const std::vector<BlockFacts> facts = scene.facts();
  const ReadMesh own = buildMesh({scene.blocks, facts, scene.light(), atlas});
  ASSERT_EQ(modelled.vertices.size(), own.vertices.size());
  for (std::size_t i = 0; i < own.vertices.size(); ++i)
    ASSERT_TRUE(sameBytes(modelled.vertices[i], own.vertices[i])) << "vertex " << i;
}

TEST(block_look, what_the_pack_lacks_keeps_our_look_and_is_named) {
  Scene scene({3, 1, 1});
  scene.set({0, 0, 0}, "stone");
  scene.set({1, 0, 0}, "bricks");
  TestPack pack = stonePack();
  const BlockLook look = pack.look(scene);
  EXPECT_EQ(look.modelled, 1u);
  EXPECT_THAT(look.ownLook, testing::ElementsAre("minecraft:bricks"));
  EXPECT_EQ(texelAt(pack.atlas.albedo, pack.atlas, "minecraft:block/stone", {0.5f, 0.5f}), kRed);
  const BlockAtlas own = buildAtlas({"bricks"});
  EXPECT_EQ(texelAt(pack.atlas.albedo, pack.atlas, "bricks", {0.3f, 0.7f}),
            texelAt(own.albedo, own, "bricks", {0.3f, 0.7f}));
}

TEST(block_look, a_texture_of_the_same_name_clothes_our_shape) {
  TestPack pack;
  pack.texture("block/bricks", pngOf(32, kBlue));
  const BlockLook look = pack.look(oneBlock("bricks"));
  EXPECT_EQ(look.textures, 1u);
  EXPECT_EQ(texelAt(pack.atlas.albedo, pack.atlas, "bricks", {0.9f, 0.1f}), kBlue);
}

TEST(block_look, the_first_pack_goes_before_the_others) {
  TestPack first = stonePack(), second = stonePack();
  first.files = {{"/minecraft/textures/block/stone.png", pngOf(16, kGreen)}};
  ResourceStack stack;
  stack.add("first", memorySource(first.files));
  stack.add("second", memorySource(second.files));
  Scene scene = oneBlock("stone");
  World world;
  world.blocks = scene.blocks;
  std::vector<BlockFacts> facts = scene.facts();
  BlockAtlas atlas;
  Diagnostics diagnostics;
  EXPECT_EQ(makeBlockLook(stack, world, facts, atlas, diagnostics).modelled, 1u);
  EXPECT_EQ(texelAt(atlas.albedo, atlas, "minecraft:block/stone", {0.5f, 0.5f}), kGreen);
}

TEST(block_look, faces_that_the_model_does_not_shade_say_so) {
  TestPack pack = stonePack();
  pack.model("stone", R"({"parent": "block/cube_all", "textures": {"all": "block/stone"},
    "elements": [{"from": [0,0,0], "to": [16,16,16], "shade": false, "faces": {"east": {"texture": "#all"}}}]})");
  EXPECT_FALSE(pack.mesh(oneBlock("stone")).quad(0)[0].shade);
  EXPECT_TRUE(stonePack().mesh(oneBlock("stone")).quad(0)[0].shade);
}

TEST(block_look, labpbr_maps_lie_beside_their_texture) {
  TestPack pack = stonePack();
  const auto normal = [&] {
    return texelAt(pack.atlas.normal, pack.atlas, "minecraft:block/stone", {0.5f, 0.5f});
  };
  const auto specular = [&] {
    return texelAt(pack.atlas.specular, pack.atlas, "minecraft:block/stone", {0.5f, 0.5f});
  };
  pack.look(oneBlock("stone"));
  EXPECT_EQ(normal(), (Texel8{127, 127, 255, 255}));
  EXPECT_EQ(specular(), (Texel8{0, 0, 0, 0}));
  pack.texture("block/stone_n", pngOf(32, {100, 140, 200, 90}));
  pack.texture("block/stone_s", pngOf(8, {250, 230, 64, 254}));
  pack.look(oneBlock("stone"));
  EXPECT_EQ(normal(), (Texel8{100, 140, 200, 90}));
  EXPECT_EQ(specular(), (Texel8{250, 230, 64, 254}));
}

TEST(block_look, grass_takes_the_colour_map_and_spruce_its_own_green) {
  TestPack pack = stonePack();
  pack.texture("colormap/grass", pngOf(256, 256, [](int x, int y) {
                 return Texel8{x, y, 7, 255};
               }));
  pack.world.environment.temperature = 0.5f;
  pack.world.environment.rainfall = 0.5f;
  const BlockLook look = pack.look(oneBlock("stone"));
  EXPECT_EQ(look.tints.byBiome[0].grass, glm::u8vec3(127, 191, 7));
  EXPECT_EQ(look.tints.byBiome[0].foliage, glm::u8vec3(98, 169, 72)) << "blended, as the pack has no map of it";
  const BlockFacts facts;
  EXPECT_EQ(modelTint(blockState("grass_block"), facts, 0, look.tints.byBiome[0]), look.tints.byBiome[0].grass);
  EXPECT_EQ(modelTint(blockState("spruce_leaves"), facts, 0, look.tints.byBiome[0]),
            glm::u8vec3(0x61, 0x99, 0x61));
  EXPECT_EQ(modelTint(blockState("stone"), facts, 0, look.tints.byBiome[0]), glm::u8vec3(255));
  EXPECT_EQ(modelTint(blockState("pink_petals"), facts, 0, look.tints.byBiome[0]), glm::u8vec3(255));
  EXPECT_EQ(modelTint(blockState("pink_petals"), facts, 1, look.tints.byBiome[0]), look.tints.byBiome[0].grass);
}

TEST(block_look, biomes_of_a_save_have_their_colours_and_blend) {
  TestPack pack = stonePack();
  BiomeGrid grid;
  grid.size = {4, 1, 1};
  grid.names = {"minecraft:swamp", "minecraft:badlands"};
  grid.cells = {0, 0, 1, 1};  // the swamp ends at x = 8
  pack.world.biomes = std::make_shared<const BiomeGrid>(grid);
  const BlockLook look = pack.look(oneBlock("stone"));
  EXPECT_EQ(look.tints.at({3, 0, 0}).grass, glm::u8vec3(0x6a, 0x70, 0x39));
  EXPECT_EQ(look.tints.at({-50, 9, 0}).water, glm::u8vec3(0x61, 0x7b, 0x64));
  EXPECT_EQ(look.tints.at({12, 0, 0}).grass, glm::u8vec3(0x90, 0x81, 0x4d));
  // Of five columns around x = 7 three are swamp.
  EXPECT_EQ(look.tints.at({7, 0, 0}).grass.r, (3 * 0x6a + 2 * 0x90) / 5);
}

TEST(block_look, a_texture_with_holes_is_no_solid_layer) {
  TestPack pack = stonePack();
  pack.texture("block/stone", pngOf(16, 16, [](int x, int) {
                 return x < 4 ? Texel8{0, 0, 0, 0} : kRed;
               }));
  const ReadMesh mesh = pack.mesh(oneBlock("stone"));
  ASSERT_EQ(mesh.sections.size(), 1u);
  EXPECT_EQ(mesh.sections[0].layer, RenderLayer::Cutout);
  // Filtering brings no dark rims.
  EXPECT_EQ(texelAt(pack.atlas.albedo, pack.atlas, "minecraft:block/stone", {0.1f, 0.5f}),
            (Texel8{200, 10, 10, 0}));
}

TEST(block_look, a_block_that_only_the_pack_knows_is_drawn) {
  TestPack pack = stonePack();
  pack.files["/mod/blockstates/thing.json"] = R"({"variants": {"": {"model": "block/stone"}}})";
  const ReadMesh mesh = pack.mesh(oneBlock("mod:thing"));
  EXPECT_EQ(faceCount(mesh), 6u);
  EXPECT_TRUE(pack.facts[1].known);
  EXPECT_TRUE(pack.facts[1].fullOpaqueCube);
}

TEST(block_look, damaged_and_huge_textures_are_reported_and_drawn_as_ours) {
  TestPack pack = stonePack();
  const std::string whole = pngOf(16, kRed);
  std::string huge = whole;
  huge.replace(16, 8, std::string("\0\1\0\0\0\1\0\0", 8));
  for (const auto& [bytes, message] :
       {std::pair{std::string("nothing"), "this is no PNG"},
        std::pair{whole.substr(0, 60), "cannot read the image"},
        std::pair{huge, "the texture has 65536x65536 texels: expected at most 16777216 in all"}}) {
    pack.texture("block/stone", bytes);
    EXPECT_EQ(pack.faces("stone").size(), 6u);
    EXPECT_THAT(pack.errors,
                HasSubstr("pack/assets/minecraft/textures/block/stone.png: warning: "));
    EXPECT_THAT(pack.errors, HasSubstr(message));
  }
}

/// 300 blocks, each with a state file, a model of one of five kinds and a texture.
TestPack packOf300() {
  TestPack pack;
  addCubeModels(pack);
  pack.model("post", R"({"textures": {"all": "block/0"}, "elements": [
    {"from": [6,0,6], "to": [10,16,10], "faces": {"up": {"texture": "#all"}, "north": {"texture": "#all"},
     "south": {"texture": "#all"}, "west": {"texture": "#all"}, "east": {"texture": "#all"}}}]})");
  pack.model("arm", R"({"parent": "block/post", "elements": [
    {"from": [7,6,0], "to": [9,9,7], "faces": {"north": {"texture": "#all"}, "up": {"texture": "#all"}}}]})");
  const char* const states[] = {
      R"({{"variants": {{"": {{"model": "block/m{0}"}}}}}})",
      R"({{"variants": {{"axis=x": {{"model": "block/m{0}", "x": 90, "y": 90}}, "axis=y": {{"model": "block/m{0}"}}}}}})",
      R"({{"variants": {{"facing=east": {{"model": "block/m{0}", "y": 90, "uvlock": true}}}}}})",
      R"({{"multipart": [{{"apply": {{"model": "block/m{0}"}}}},
          {{"when": {{"north": "true"}}, "apply": {{"model": "block/arm"}}}},
          {{"when": {{"east": "true"}}, "apply": {{"model": "block/arm", "y": 90, "uvlock": true}}}}]}})",
      R"({{"variants": {{"": [{{"model": "block/m{0}"}}, {{"model": "block/m{0}", "y": 180, "weight": 2}}]}}}})"};
  for (int i = 0; i < 300; ++i) {
    const char* parent = i % 5 == 3 ? "block/post" : "block/cube_all";
    pack.files[fmt::format("/mod/blockstates/b{}.json", i)] =
        fmt::format(fmt::runtime(states[i % 5]), i);
    pack.model(fmt::format("m{}", i), fmt::format(R"({{"parent": "{}", "textures": {{"all": "block/{}"}}}})",
                                                  parent, i));
    pack.texture(fmt::format("block/{}", i), pngOf(i % 7 == 0 ? 32 : 16, {i % 256, i / 2, 60, 255}));
    if (i % 10 != 1) continue;
    pack.texture(fmt::format("block/{}", i), pngOf(16, 32, [&](int, int y) {
                   return Texel8{y < 16 ? i % 256 : 1, i / 2, 60, 255};
                 }));
    pack.files[fmt::format("/minecraft/textures/block/{}.png.mcmeta", i)] =
        R"({"animation": {"frametime": 2}})";
  }
  return pack;
}

TEST(block_look, a_pack_of_300_models_draws_each_block_with_its_own_texture) {
  TestPack pack = packOf300();
  Scene scene({40, 3, 60});
  const char* const properties[] = {"", "[axis=x]", "[facing=east]", "[east=true,north=true]", ""};
  const auto cellOf = [](int i) { return glm::ivec3(i % 20 * 2, 1, i / 20 * 4); };
  for (int i = 0; i < 300; ++i)
    scene.set(cellOf(i), fmt::format("mod:b{}{}", i, properties[i % 5]));
  const ReadMesh mesh = pack.mesh(scene);
  EXPECT_EQ(pack.errors, "");
  ASSERT_EQ(pack.atlas.animations->size(), 30u);
  std::map<int, int> faces;  // by block
  for (const MeshSection& section : mesh.sections) {
    for (std::uint32_t v = section.first; v < section.first + section.count; v += 4) {
      const glm::ivec3 cell = section.origin + glm::ivec3(mesh.faces[v / 4].cell);
      const int i = cell.x / 2 + cell.z / 4 * 20;
      ASSERT_EQ(cell, cellOf(i));
      ++faces[i];
      const auto quad = mesh.quad(v);
      const glm::vec2 size(pack.atlas.albedo.width, pack.atlas.albedo.height);
      const std::uint8_t* texel = pack.atlas.albedo.at(int(quad[0].midUv.x * size.x),
                                                       int(quad[0].midUv.y * size.y));
      const bool arm = i % 5 == 3 && texel[0] == 0;  // of block 0's texture
      EXPECT_TRUE(arm || (texel[0] == i % 256 && texel[1] == i / 2)) << "block " << i;
    }
  }
  for (int i = 0; i < 300; ++i) EXPECT_EQ(faces[i], i % 5 == 3 ? 5 + 2 + 2 : 6) << "block " << i;
}

}  // namespace
}  // namespace orris
