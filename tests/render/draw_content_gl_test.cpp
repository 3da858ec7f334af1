// What is drawn besides blocks, by which program, with which uniforms and state.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include <orris/render/frame_renderer.h>
#include "render/render_fixture.h"

namespace orris {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::FloatNear;
using ::testing::Not;

class DrawContentGL : public RenderTest {
 protected:
  /// A program whose colour is `color` wherever it draws.
  void paint(const std::string& name, const std::string& color, const std::string& more = "") {
    addProgram(name, more + "\nvoid main() { gl_FragData[0] = " + color + "; }\n");
  }

  /// Looks down on the floor of the world, from above the middle of its cell (0, 1, 0).
  bool startQuiet(const World& world) {
    files_["/shaders.properties"] += "sky=false\nstars=false\nsun=false\nmoon=false\nclouds=off\n";
    return start(world);
  }

  static World worldWith(Entity entity) {
    World world = floorWorld();
    if (entity.kind.empty()) entity.kind = "minecraft:slime";
    entity.model = entity.kind;
    entity.position = {0.5, 1, 0.5};
    world.content.entities = {entity};
    return world;
  }

  std::vector<float> middle() { return pixel("colortex0", 16, 16); }
  std::vector<std::string> stepNames() {
    std::vector<std::string> names;
    for (const Step& step : session_->renderer().schedule().frame) names.push_back(step.name);
    return names;
  }
};

TEST_F(DrawContentGL, an_entity_is_drawn_by_its_program_with_its_id_and_colour) {
  paint("gbuffers_textured", "vec4(0.0, 0.0, 0.25, 1.0)");
  paint("gbuffers_entities",
        "vec4(float(entityId) / 10.0, entityColor.r * entityColor.a, "
        "float(renderStage) / 20.0, 1.0)",
        "uniform int entityId; uniform vec4 entityColor; uniform int renderStage;");
  files_["/entity.properties"] = "entity.7=cow\n";
  Entity cow;
  cow.kind = "minecraft:cow";
  cow.hurt = true;
  ASSERT_TRUE(startQuiet(worldWith(cow))) << messages();
  draw();
  EXPECT_THAT(middle(), ElementsAre(FloatNear(0.7f, .01f), FloatNear(0.302f, .01f),
                                    FloatNear(11 / 20.0f, .01f), 1));
  EXPECT_THAT(pixel("colortex0", 2, 2), ElementsAre(0, 0, FloatNear(0.25f, .01f), 1));
}

TEST_F(DrawContentGL, an_entity_that_is_not_listed_has_the_id_65535) {
  paint("gbuffers_entities", "vec4(float(entityId) / 65535.0, 0.0, 0.0, 1.0)",
        "uniform int entityId;");
  files_["/entity.properties"] = "entity.7=pig\n";
  Entity cow;
  cow.kind = "minecraft:cow";
  ASSERT_TRUE(startQuiet(worldWith(cow))) << messages();
  draw();
  EXPECT_THAT(middle(), ElementsAre(FloatNear(1, .001f), 0, 0, 1));
}

TEST_F(DrawContentGL, what_is_hurt_has_its_row_of_the_overlay) {
  files_["/gbuffers_entities.vsh"] =
      "#version 330 compatibility\nin ivec2 vaUV1;\nflat out vec2 row;\nvoid main() { gl_Position = "
      "ftransform(); row = vec2(vaUV1); }\n";
  files_["/gbuffers_entities.fsh"] =
      "#version 330 compatibility\nflat in vec2 row;\nvoid main() { gl_FragData[0] = vec4(row / 10.0, "
      "0.0, 1.0); }\n";
  Entity cow;
  cow.kind = "minecraft:cow";
  for (const bool hurt : {true, false}) {
    cow.hurt = hurt;
    ASSERT_TRUE(startQuiet(worldWith(cow))) << messages();
    draw();
    EXPECT_THAT(middle(), ElementsAre(0, FloatNear(hurt ? 0.3f : 1, .01f), 0, 1));
  }
}

TEST_F(DrawContentGL, an_item_has_its_id) {
  paint("gbuffers_entities", "vec4(float(currentRenderedItemId) / 10.0, 0.5, 0.0, 1.0)",
        "uniform int currentRenderedItemId;");
  files_["/item.properties"] = "item.4=diamond_block\n";
  Entity item;
  item.kind = "minecraft:item";
  item.item = "minecraft:diamond_block";
  ASSERT_TRUE(startQuiet(worldWith(item))) << messages();
  draw();
  EXPECT_THAT(middle(), ElementsAre(FloatNear(0.4f, .01f), FloatNear(0.5f, .01f), 0, 1));
}

TEST_F(DrawContentGL, what_blends_is_added_to_what_is_behind_it) {
  paint("gbuffers_entities", "vec4(1.0, 0.0, 0.0, 1.0)");
  paint("gbuffers_entities_translucent", "vec4(0.0, 1.0, 0.0, 0.5)");
  ASSERT_TRUE(startQuiet(worldWith({}))) << messages();
  draw();
  EXPECT_THAT(middle(), ElementsAre(FloatNear(0.5f, .01f), FloatNear(0.5f, .01f), 0, 1));
}

TEST_F(DrawContentGL, the_glint_lies_on_the_armour_alone) {
  paint("gbuffers_textured", "vec4(0.0, 0.0, 0.0, 1.0)");
  paint("gbuffers_entities", "vec4(0.0, 0.25, 0.0, 1.0)");
  paint("gbuffers_armor_glint", "vec4(0.5, 0.0, 0.0, 1.0)");
  Entity stand;
  stand.kind = "minecraft:armor_stand";
  stand.armour = {"minecraft:iron_helmet", "minecraft:iron_chestplate"};
  stand.glint = true;
  ASSERT_TRUE(startQuiet(worldWith(stand))) << messages();
  draw();
  // SRC_COLOR, ONE: 0.5 * 0.5 is added.
  EXPECT_THAT(middle(), ElementsAre(FloatNear(0.25f, .01f), FloatNear(0.25f, .01f), 0, 1));
  EXPECT_THAT(pixel("colortex0", 2, 2), ElementsAre(0, 0, 0, 1));
}

TEST_F(DrawContentGL, the_hand_is_in_front_of_all_and_its_light_and_id_are_known) {
  paint("gbuffers_textured", "vec4(0.0, 0.0, 0.0, 1.0)");
  paint("gbuffers_hand",
        "vec4(float(heldItemId) / 10.0, float(heldBlockLightValue) / 15.0, "
        "float(renderStage) / 20.0, 1.0)",
        "uniform int heldItemId, heldBlockLightValue, renderStage;");
  files_["/item.properties"] = "item.6=glowstone\n";
  World world = floorWorld();
  world.environment.player.mainHand = "minecraft:glowstone";
  world.environment.player.hideGui = false;
  world.cameras[0].position.y = 1.3;  // the hand reaches below the floor
  ASSERT_TRUE(startQuiet(world)) << messages();
  draw();
  EXPECT_THAT(pixel("colortex0", 27, 26),
              ElementsAre(FloatNear(0.6f, .01f), FloatNear(1, .01f), FloatNear(0.8f, .01f), 1));
  EXPECT_THAT(pixel("colortex0", 4, 4), ElementsAre(0, 0, 0, 1));
}

TEST_F(DrawContentGL, the_light_of_one_hand_counts_for_the_other) {
  paint("gbuffers_hand", "vec4(float(heldBlockLightValue) / 15.0, float(heldBlockLightValue2) / 15.0, 0.0, 1.0)",
        "uniform int heldBlockLightValue, heldBlockLightValue2;");
  const auto light = [&](const std::string& properties) {
    files_["/shaders.properties"] = properties;
    World world = floorWorld();
    world.environment.player.mainHand = "minecraft:stone";
    world.environment.player.offHand = "minecraft:glowstone";
    world.environment.player.hideGui = false;
    world.cameras[0].position.y = 1.3;
    EXPECT_TRUE(startQuiet(world)) << messages();
    draw();
    return pixel("colortex0", 27, 26);
  };
  EXPECT_THAT(light(""), ElementsAre(FloatNear(1, .01f), FloatNear(1, .01f), 0, 1));
  EXPECT_THAT(light("oldHandLight=false\n"), ElementsAre(0, FloatNear(1, .01f), 0, 1));
}

TEST_F(DrawContentGL, the_depth_before_the_hand_knows_none) {
  paint("gbuffers_textured", "vec4(0.0, 0.0, 0.0, 1.0)");
  addProgram("deferred",
             "uniform sampler2D depthtex1, depthtex2;\nvoid main() { gl_FragData[0] = "
             "vec4(step(0.001, texture2D(depthtex2, uv).r - texture2D(depthtex1, uv).r)); }\n");
  World world = floorWorld();
  world.environment.player.mainHand = "minecraft:glowstone";
  world.environment.player.hideGui = false;
  ASSERT_TRUE(startQuiet(world)) << messages();
  draw();
  EXPECT_THAT(pixel("colortex0", 27, 26), ElementsAre(1, 1, 1, 1));
  EXPECT_THAT(pixel("colortex0", 4, 4), ElementsAre(0, 0, 0, 0));
}

TEST_F(DrawContentGL, an_entity_and_the_player_cast_shadows) {
  paint("gbuffers_textured", "vec4(0.0, 0.0, 0.0, 1.0)");
  addProgram("shadow", "void main() { gl_FragData[0] = vec4(0.0, 0.0, 1.0, 1.0); }\n");
  paint("shadow_entities", "vec4(1.0, 0.0, 0.0, 1.0)");
  addProgram("final",
             "const int shadowMapResolution = 64;\nconst float shadowDistance = 8.0;\n"
             "uniform sampler2D shadowcolor0;\n"
             "void main() { gl_FragColor = texture2D(shadowcolor0, uv); }\n");
  const auto redShare = [&] {
    const auto map = session_->renderer().dump("shadowcolor0");
    int red = 0;
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) red += map->at(x, y)[0] > 0.5f && map->at(x, y)[2] < 0.5f;
    return red;
  };
  ASSERT_TRUE(startQuiet(floorWorld())) << messages();
  draw();
  EXPECT_EQ(redShare(), 0);
  ASSERT_TRUE(start(worldWith({}))) << messages();
  draw();
  EXPECT_GT(redShare(), 0);
  World world = floorWorld();
  world.environment.player.body = true;
  ASSERT_TRUE(start(world)) << messages();
  draw();
  EXPECT_GT(redShare(), 0);
  EXPECT_THAT(stepNames(), Not(Contains("gbuffers_entities")));
}

