// Blocks drawn with resource packs that these tests make.
#include <orris/world/resources/block_look.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

#include <orris/core/limits.h>
#include "resource_helpers.h"
#include <orris/world/resources/block_models.h>
#include <orris/world/resources/texture_meta.h>

namespace orris {
namespace {

using testing::HasSubstr;

constexpr Texel8 kRed{200, 10, 10, 255}, kGreen{10, 200, 10, 255}, kBlue{10, 10, 200, 255};

TestPack stonePack() {
  TestPack pack;
  addCubeModels(pack);
  pack.state("stone", R"({"variants": {"": {"model": "minecraft:block/stone"}}})");
  pack.model("stone",
             R"({"parent": "minecraft:block/cube_all", "textures": {"all": "block/stone"}})");
  pack.texture("block/stone", pngOf(16, kRed));
  return pack;
}

Scene oneBlock(const std::string& state) {
  Scene scene(glm::ivec3(1));
  scene.set({0, 0, 0}, state);
  return scene;
}

Texel8 texelAt(const Image8& image, const BlockAtlas& atlas, const std::string& name,
               glm::vec2 place) {
  const AtlasTile tile = atlas.tile(name);
  const glm::vec2 uv = tile.min + place * (tile.max - tile.min);
  const std::uint8_t* texel =
      image.at(int(uv.x * float(image.width)), int(uv.y * float(image.height)));
  return {texel[0], texel[1], texel[2], texel[3]};
}

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

TEST(block_look, an_animation_begins_with_its_first_frame) {
  TestPack pack = stonePack();
  const Texel8 frames[] = {kRed, kGreen, kBlue};
  pack.texture("block/stone", pngOf(16, 48, [&](int, int y) { return frames[y / 16]; }));
  const std::string meta = "/minecraft/textures/block/stone.png.mcmeta";
  const auto color = [&](const std::string& json) {
    pack.files[meta] = json;
    pack.look(oneBlock("stone"));
    return texelAt(pack.atlas.albedo, pack.atlas, "minecraft:block/stone", {0.5f, 0.5f});
  };
  EXPECT_EQ(color(R"({"animation": {}})"), kRed);
  EXPECT_EQ(color(R"({"animation": {"frametime": 4, "frames": [2, 0, 1]}})"), kBlue);
  EXPECT_EQ(color(R"({"animation": {"interpolate": true, "frames": [{"index": 1, "time": 9}]}})"),
            kGreen);
  EXPECT_EQ(pack.errors, "");
  color(R"({"animation": {"frames": [7]}})");
  EXPECT_THAT(
      pack.errors,
      HasSubstr("pack/assets/minecraft/textures/block/stone.png.mcmeta:1:15: warning: the "
                "animation has a frame 7 of 16x16 texels, but the texture has 16x48"));
}

TEST(block_look, the_frames_of_an_animation_are_kept_once_each) {
  TestPack pack = stonePack();
  const Texel8 frames[] = {kRed, kGreen, kBlue};
  const auto strip = pngOf(16, 48, [&](int, int y) { return frames[y / 16]; });
  pack.texture("block/stone", strip);
  pack.files["/minecraft/textures/block/stone.png.mcmeta"] =
      R"({"animation": {"frametime": 3, "frames": [1, {"index": 2, "time": 5}, 1]}})";
  pack.look(oneBlock("stone"));
  ASSERT_TRUE(pack.atlas.animations);
  ASSERT_EQ(pack.atlas.animations->size(), 1u);
  const TileAnimation& animation = pack.atlas.animations->front();
  ASSERT_EQ(animation.frames.size(), 2u);
  ASSERT_EQ(animation.steps.size(), 3u);
  EXPECT_EQ(animation.steps[1].ticks, 5);
  EXPECT_EQ(animation.frames[0].normal.width, 0) << "no pack has maps of it";
  const AtlasTile tile = pack.atlas.tile("minecraft:block/stone");
  EXPECT_EQ(glm::vec2(animation.corner),
            tile.min * glm::vec2(pack.atlas.albedo.width, pack.atlas.albedo.height));
  const auto colour = [&](long tick) {
    const Image8& image = animation.frames[std::size_t(momentOf(animation, tick).frame)].albedo;
    return Texel8{image.at(8, 8)[0], image.at(8, 8)[1], image.at(8, 8)[2], image.at(8, 8)[3]};
  };
  EXPECT_EQ(colour(0), kGreen);
  EXPECT_EQ(colour(2), kGreen);
  EXPECT_EQ(colour(3), kBlue);
  EXPECT_EQ(colour(7), kBlue);
  EXPECT_EQ(colour(8), kGreen);
  EXPECT_EQ(colour(11 + 3), kBlue) << "again";
  pack.files["/minecraft/textures/block/stone.png.mcmeta"] = R"({"animation": {"frames": [1]}})";
  pack.look(oneBlock("stone"));
  EXPECT_FALSE(pack.atlas.animations) << "one frame does not move";
}

TEST(block_look, an_animation_may_have_frames_that_are_no_squares) {
  const auto metaOf = [](const std::string& size) {
    Diagnostics diagnostics;
    auto meta = parseTextureMeta({"{\"animation\": {" + size + "}}", "stone.png.mcmeta"}, {32, 64}, diagnostics);
    EXPECT_TRUE(diagnostics.empty());
    return meta.value_or(TextureMeta());
  };
  const TextureMeta square = metaOf(""), flat = metaOf(R"("width": 32, "height": 16)"),
                    low = metaOf(R"("height": 16)"), narrow = metaOf(R"("width": 16)");
  EXPECT_EQ(glm::ivec3(square.width, square.height, square.steps.size()), glm::ivec3(32, 32, 2));
  EXPECT_EQ(glm::ivec3(flat.width, flat.height, flat.steps.size()), glm::ivec3(32, 16, 4));
  EXPECT_EQ(glm::ivec3(low.width, low.height, low.steps.size()), glm::ivec3(32, 16, 4));
  EXPECT_EQ(glm::ivec3(narrow.width, narrow.height, narrow.steps.size()), glm::ivec3(16, 64, 2));
}

TEST(block_look, an_interpolated_animation_is_between_its_frames) {
  TileAnimation animation;
  animation.frames.resize(2);
  animation.steps = {{0, 4}, {1, 4}};
  animation.interpolate = true;
  EXPECT_EQ(momentOf(animation, 1), (AnimationMoment{0, 1, 0.25f}));
  EXPECT_EQ(momentOf(animation, 6), (AnimationMoment{1, 0, 0.5f}));
  Image8 dark(1, 1, 4), light(1, 1, 4);
  dark.pixels = {0, 100, 255, 10};
  light.pixels = {200, 100, 55, 90};
  EXPECT_EQ(mixed(dark, light, 0.25f).pixels, (std::vector<std::uint8_t>{50, 100, 205, 10}));
}

TEST(block_look, faces_that_the_model_does_not_shade_say_so) {
  TestPack pack = stonePack();
  pack.model("stone", R"({"parent": "block/cube_all", "textures": {"all": "block/stone"},
    "elements": [{"from": [0,0,0], "to": [16,16,16], "shade": false, "faces": {"east": {"texture": "#all"}}}]})");
  EXPECT_FALSE(pack.mesh(oneBlock("stone")).quad(0)[0].shade);
  EXPECT_TRUE(stonePack().mesh(oneBlock("stone")).quad(0)[0].shade);
}

/// Two blocks of water, of which the eastern one is lower.
ReadMesh flowingWater(TestPack& pack) {
  Scene scene({4, 3, 3});
  scene.fill({0, 0, 0}, {3, 0, 2}, "stone");
  scene.fill({0, 1, 0}, {3, 1, 2}, "stone");
  scene.set({1, 1, 1}, "water");
  scene.set({2, 1, 1}, "water[level=4]");
  return pack.mesh(scene);
}

TEST(block_look, water_flows_down_its_steps_with_a_texture_of_its_own) {
  TestPack pack = stonePack();
  pack.texture("block/water_still", pngOf(16, kGreen));
  const auto surfaces = [&] {
    std::vector<std::array<BlockVertex, 4>> tops;
    const ReadMesh mesh = flowingWater(pack);
    for (std::size_t i = 0; i < mesh.vertexCount(); i += 4)
      if (mesh.faces[i / 4].fluid == 1 && mesh.quad(i)[0].normal.y > 0) tops.push_back(mesh.quad(i));
    return tops;
  };
  const auto still = surfaces();
  ASSERT_EQ(still.size(), 2u);
  EXPECT_EQ(still[0][0].tangent, glm::vec4(1, 0, 0, 1));
  pack.texture("block/water_flow", pngOf(32, kBlue));
  const auto flowing = surfaces();
  ASSERT_EQ(flowing.size(), 2u);
  const AtlasTile tile = pack.atlas.tile("water_flow");
  for (const auto& quad : flowing) {
    // v grows to the east, u to the north, over half of the texture.
    EXPECT_LT(glm::distance(glm::vec3(quad[0].tangent), glm::vec3(0, 0, -1)), 1e-5f);
    const auto& east = quad[2];
    const auto& west = quad[1];
    EXPECT_EQ(east.position.x - west.position.x, 1);
    EXPECT_NEAR((east.uv - west.uv).y / (tile.max - tile.min).y, 0.5, 1e-5);
    EXPECT_NEAR((east.uv - west.uv).x, 0, 1e-5);
  }
}

TEST(block_look, water_flows_to_the_edge_that_it_falls_over) {
  TestPack pack = stonePack();
  pack.texture("block/water_still", pngOf(16, kGreen));
  pack.texture("block/water_flow", pngOf(32, kBlue));
  Scene scene({4, 3, 3});
  scene.fill({0, 0, 0}, {3, 2, 2}, "stone");
  scene.set({1, 2, 1}, "water");
  scene.set({2, 2, 1}, "air");
  scene.set({2, 1, 1}, "water");
  const ReadMesh mesh = pack.mesh(scene);
  int tops = 0;
  for (std::size_t i = 0; i < mesh.vertexCount(); i += 4) {
    const auto quad = mesh.quad(i);
    if (quad[0].fluid != 1 || quad[0].normal.y <= 0 || quad[0].position.y < 2) continue;
    ++tops;
    EXPECT_LT(glm::distance(glm::vec3(quad[0].tangent), glm::vec3(0, 0, -1)), 1e-5f) << "to the east";
  }
  EXPECT_EQ(tops, 1);
}

TEST(block_look, sides_of_water_wear_a_quarter_of_the_flowing_texture) {
  TestPack pack = stonePack();
  pack.texture("block/water_still", pngOf(16, kGreen));
  pack.texture("block/water_flow", pngOf(32, kBlue));
  Scene scene({3, 2, 3});
  scene.fill({0, 0, 0}, {2, 0, 2}, "stone");
  scene.set({1, 1, 1}, "water");
  const ReadMesh mesh = pack.mesh(scene);
  const AtlasTile tile = pack.atlas.tile("water_flow");
  const glm::vec2 end = (tile.min + tile.max) * 0.5f;
  int sides = 0;
  for (std::size_t i = 0; i < mesh.vertexCount(); i += 4) {
    const auto quad = mesh.quad(i);
    if (quad[0].fluid != 1 || quad[0].normal.y != 0) continue;
    ++sides;
    for (const BlockVertex& vertex : quad) {
      EXPECT_TRUE(glm::all(glm::greaterThanEqual(vertex.uv, tile.min)));
      EXPECT_TRUE(glm::all(glm::lessThanEqual(vertex.uv, end + 1e-6f)));
    }
    EXPECT_NEAR(quad[2].uv.x - quad[1].uv.x, end.x - tile.min.x, 1e-6f);
  }
  EXPECT_EQ(sides, 4);
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
  EXPECT_EQ(look.tints[0].grass, glm::u8vec3(127, 191, 7));
  EXPECT_EQ(look.tints[0].foliage, plainsTint(Tint::Foliage));  // the pack has no map of it
  const BlockFacts facts;
  EXPECT_EQ(modelTint(blockState("grass_block"), facts, 0, look.tints[0]), look.tints[0].grass);
  EXPECT_EQ(modelTint(blockState("spruce_leaves"), facts, 0, look.tints[0]),
            glm::u8vec3(0x61, 0x99, 0x61));
  EXPECT_EQ(modelTint(blockState("stone"), facts, 0, look.tints[0]), glm::u8vec3(255));
  EXPECT_EQ(modelTint(blockState("pink_petals"), facts, 0, look.tints[0]), glm::u8vec3(255));
  EXPECT_EQ(modelTint(blockState("pink_petals"), facts, 1, look.tints[0]), look.tints[0].grass);
}

TEST(block_look, biomes_of_a_save_have_their_colours_and_blend) {
  TestPack pack = stonePack();
  BiomeGrid grid;
  grid.size = {4, 1, 1};
  grid.names = {"minecraft:swamp", "minecraft:badlands"};
  grid.cells = {0, 0, 1, 1};  // the swamp ends at x = 8
  pack.world.biomes = std::make_shared<const BiomeGrid>(grid);
  const BlockLook look = pack.look(oneBlock("stone"));
  EXPECT_EQ(look.tintAt({3, 0, 0}).grass, glm::u8vec3(0x6a, 0x70, 0x39));
  EXPECT_EQ(look.tintAt({-50, 9, 0}).water, glm::u8vec3(0x61, 0x7b, 0x64));
  EXPECT_EQ(look.tintAt({12, 0, 0}).grass, glm::u8vec3(0x90, 0x81, 0x4d));
  // Of five columns around x = 7 three are swamp.
  EXPECT_EQ(look.tintAt({7, 0, 0}).grass.r, (3 * 0x6a + 2 * 0x90) / 5);
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

// --- blockstates ---

/// How many parts each state of a multipart block has.
std::size_t partsOf(const std::string& when, const std::string& state) {
  TestPack pack = stonePack();
  pack.state("oak_fence", R"({"multipart": [{"apply": {"model": "block/stone"}}, {"when": )" +
                              when + R"(, "apply": {"model": "block/stone"}}]})");
  const BlockLook look = pack.look(oneBlock("oak_fence[" + state + "]"));
  EXPECT_EQ(pack.errors, "");
  return look.models[1].parts.size();
}

TEST(block_look, parts_are_drawn_on_their_condition) {
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

TEST(block_look, a_variant_is_chosen_by_the_states_properties) {
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

TEST(block_look, weighted_variants_stand_where_the_dice_put_them) {
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

TEST(block_look, of_alternatives_those_without_a_model_are_never_chosen) {
  TestPack pack = stonePack();
  pack.state("stone",
             R"({"variants": {"": [{"model": "block/nowhere"}, {"model": "block/stone"}]}})");
  Scene scene({9, 1, 1});
  for (int x = 0; x < 9; x += 2) scene.set({x, 0, 0}, "stone");
  EXPECT_EQ(faceCount(pack.mesh(scene)), 5u * 6u);
}

// --- models ---

TEST(block_look, a_model_goes_before_its_parents) {
  TestPack pack = stonePack();
  pack.model("stone", R"({"parent": "block/middle", "textures": {"side": "block/stone"}})");
  pack.model("middle", R"({"parent": "block/cube_all", "ambientocclusion": false,
    "textures": {"all": "#side", "side": "block/other"}})");
  const auto faces = pack.faces("stone");
  ASSERT_EQ(faces.size(), 6u);
  EXPECT_EQ(faces[0].texture, "minecraft:block/stone");
  EXPECT_FALSE(faces[0].smooth);
}

TEST(block_look, parents_of_the_game_that_no_pack_has_are_built_in) {
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

TEST(block_look, a_texture_variable_that_leads_nowhere_is_the_missing_texture) {
  TestPack pack = stonePack();
  pack.model("stone",
             R"({"parent": "block/cube_all", "textures": {"all": "#a", "a": "#b", "b": "#a"}})");
  EXPECT_EQ(pack.faces("stone").at(0).texture, "missing");
}

TEST(block_look, a_model_that_is_its_own_parent_is_reported_at_its_place) {
  TestPack pack = stonePack();
  pack.model("stone", "{\n  \"parent\": \"block/a\"\n}");
  pack.model("a", R"({"parent": "block/stone"})");
  EXPECT_TRUE(pack.faces("stone").empty());
  EXPECT_THAT(pack.errors,
              HasSubstr("pack/assets/minecraft/models/block/a.json:1:12: warning: the model "
                        "\"block/stone\" is its own parent"));
}

TEST(block_look, models_that_no_pack_has_are_named_once) {
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

TEST(block_look, mistakes_have_a_line_and_a_column) {
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

// --- limits ---

std::string repeated(const std::string& text, std::size_t count) {
  std::string all = text;
  all.reserve((text.size() + 1) * count);
  for (std::size_t i = 1; i < count; ++i) all += "," + text;
  return all;
}

TEST(block_look, too_many_elements_variants_and_bytes_are_refused) {
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

TEST(block_look, a_chain_of_parents_ends) {
  TestPack pack = stonePack();
  for (int i = 0; i < 200; ++i)
    pack.model(fmt::format("m{}", i), fmt::format(R"({{"parent": "block/m{}"}})", i + 1));
  pack.model("stone", R"({"parent": "block/m0"})");
  EXPECT_TRUE(pack.faces("stone").empty());
  EXPECT_THAT(pack.errors, HasSubstr("more than 64 models inherit from each other"));
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

TEST(block_look, a_model_of_thousands_of_faces_everywhere_is_left_out) {
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

// --- a whole pack ---

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
