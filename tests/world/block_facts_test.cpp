#include <orris/world/blocks/block_facts.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <set>

#include <orris/world/atlas/texture_canvas.h>
#include <orris/world/blocks/block_data.h>
#include <orris/world/blocks/block_state.h>
#include <orris/world/world.h>

namespace orris {
namespace {

const BlockTable& table() {
  static const BlockTable result;
  return result;
}

BlockFacts facts(const std::string& state) { return table().factsOf(*parseBlockState(state)); }

TEST(BlockFacts, unknown_block_is_a_visible_cube) {
  for (const char* name : {"minecraft:no_such_block", "othermod:stone"}) {
    const BlockFacts unknown = facts(name);
    EXPECT_FALSE(unknown.known);
    EXPECT_TRUE(unknown.fullOpaqueCube);
    EXPECT_EQ(unknown.opacity, 15);
    ASSERT_EQ(unknown.boxes.size(), 1u);
    for (const std::string& texture : unknown.boxes[0].textures) EXPECT_EQ(texture, "missing");
  }
}

TEST(BlockFacts, air_is_nothing) {
  for (const char* name : {"air", "cave_air", "void_air", "light[level=9]"}) {
    EXPECT_TRUE(facts(name).air) << name;
    EXPECT_TRUE(facts(name).boxes.empty()) << name;
    EXPECT_EQ(facts(name).opacity, 0) << name;
  }
}

TEST(BlockFacts, emission_is_that_of_the_game) {
  const std::map<std::string, int> kLevels{
      {"stone", 0},
      {"torch", 14},
      {"wall_torch[facing=north]", 14},
      {"soul_torch", 10},
      {"soul_wall_torch", 10},
      {"redstone_torch", 7},
      {"redstone_torch[lit=true]", 7},
      {"redstone_torch[lit=false]", 0},
      {"redstone_wall_torch[facing=east,lit=false]", 0},
      {"lantern[hanging=true]", 15},
      {"soul_lantern", 10},
      {"glowstone", 15},
      {"sea_lantern", 15},
      {"shroomlight", 15},
      {"jack_o_lantern[facing=north]", 15},
      {"end_rod", 14},
      {"crying_obsidian", 10},
      {"magma_block", 3},
      {"lava", 15},
      {"lava[level=3]", 15},
      {"fire", 15},
      {"soul_fire", 10},
      {"campfire", 15},
      {"campfire[lit=false]", 0},
      {"soul_campfire[lit=true]", 10},
      {"redstone_lamp", 0},
      {"redstone_lamp[lit=true]", 15},
      {"furnace[lit=true]", 13},
      {"furnace", 0},
      {"smoker[lit=true,facing=north]", 13},
      {"redstone_ore[lit=true]", 9},
      {"candle", 0},
      {"candle[candles=3]", 0},
      {"red_candle[candles=1,lit=true]", 3},
      {"red_candle[candles=4,lit=true]", 12},
      {"white_candle_cake[lit=true]", 3},
      {"sea_pickle[pickles=2]", 9},
      {"sea_pickle[pickles=4,waterlogged=true]", 15},
      {"sea_pickle[pickles=4,waterlogged=false]", 0},
      {"cave_vines[berries=true]", 14},
      {"cave_vines", 0},
      {"respawn_anchor[charges=2]", 7},
      {"ochre_froglight", 15},
      {"enchanting_table", 7},
      {"ender_chest", 7},
      {"brewing_stand", 1},
      {"glow_lichen[north=true]", 7},
      {"glow_lichen[north=false]", 0},
      {"beacon", 15},
      {"nether_portal", 11},
      {"copper_bulb[lit=true]", 15},
      {"waxed_oxidized_copper_bulb[lit=true]", 4},
      {"light", 15},
      {"light[level=6]", 6},
      {"amethyst_cluster", 5},
  };
  for (const auto& [state, level] : kLevels) {
    EXPECT_TRUE(facts(state).known) << state;
    EXPECT_EQ(facts(state).emission, level) << state;
  }
}

TEST(BlockFacts, opacity_layer_and_culling) {
  EXPECT_EQ(facts("stone").opacity, 15);
  EXPECT_TRUE(facts("stone").fullOpaqueCube);
  EXPECT_EQ(facts("oak_slab[type=double]").opacity, 15);
  EXPECT_EQ(facts("oak_slab[type=top]").opacity, 0);
  EXPECT_EQ(facts("glass").opacity, 0);
  EXPECT_EQ(facts("tinted_glass").opacity, 15);
  EXPECT_EQ(facts("water").opacity, 1);
  EXPECT_EQ(facts("oak_leaves").opacity, 1);
  EXPECT_EQ(facts("ice").opacity, 1);
  EXPECT_EQ(facts("oak_fence[waterlogged=false]").opacity, 0);
  EXPECT_EQ(facts("oak_fence[waterlogged=true]").opacity, 1);
  EXPECT_EQ(facts("red_shulker_box").opacity, 1);
  EXPECT_EQ(facts("glass").layer, RenderLayer::Cutout);
  EXPECT_EQ(facts("oak_leaves").layer, RenderLayer::Cutout);
  EXPECT_EQ(facts("poppy").layer, RenderLayer::Cutout);
  EXPECT_EQ(facts("red_stained_glass").layer, RenderLayer::Translucent);
  EXPECT_EQ(facts("red_stained_glass_pane").layer, RenderLayer::Translucent);
  EXPECT_EQ(facts("slime_block").layer, RenderLayer::Translucent);
  EXPECT_EQ(facts("water").layer, RenderLayer::Translucent);
  EXPECT_EQ(facts("lava").layer, RenderLayer::Solid);
  for (const char* name : {"glass", "red_stained_glass", "water", "ice", "lava"}) {
    EXPECT_TRUE(facts(name).cullsSame) << name;
    EXPECT_FALSE(facts(name).fullOpaqueCube) << name;
  }
  EXPECT_TRUE(facts("water").fluid);
  EXPECT_TRUE(facts("poppy").cross);
  EXPECT_FALSE(facts("oak_leaves").cullsSame);
}

TEST(BlockFacts, tint_reaches_the_grey_textures_only) {
  const BlockFacts grass = facts("grass_block");
  EXPECT_EQ(grass.tint, Tint::Grass);
  EXPECT_EQ(grass.boxes[0].tintedFaces, 1 << int(FaceDirection::Up));
  EXPECT_EQ(facts("oak_leaves").boxes[0].tintedFaces, 0x3f);
  EXPECT_EQ(facts("potted_fern").boxes[0].tintedFaces, 0) << "the pot";
  EXPECT_NE(facts("potted_fern").boxes[1].tintedFaces, 0) << "the fern";
  EXPECT_EQ(facts("cherry_leaves").tint, Tint::None);
  EXPECT_EQ(facts("water").tint, Tint::Water);
}

TEST(BlockFacts, waterlogged_by_property_or_by_nature) {
  EXPECT_TRUE(facts("oak_stairs[facing=north,waterlogged=true]").waterlogged);
  EXPECT_FALSE(facts("oak_stairs[facing=north,waterlogged=false]").waterlogged);
  EXPECT_TRUE(facts("kelp").waterlogged);
}

/// Every value that a definition, its shape and the directions give each property.
std::map<std::string, std::set<std::string>> propertyValues(const BlockDefinition& definition) {
  std::map<std::string, std::set<std::string>> values;
  const auto add = [&](const BlockCondition& condition) {
    for (const auto& [key, accepted] : condition.terms) {
      values[key].insert(accepted.begin(), accepted.end());
    }
  };
  std::set<std::string> shapes{definition.base.shape.value_or("cube")};
  for (const auto& [when, patch] : definition.variants) {
    add(when);
    if (patch.shape) shapes.insert(*patch.shape);
  }
  for (const auto& [key, value] : definition.defaults) values[key].insert(value);
  for (const std::string& name : shapes) {
    const ShapeTemplate& shape = blockData().shapes.at(name);
    if (shape.flip) add(*shape.flip);
    const std::set<std::string> turns{"north", "east", "south", "west", "up",
                                      "down",  "x",    "z",     "7",    "nonsense"};
    if (!shape.rotate.empty()) values[shape.rotate].insert(turns.begin(), turns.end());
    if (!shape.stand.empty()) values[shape.stand].insert(turns.begin(), turns.end());
    for (const ShapePart& part : shape.parts) {
      add(part.when);
      if (part.around.empty()) continue;
      for (const char* side : {"north", "south", "west", "east"}) {
        values[side].insert(part.around.begin(), part.around.end());
      }
    }
  }
  for (auto& [key, set] : values) set.insert("");
  return values;
}

/// Calls `visit` for each combination of the property values.
template <class Visit>
void forEachState(const std::string& name, const BlockDefinition& definition, Visit visit) {
  const auto values = propertyValues(definition);
  BlockState state{"minecraft:" + name, {}};
  std::vector<std::pair<std::string, std::vector<std::string>>> axes;
  size_t count = 1;
  for (const auto& [key, set] : values) {
    axes.emplace_back(key, std::vector<std::string>(set.begin(), set.end()));
    count *= set.size();
  }
  for (size_t i = 0; i < count; ++i) {
    state.properties.clear();
    size_t rest = i;
    for (const auto& [key, choices] : axes) {
      const std::string& value = choices[rest % choices.size()];
      rest /= choices.size();
      if (!value.empty()) state.properties[key] = value;
    }
    visit(state);
  }
}

TEST(BlockFacts, every_state_keeps_inside_its_cube_and_names_real_textures) {
  // Families share one definition but for their textures: one member of each stands for it.
  std::set<std::string> seen;
  size_t states = 0;
  for (const auto& [name, definition] : blockData().blocks) {
    std::string key = definition.base.shape.value_or("cube");
    for (const auto& [part, texture] : definition.base.textures) key += part;
    for (const auto& [when, patch] : definition.variants) {
      for (const auto& [property, accepted] : when.terms) key += property + accepted.front();
    }
    if (!seen.insert(key).second) continue;
    forEachState(name, definition, [&](const BlockState& state) {
      ++states;
      const BlockFacts result = table().factsOf(state);
      ASSERT_TRUE(result.known) << state.toString();
      ASSERT_TRUE(result.emission >= 0 && result.emission <= 15) << state.toString();
      for (const ShapeBox& box : result.boxes) {
        for (int axis = 0; axis < 3; ++axis) {
          ASSERT_GE(box.from[axis], 0) << state.toString();
          ASSERT_LE(box.from[axis], box.to[axis]) << state.toString();
          ASSERT_LE(box.to[axis], 16) << state.toString();
        }
        for (const std::string& texture : box.textures) {
          ASSERT_NE(texture, "missing") << state.toString();
        }
      }
    });
  }
  EXPECT_GT(states, 2000u);
}

TEST(BlockFacts, every_block_has_a_shape_in_its_default_state) {
  for (const auto& [name, definition] : blockData().blocks) {
    const BlockFacts result = facts(name);
    // These hang on their neighbours and are nothing without one.
    const std::string shape = definition.base.shape.value_or("cube");
    EXPECT_EQ(result.boxes.empty(), result.air || shape == "vine") << name;
  }
}

TEST(BlockFacts, solid_blocks_use_opaque_textures_only) {
  std::map<std::string, bool> opaque;
  for (const auto& [name, definition] : blockData().blocks) {
    const BlockFacts result = facts(name);
    if (result.layer != RenderLayer::Solid) continue;
    for (const ShapeBox& box : result.boxes) {
      for (const std::string& texture : box.textures) {
        if (texture.empty()) continue;
        const auto [entry, added] = opaque.try_emplace(texture, true);
        if (added) {
          for (const Texel& texel : drawTexture(texture).texels) {
            entry->second = entry->second && texel.colour.a == 1;
          }
        }
        EXPECT_TRUE(entry->second) << name << " " << texture;
      }
    }
  }
}

TEST(BlockFacts, crosses_and_leaves_have_holes) {
  for (const auto& [name, definition] : blockData().blocks) {
    const BlockFacts result = facts(name);
    const bool leaves = name.size() > 7 && name.ends_with("_leaves");
    if (result.boxes.empty() || !(result.cross || leaves || name == "glass")) continue;
    EXPECT_EQ(result.layer, RenderLayer::Cutout) << name;
    int holes = 0;
    for (const Texel& texel : drawTexture(result.boxes[0].textures[0]).texels) {
      EXPECT_TRUE(texel.colour.a == 0 || texel.colour.a == 1) << name;
      holes += texel.colour.a == 0;
    }
    EXPECT_GT(holes, 10) << name;
    EXPECT_LT(holes, 256) << name;
  }
}

TEST(BlockFacts, emitters_show_light_in_their_textures) {
  for (const char* state : {"torch", "lantern", "glowstone", "sea_lantern", "shroomlight", "lava",
                            "redstone_lamp[lit=true]", "jack_o_lantern", "furnace[lit=true]"}) {
    float brightest = 0;
    for (const ShapeBox& box : facts(state).boxes) {
      for (const std::string& texture : box.textures) {
        if (texture.empty()) continue;
        for (const Texel& texel : drawTexture(texture).texels) {
          brightest = std::max(brightest, texel.emission);
        }
      }
    }
    EXPECT_GT(brightest, 0.5f) << state;
  }
}

TEST(BlockFacts, knows_every_block_of_the_small_house) {
  const std::string path = ORRIS_SOURCE_DIR "/../shared/worlds/smallhouse1.schem";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no " << path;
  Diagnostics diagnostics;
  const auto world = loadWorld(path, 0, diagnostics);
  ASSERT_TRUE(world);
  EXPECT_GE(world->blocks.palette().size(), 173u);
  for (const BlockState& state : world->blocks.palette()) {
    EXPECT_TRUE(table().factsOf(state).known) << state.toString();
  }
}

}  // namespace
}  // namespace orris