TEST_F(DrawContentGL, entities_cast_shadows_as_far_as_the_pack_wants) {
  addProgram("shadow", "void main() { gl_FragData[0] = vec4(0.0, 0.0, 1.0, 1.0); }\n");
  paint("shadow_entities", "vec4(1.0, 0.0, 0.0, 1.0)");
  const auto castsBy = [&](const std::string& factor, const std::string& ofTerrain = "1.0",
                           const std::string& distance = "8.0") {
    addProgram("final", "const int shadowMapResolution = 64;\nconst float shadowDistance = " + distance +
                        ";\nconst float shadowDistanceRenderMul = " + ofTerrain + ";\n" + factor +
                        "uniform sampler2D shadowcolor0;\n"
                        "void main() { gl_FragColor = texture2D(shadowcolor0, uv); }\n");
    EXPECT_TRUE(start(worldWith({}))) << messages();  // the eye is 4.5 blocks above it
    draw();
    const auto map = session_->renderer().dump("shadowcolor0");
    int red = 0;
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) red += map->at(x, y)[0] > 0.5f && map->at(x, y)[2] < 0.5f;
    return red > 0;
  };
  EXPECT_TRUE(castsBy(""));
  EXPECT_TRUE(castsBy("const float entityShadowDistanceMul = 0.75;\n"));
  EXPECT_FALSE(castsBy("const float entityShadowDistanceMul = 0.25;\n"));
  EXPECT_FALSE(castsBy("const float entityShadowDistanceMul = 0.75;\n", "0.25")) << "both count";
  EXPECT_TRUE(castsBy("", "1.0", "3.5")) << "wherever the map has them";
}

