#include <orris/world/mesh/block_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include <orris/world/resources/biome_tint.h>

#include "world_helpers.h"

namespace orris {
namespace {

struct Quad {
  std::array<BlockVertex, 4> v;
  glm::vec3 normal() const { return v[0].normal; }
};

/// The quads with the given normal, in the mesh's order.
std::vector<Quad> quadsFacing(const ReadMesh& mesh, glm::vec3 normal) {
  std::vector<Quad> quads;
  for (std::size_t i = 0; i < mesh.vertices.size(); i += 4) {
    if (mesh.vertices[i].normal == normal) quads.push_back({mesh.quad(i)});
  }
  return quads;
}

TEST(BlockMesh, single_cube_has_six_faces_and_two_have_ten) {
  Scene scene({3, 3, 3});
  scene.set({0, 1, 1}, "stone");
  EXPECT_EQ(faceCount(scene.mesh()), 6u);
  scene.set({1, 1, 1}, "dirt");
  EXPECT_EQ(faceCount(scene.mesh()), 10u);
}

TEST(BlockMesh, south_face_has_exactly_these_attributes) {
  Scene scene({1, 1, 1}, {17, 2, -3});
  scene.set({17, 2, -3}, "stone");
  const ReadMesh mesh = scene.mesh();
  ASSERT_EQ(mesh.sections.size(), 1u);
  EXPECT_EQ(mesh.sections[0].origin, glm::ivec3(16, 0, -16));
  EXPECT_EQ(mesh.sections[0].layer, RenderLayer::Solid);
  EXPECT_EQ(mesh.sections[0].count, 24u);
  const std::vector<Quad> quads = quadsFacing(mesh, {0, 0, 1});
  ASSERT_EQ(quads.size(), 1u);
  const AtlasTile tile = buildAtlas(texturesOf(scene.facts())).tile("stone");
  const glm::vec3 positions[] = {{1, 3, 14}, {1, 2, 14}, {2, 2, 14}, {2, 3, 14}};
  const glm::vec2 uvs[] = {tile.min, {tile.min.x, tile.max.y}, tile.max, {tile.max.x, tile.min.y}};
  const glm::i8vec4 middles[] = {
      {32, -32, -32, 0}, {32, 32, -32, 0}, {-32, 32, -32, 0}, {-32, -32, -32, 0}};
  for (int i = 0; i < 4; ++i) {
    const BlockVertex& vertex = quads[0].v[i];
    EXPECT_EQ(vertex.position, positions[i]) << i;
    EXPECT_EQ(vertex.uv, uvs[i]) << i;
    EXPECT_EQ(vertex.midUv, (tile.min + tile.max) * 0.5f) << i;
    EXPECT_EQ(vertex.tangent, glm::vec4(1, 0, 0, 1)) << i;
    EXPECT_EQ(vertex.tint, glm::u8vec4(255)) << i;
    EXPECT_EQ(vertex.light, glm::u8vec2(0, 240)) << i;
    EXPECT_EQ(vertex.midBlock, middles[i]) << i;
    EXPECT_EQ(vertex.state, 1) << i;
    EXPECT_EQ(vertex.fluid, 0) << i;
  }
}

TEST(BlockMesh, partial_faces_crop_the_tile_by_position) {
  Scene scene({1, 1, 1});
  scene.set({0, 0, 0}, "stone_slab[type=bottom]");
  const ReadMesh mesh = scene.mesh();
  EXPECT_EQ(faceCount(mesh), 6u);
  const AtlasTile tile = buildAtlas(texturesOf(scene.facts())).tile("stone");
  const Quad east = quadsFacing(mesh, {1, 0, 0}).at(0);
  const float middle = (tile.min.y + tile.max.y) / 2;
  EXPECT_EQ(east.v[0].position, glm::vec3(1, 0.5f, 1));
  EXPECT_FLOAT_EQ(east.v[0].uv.y, middle);
  EXPECT_FLOAT_EQ(east.v[1].uv.y, tile.max.y);
  EXPECT_FLOAT_EQ(east.v[0].midUv.y, (middle + tile.max.y) / 2);
}

TEST(BlockMesh, shapes_have_their_number_of_faces) {
  const auto faces = [](const char* state) {
    Scene scene({1, 1, 1});
    scene.set({0, 0, 0}, state);
    return faceCount(scene.mesh());
  };
  EXPECT_EQ(faces("air"), 0u);
  EXPECT_EQ(faces("stone_slab[type=top]"), 6u);
  EXPECT_EQ(faces("poppy"), 4u) << "two planes seen from both sides";
  EXPECT_EQ(faces("water"), 7u) << "the surface is also seen from below";
  // The straight stair: 1 bottom, 1 back over both steps or 2, 2 + 2 sides, 2 tops, 2 fronts.
  EXPECT_GE(faces("stone_stairs[facing=north,half=bottom,shape=straight]"), 9u);
  EXPECT_LE(faces("stone_stairs[facing=north,half=bottom,shape=straight]"), 11u);
}

TEST(BlockMesh, equal_glass_and_water_have_no_faces_between) {
  for (const char* state : {"glass", "red_stained_glass", "water"}) {
    Scene scene({2, 1, 1});
    scene.fill({0, 0, 0}, {1, 0, 0}, state);
    const ReadMesh mesh = scene.mesh();
    EXPECT_GT(faceCount(mesh), 9u) << state;
    for (const BlockVertex& vertex : mesh.vertices) {
      EXPECT_FALSE(vertex.normal.x != 0 && vertex.position.x == 1) << state;
    }
  }
  Scene scene({2, 1, 1});
  scene.set({0, 0, 0}, "glass");
  scene.set({1, 0, 0}, "red_stained_glass");
  EXPECT_EQ(faceCount(scene.mesh()), 12u);
}

// As in the game: edges and ends that meet are not drawn, an end that meets no arm is.
TEST(BlockMesh, panes_have_no_faces_where_they_meet) {
  for (const std::string pane : {"glass_pane", "red_stained_glass_pane", "iron_bars"}) {
    Scene scene({1, 2, 2});
    scene.fill({0, 0, 0}, {0, 1, 1}, pane + "[north=true,south=true]");
    const auto between = [&] {
      const ReadMesh mesh = scene.mesh();
      return std::count_if(mesh.vertices.begin(), mesh.vertices.end(), [](const BlockVertex& v) {
        return (v.normal.z != 0 && v.position.z == 1) || (v.normal.y != 0 && v.position.y == 1);
      });
    };
    EXPECT_EQ(between(), 0) << pane;
    scene.set({0, 1, 1}, pane + "[south=true]");
    EXPECT_GT(between(), 0) << pane;
  }
}

TEST(BlockMesh, bubble_columns_join_with_water) {
  Scene scene({2, 1, 1});
  scene.set({0, 0, 0}, "water");
  scene.set({1, 0, 0}, "bubble_column");
  EXPECT_EQ(quadsFacing(scene.mesh(), {1, 0, 0}).size(), 1u);
}

TEST(BlockMesh, solid_slabs_hide_each_other_but_not_the_block_beside) {
  Scene slabs({2, 1, 1});
  slabs.fill({0, 0, 0}, {1, 0, 0}, "stone_slab[type=bottom]");
  EXPECT_EQ(faceCount(slabs.mesh()), 10u);
  Scene beside({2, 1, 1});
  beside.set({0, 0, 0}, "stone");
  beside.set({1, 0, 0}, "stone_slab[type=bottom]");
  EXPECT_EQ(faceCount(beside.mesh()), 6u + 5u);
}

TEST(BlockMesh, fluid_surface_lies_at_eight_ninths_and_steps_down_as_it_flows) {
  Scene scene({2, 1, 1});
  scene.set({0, 0, 0}, "water");
  scene.set({1, 0, 0}, "water[level=3]");
  const ReadMesh mesh = scene.mesh();
  const std::vector<Quad> tops = quadsFacing(mesh, {0, 1, 0});
  ASSERT_EQ(tops.size(), 2u);
  EXPECT_FLOAT_EQ(tops[0].v[0].position.y, 8.0f / 9);
  EXPECT_FLOAT_EQ(tops[1].v[0].position.y, 5.0f / 9);
  EXPECT_EQ(quadsFacing(mesh, {1, 0, 0}).size(), 2u) << "the step between and the end";
  EXPECT_EQ(quadsFacing(mesh, {-1, 0, 0}).size(), 1u);
  EXPECT_EQ(tops[0].v[0].fluid, 1);
  EXPECT_EQ(tops[0].v[0].tint, glm::u8vec4(0x3F, 0x76, 0xE4, 255));
}

TEST(BlockMesh, fluids_take_the_brighter_light_of_their_cell_and_the_one_above) {
  Scene scene({1, 2, 1});
  scene.fill({0, 0, 0}, {0, 1, 0}, "water");
  const LightLevels light = scene.light();
  EXPECT_EQ(light.sky({0, 1, 0}), 14);
  const ReadMesh mesh = scene.mesh();
  EXPECT_EQ(quadsFacing(mesh, {0, 1, 0}).at(0).v[0].light.y, 15 * 16);
  EXPECT_EQ(quadsFacing(mesh, {0, -1, 0}).at(0).v[0].light.y, 14 * 16);
}

TEST(BlockMesh, waterlogged_blocks_stand_in_water_that_carries_its_own_id) {
  Scene scene({1, 1, 1});
  const std::uint32_t water = scene.blocks.paletteIndex(blockState("water"));
  scene.set({0, 0, 0}, "oak_fence[waterlogged=true]");
  const ReadMesh mesh = scene.mesh();
  const auto fluid =
      std::count_if(mesh.vertices.begin(), mesh.vertices.end(),
                    [&](const BlockVertex& v) { return v.state == water && v.fluid; });
  EXPECT_EQ(fluid, 7 * 4);
  EXPECT_GT(mesh.vertices.size(), std::size_t(fluid));
}

TEST(BlockMesh, our_own_look_has_the_tints_of_the_biome) {
  Scene scene(glm::ivec3(1));
  scene.set({0, 0, 0}, "grass_block");
  World world;
  world.environment.biome = "minecraft:swamp";
  const BiomeTints swamp = tintsOf(world, {});
  world.environment = {.biome = "minecraft:jungle", .temperature = 0.95f, .rainfall = 0.9f};
  const BiomeTints jungle = tintsOf(world, {});
  const auto topOf = [&](const BiomeTints* tints) {
    const std::vector<BlockFacts> facts = scene.facts();
    const LightLevels light(scene.blocks, facts);
    const BlockAtlas atlas = buildAtlas(texturesOf(facts));
    const ReadMesh mesh(buildMesh({scene.blocks, facts, light, atlas, 1, nullptr, tints}));
    glm::u8vec3 color(255);
    for (const BlockVertex& vertex : mesh.vertices)
      if (glm::u8vec3(vertex.tint) != glm::u8vec3(255)) color = glm::u8vec3(vertex.tint);
    return color;
  };
  EXPECT_EQ(topOf(nullptr), plainsTint(Tint::Grass));
  EXPECT_EQ(topOf(&swamp), glm::u8vec3(0x6a, 0x70, 0x39));
  EXPECT_GT(topOf(&jungle).g, 195) << "warm and wet";
  EXPECT_LT(topOf(&jungle).b, 70);
}

TEST(BlockMesh, block_entities_are_apart_from_the_terrain_one_state_a_draw) {
  Scene scene({5, 1, 1});
  scene.set({0, 0, 0}, "oak_sign");
  scene.set({1, 0, 0}, "chest[facing=north,waterlogged=true]");
  scene.set({2, 0, 0}, "stone");
  scene.set({3, 0, 0}, "oak_sign");
  scene.blocks.paletteIndex(blockState("water"));
  const ReadMesh mesh = scene.mesh();
  std::vector<std::pair<RenderLayer, std::string>> draws;
  for (const MeshSection& section : mesh.sections) {
    const std::uint16_t state = mesh.vertices[section.first].state;
    draws.emplace_back(section.layer, scene.blocks.palette()[state].name);
    if (section.layer != RenderLayer::BlockEntity) continue;
    EXPECT_EQ(section.state, state);
    for (std::uint32_t v = section.first; v < section.first + section.count; ++v)
      EXPECT_EQ(mesh.vertices[v].state, state);
  }
  const std::vector<std::pair<RenderLayer, std::string>> expected{
      {RenderLayer::Solid, "minecraft:stone"},
      {RenderLayer::BlockEntity, "minecraft:oak_sign"},
      {RenderLayer::BlockEntity, "minecraft:chest"},
      {RenderLayer::Translucent, "minecraft:water"}};
  EXPECT_EQ(draws, expected);
}

TEST(BlockMesh, grass_is_tinted_on_top_and_leaves_all_over) {
  Scene scene({3, 1, 1});
  scene.set({0, 0, 0}, "grass_block");
  scene.set({2, 0, 0}, "oak_leaves");
  const ReadMesh mesh = scene.mesh();
  for (const BlockVertex& vertex : mesh.vertices) {
    const glm::u8vec3 colour(vertex.tint);
    if (vertex.state == 2) {
      EXPECT_EQ(colour, glm::u8vec3(0x77, 0xAB, 0x2F));
    } else if (vertex.normal.y > 0) {
      EXPECT_EQ(colour, glm::u8vec3(0x91, 0xBD, 0x59));
    } else {
      EXPECT_EQ(colour, glm::u8vec3(255));
    }
  }
}

TEST(BlockMesh, corners_beside_a_wall_are_occluded_as_in_the_game) {
  Scene scene({3, 2, 3});
  scene.fill({0, 0, 0}, {2, 0, 2}, "stone");
  scene.set({0, 1, 1}, "stone");
  const ReadMesh mesh = scene.mesh();
  const auto occlusionAt = [](const ReadMesh& from, glm::vec3 at) {
    for (const Quad& quad : quadsFacing(from, {0, 1, 0})) {
      const bool middle = quad.v[0].position == glm::vec3(1, 1, 1);
      for (int i = 0; middle && i < 4; ++i) {
        if (quad.v[i].position == at) return int(quad.v[i].tint.a);
      }
    }
    return -1;
  };
  // One of the four cells is solid beside the wall: (3 * 1 + 0.2) / 4.
  EXPECT_EQ(occlusionAt(mesh, {1, 1, 1}), 204);
  EXPECT_EQ(occlusionAt(mesh, {2, 1, 1}), 255);
  EXPECT_EQ(occlusionAt(scene.mesh(0), {1, 1, 1}), 255) << "ambientOcclusionLevel 0";
  scene.set({1, 1, 0}, "stone");
  // Both sides are solid, so the open corner between counts as solid: (1 + 3 * 0.2) / 4.
  EXPECT_EQ(occlusionAt(scene.mesh(), {1, 1, 1}), 102);
}

TEST(BlockMesh, light_is_the_mean_of_the_four_cells_at_a_corner) {
  Scene scene({4, 3, 4});
  scene.fill({0, 0, 0}, {3, 0, 3}, "stone");
  scene.set({3, 2, 2}, "glowstone");
  const LightLevels light = scene.light();
  const ReadMesh mesh = scene.mesh();
  std::set<int> sums;
  for (const Quad& quad : quadsFacing(mesh, {0, 1, 0})) {
    if (quad.v[0].position != glm::vec3(1, 1, 1)) continue;
    EXPECT_EQ(quad.v[2].position, glm::vec3(2, 1, 2));
    for (const BlockVertex& vertex : quad.v) {
      const glm::ivec3 corner(vertex.position);
      int sum = 0;
      for (const glm::ivec3 step : {glm::ivec3(0), {1, 0, 0}, {0, 0, 1}, {1, 0, 1}})
        sum += light.block(corner - step);
      EXPECT_EQ(vertex.light.x, sum * 4);
      sums.insert(sum);
    }
  }
  EXPECT_GE(sums.size(), 3u) << "corners that differ";
}

TEST(BlockMesh, emitting_blocks_carry_their_level) {
  Scene scene({1, 1, 1});
  scene.set({0, 0, 0}, "glowstone");
  for (const BlockVertex& vertex : scene.mesh().vertices) EXPECT_EQ(vertex.midBlock.w, 15);
}

TEST(BlockMesh, unknown_blocks_warn_once_a_name) {
  Scene scene({1, 1, 1});
  scene.set({0, 0, 0}, "mod:thing[a=1]");
  scene.set({0, 0, 0}, "mod:thing[a=2]");
  Diagnostics diagnostics;
  factsOfPalette(BlockTable(), scene.blocks, diagnostics);
  EXPECT_EQ(joined(diagnostics),
            "warning: the block \"mod:thing\" is not known: drawn as a cube with the missing "
            "texture");
}

/// A box of many kinds of blocks at a place that is no multiple of 16.
Scene randomScene() {
  Scene scene({20, 20, 20}, {-7, 5, 11});
  const char* const states[] = {"air",
                                "air",
                                "air",
                                "stone",
                                "stone",
                                "glass",
                                "water",
                                "water[level=2]",
                                "lava",
                                "oak_stairs[facing=east,half=top]",
                                "stone_slab[type=bottom]",
                                "stone_slab[type=top]",
                                "poppy",
                                "oak_fence[east=true,waterlogged=true]",
                                "oak_leaves",
                                "glowstone",
                                "torch",
                                "lantern",
                                "red_stained_glass",
                                "glass_pane[north=true]",
                                "grass_block",
                                "mod:unknown"};
  std::mt19937 random(5);
  const glm::ivec3 low = scene.blocks.origin();
  for (int i = 0; i < 8000; ++i) {
    const glm::ivec3 p = low + glm::ivec3(i % 20, i / 400, i / 20 % 20);
    scene.set(p, states[random() % std::size(states)]);
  }
  return scene;
}

TEST(BlockMesh, every_quad_is_flat_counter_clockwise_and_has_a_tangent_frame) {
  const ReadMesh mesh = randomScene().mesh();
  ASSERT_GT(mesh.vertices.size(), 10000u);
  for (std::size_t i = 0; i < mesh.vertices.size(); i += 4) {
    const BlockVertex* v = &mesh.vertices[i];
    const glm::vec3 n = v[0].normal, t(v[0].tangent);
    for (const auto& [a, b, c] : {std::array{0, 1, 2}, std::array{2, 3, 0}}) {
      const glm::vec3 cross =
          glm::normalize(glm::cross(v[b].position - v[a].position, v[c].position - v[a].position));
      ASSERT_LT(glm::distance(cross, n), 1e-4f) << i;
    }
    ASSERT_NEAR(glm::length(t), 1, 1e-5);
    ASSERT_NEAR(glm::dot(t, n), 0, 1e-5);
    // The tangent follows u; cross(tangent, normal) * w follows v, as packs compute the bitangent.
    const glm::vec3 bitangent = glm::cross(t, n) * v[0].tangent.w;
    const glm::vec3 edge = v[2].position - v[0].position;
    const glm::vec2 step = v[2].uv - v[0].uv;
    ASSERT_GT(glm::dot(edge, t) * step.x, 0) << i;
    ASSERT_GT(glm::dot(edge, bitangent) * step.y, 0) << i;
  }
}

TEST(BlockMesh, position_plus_mid_block_is_the_middle_of_one_block) {
  const Scene scene = randomScene();
  const ReadMesh mesh = scene.mesh();
  for (const MeshSection& section : mesh.sections) {
    for (std::uint32_t i = 0; i < section.count; i += 4) {
      const BlockVertex* v = &mesh.vertices[section.first + i];
      glm::ivec3 cell(0);
      for (int k = 0; k < 4; ++k) {
        const glm::vec3 middle = v[k].position + glm::vec3(v[k].midBlock) / 64.0f;
        const glm::vec3 whole = glm::floor(middle);
        ASSERT_LT(glm::distance(middle, whole + 0.5f), 0.016f);
        if (k == 0) cell = glm::ivec3(whole);
        ASSERT_EQ(glm::ivec3(whole), cell);
      }
      const std::uint32_t index = scene.blocks.indexAt(section.origin + cell);
      ASSERT_TRUE(index == v[0].state || v[0].fluid == 1);
    }
  }
}

TEST(BlockMesh, no_face_lies_against_a_solid_cube) {
  const Scene scene = randomScene();
  const std::vector<BlockFacts> facts = scene.facts();
  const ReadMesh mesh = scene.mesh();
  for (const MeshSection& section : mesh.sections) {
    for (std::uint32_t i = 0; i < section.count; i += 4) {
      const BlockVertex* v = &mesh.vertices[section.first + i];
      const glm::vec3 middle = (v[0].position + v[2].position) * 0.5f;
      const glm::vec3 inFront = middle + v[0].normal * 0.01f;
      const glm::ivec3 cell = section.origin + glm::ivec3(glm::floor(inFront));
      ASSERT_FALSE(facts[scene.blocks.indexAt(cell)].fullOpaqueCube);
    }
  }
}

TEST(BlockMesh, sections_are_sorted_and_cover_the_vertices) {
  const ReadMesh mesh = randomScene().mesh();
  std::uint32_t next = 0;
  const auto key = [](const MeshSection& s) {
    return std::array{int(s.layer), s.origin.x, s.origin.y, s.origin.z};
  };
  for (std::size_t i = 0; i < mesh.sections.size(); ++i) {
    EXPECT_EQ(mesh.sections[i].first, next);
    EXPECT_GT(mesh.sections[i].count, 0u);
    next += mesh.sections[i].count;
    if (i == 0) continue;
    EXPECT_LT(key(mesh.sections[i - 1]), key(mesh.sections[i]));
  }
  EXPECT_EQ(next, mesh.vertices.size());
}

}  // namespace
}  // namespace orris