TEST_F(DrawContentGL, rain_writes_depth_only_where_the_pack_wants_it) {
  paint("gbuffers_textured", "vec4(0.0, 0.0, 0.0, 1.0)");
  paint("gbuffers_weather", "vec4(1.0, 0.0, 0.0, 1.0)");
  World world = floorWorld();
  world.environment.rain = 1;
  world.cameras[0].pitch = 0;
  const auto depthOfSky = [&](const std::string& properties) {
    files_["/shaders.properties"] = properties;
    EXPECT_TRUE(startQuiet(world)) << messages();
    draw();
    float least = 1;
    for (int x = 0; x < 32; ++x) least = std::min(least, pixel("depthtex0", x, 4)[0]);
    return least;
  };
  EXPECT_EQ(depthOfSky(""), 1);
  EXPECT_LT(depthOfSky("rain.depth=true\n"), 1);
  EXPECT_EQ(depthOfSky("rain.depth=true\nweather=false\n"), 1);
}

TEST_F(DrawContentGL, a_beam_writes_depth_where_the_pack_wants_it) {
  addProgram("gbuffers_beaconbeam", "void main() { gl_FragData[0] = vec4(1.0); }\n");
  World world = floorWorld();
  world.content.beams = {{{0, 0, 0}, glm::vec3(1)}};
  world.cameras[0].position = {0.5, 2, 4};
  world.cameras[0].pitch = 0;
  world.cameras[0].yaw = 180;
  // The glow is a little nearer than the core.
  const auto nearest = [&](const std::string& properties) {
    files_["/shaders.properties"] = properties;
    EXPECT_TRUE(startQuiet(world)) << messages();
    draw();
    return pixel("depthtex0", 16, 4)[0];
  };
  const float core = nearest(""), glow = nearest("beacon.beam.depth=true\n");
  EXPECT_LT(core, 1);
  EXPECT_LT(glow, core);
}

TEST_F(DrawContentGL, the_selected_block_is_known) {
  addProgram("final",
             "uniform int currentSelectedBlockId;\nuniform vec3 currentSelectedBlockPos;\n"
             "void main() { gl_FragColor = vec4(float(currentSelectedBlockId) / 10.0, "
             "-currentSelectedBlockPos.y / 10.0, 0.0, 1.0); }\n");
  files_["/block.properties"] = "block.5=stone\n";
  World world = floorWorld();
  world.content.selected = glm::ivec3(0, 0, 0);
  ASSERT_TRUE(startQuiet(world)) << messages();
  draw();
  const ImageF screen = session_->renderer().screenshotLinear();
  const float id = std::pow(0.5f, 2.2f);
  EXPECT_NEAR(screen.at(5, 5)[0], id, 0.02f);
  EXPECT_NEAR(screen.at(5, 5)[1], id, 0.02f);  // the eye is 5 blocks above its middle
}

TEST_F(DrawContentGL, rain_that_begins_brings_its_step) {
  paint("gbuffers_weather", "vec4(1.0, 0.0, 0.0, 1.0)");
  ASSERT_TRUE(startQuiet(floorWorld())) << messages();
  draw();
  EXPECT_THAT(stepNames(), Not(Contains("gbuffers_weather")));
  session_->environment().rain = 1;
  draw();
  EXPECT_THAT(stepNames(), Contains("gbuffers_weather"));
  session_->environment().rain = 0;
  draw();
  EXPECT_THAT(stepNames(), Not(Contains("gbuffers_weather")));
}

TEST_F(DrawContentGL, events_move_entities_and_lightning_passes) {
  paint("gbuffers_textured", "vec4(0.0, 0.0, 0.0, 1.0)");
  paint("gbuffers_entities", "vec4(1.0, 0.0, 0.0, 1.0)");
  addProgram("final",
             "uniform vec4 lightningBoltPosition;\nuniform sampler2D colortex0;\n"
             "void main() { gl_FragColor = vec4(texture2D(colortex0, uv).r, "
             "lightningBoltPosition.w, lightningBoltPosition.x / 8.0, 1.0); }\n");
  Entity slime;
  slime.name = "slime";
  World world = worldWith(slime);
  world.events = {{1, ChangeEntity{"slime", glm::dvec3(4.5, 1, 0.5), {}, {}, {}}},
                  {1, StrikeLightning{{4.5, 1, 0.5}, 2}}};
  ASSERT_TRUE(startQuiet(world)) << messages();
  const auto screen = [&] {
    const ImageF image = session_->renderer().screenshotLinear();
    return std::array{image.at(16, 16)[0] > 0.5f, image.at(16, 16)[1] > 0.5f};
  };
  draw();
  EXPECT_EQ(screen(), (std::array{true, false}));
  draw();
  EXPECT_EQ(screen(), (std::array{false, true}));
  draw(2);
  EXPECT_EQ(screen(), (std::array{false, false}));
}

TEST_F(DrawContentGL, no_program_is_built_for_what_the_world_lacks) {
  const std::vector<std::string> names = {"gbuffers_entities",
                                          "gbuffers_entities_translucent",
                                          "gbuffers_spidereyes",
                                          "gbuffers_armor_glint",
                                          "gbuffers_lightning",
                                          "gbuffers_block_translucent",
                                          "gbuffers_beaconbeam",
                                          "gbuffers_damagedblock",
                                          "gbuffers_line",
                                          "gbuffers_particles",
                                          "gbuffers_particles_translucent",
                                          "gbuffers_hand",
                                          "gbuffers_hand_water",
                                          "gbuffers_weather"};
  for (std::size_t i = 0; i < names.size(); ++i)
    paint(names[i], "vec4(" + std::to_string(i) + ".0 / 16.0)");
  ASSERT_TRUE(startQuiet(floorWorld())) << messages();
  EXPECT_THAT(session_->reloads().front().report.built, ElementsAre("built-in terrain"));
  Diagnostics diagnostics;
  auto world = loadWorld(std::string(ORRIS_SOURCE_DIR) + "/worlds/everything", 0, diagnostics);
  ASSERT_TRUE(world);
  ASSERT_TRUE(start(std::move(*world))) << messages();
  draw();
  for (const std::string& name : names) {
    EXPECT_THAT(session_->reloads().front().report.built, Contains(name));
    EXPECT_THAT(stepNames(), Contains(name));
  }
}

}  // namespace
}  // namespace orris
