#include <orris/plan/frame/fog.h>

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include <orris/plan/frame/core_profile_uniforms.h>
#include <orris/plan/frame/uniforms.h>

namespace orris {
namespace {

constexpr int kSkyStage = 1, kStarsStage = 6, kTerrainStage = 8;

struct Fog : testing::Test {
  Fog() { state_.environment.renderDistance = 128; }
  float value(const char* name, int stage = kTerrainStage) const {
    DrawState draw;
    draw.renderStage = stage;
    const UniformRow* row = findUniform(name) != nullptr ? findUniform(name) : findCoreUniform(name);
    return row->value(state_, draw).f[0];
  }
  void expectRange(float start, float end, int stage = kTerrainStage) const {
    for (const std::string prefix : {"fog", "iris_Fog"}) {
      EXPECT_FLOAT_EQ(value((prefix + "Start").c_str(), stage), start) << prefix;
      EXPECT_FLOAT_EQ(value((prefix + "End").c_str(), stage), end) << prefix;
    }
  }

  FrameState state_;
};

TEST_F(Fog, lies_before_the_end_of_the_terrain) {
  expectRange(115.2f, 128);
  state_.environment.renderDistance = 1024;
  expectRange(960, 1024);
}

TEST_F(Fog, of_the_sky_begins_at_the_eye_and_stars_have_none) {
  expectRange(0, 128, kSkyStage);
  expectRange(std::numeric_limits<float>::max(), 128, kStarsStage);
}

TEST_F(Fog, is_near_in_fluids) {
  state_.isEyeInWater = 1;
  expectRange(-8, 96);
  expectRange(-8, 96, kSkyStage);
  state_.environment.biome = "minecraft:mangrove_swamp";
  expectRange(-8, 81.6f);
  state_.environment.renderDistance = 64;
  expectRange(-8, 64);
  state_.isEyeInWater = 2;
  expectRange(0.25f, 1);
  state_.isEyeInWater = 3;
  expectRange(0, 2);
}

TEST_F(Fog, is_near_in_the_nether_and_where_the_world_says_so) {
  state_.environment.dimension = "minecraft:the_nether";
  expectRange(6.4f, 64);
  state_.environment.dimension = "minecraft:overworld";
  state_.environment.stated["heavyFog"] = {1, 0, 0};
  expectRange(6.4f, 64, kSkyStage);
}

TEST_F(Fog, closes_in_with_blindness_and_darkness) {
  state_.environment.player.darkness = 1;
  expectRange(11.25f, 15);
  expectRange(0, 15, kSkyStage);
  state_.environment.player.blindness = 1;
  expectRange(1.25f, 5);
  expectRange(0, 4, kSkyStage);
  state_.environment.player.blindness = 0.5f;
  expectRange(66.5f / 4, 66.5f);
}

TEST_F(Fog, is_exponential_in_water) {
  const auto mode = [&] { return findUniform("fogMode")->value(state_, DrawState()).i[0]; };
  EXPECT_EQ(value("fogDensity"), 0.0f);
  EXPECT_EQ(mode(), 9729);
  state_.isEyeInWater = 1;
  EXPECT_EQ(value("fogDensity"), 0.02f);
  EXPECT_EQ(mode(), 2049);
  state_.isEyeInWater = 2;
  EXPECT_EQ(value("fogDensity"), 0.0f);
}

TEST_F(Fog, that_is_near_is_a_sphere) {
  DrawState draw;
  const auto shape = [&] { return findUniform("fogShape")->value(state_, draw).i[0]; };
  EXPECT_EQ(shape(), 1);
  state_.isEyeInWater = 1;
  EXPECT_EQ(shape(), 0);
  state_ = {};
  state_.environment.player.blindness = 0.5f;
  EXPECT_EQ(shape(), 0);
  state_ = {};
  state_.environment.dimension = "minecraft:the_nether";
  EXPECT_EQ(shape(), 0);
  state_ = {};
  state_.environment.stated["heavyFog"] = {1, 0, 0};
  EXPECT_EQ(shape(), 0);
  draw.fullscreen = true;
  EXPECT_EQ(shape(), -1);
}

void expectColor(const glm::vec3& color, const glm::vec3& expected) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(color[i], expected[i], 1e-3f) << i;
}

TEST_F(Fog, has_the_colour_of_what_the_eye_is_in) {
  state_.environment.fogColor = {0.7f, 0.8f, 0.9f};
  expectColor(fogColorOf(state_), {0.7f, 0.8f, 0.9f});
  state_.isEyeInWater = 1;
  expectColor(fogColorOf(state_), {5 / 51.0f, 5 / 51.0f, 1});
  state_.environment.biome = "minecraft:warm_ocean";
  expectColor(fogColorOf(state_), {4 / 51.0f, 31 / 51.0f, 1});
  state_.isEyeInWater = 2;
  expectColor(fogColorOf(state_), {0.6f, 0.1f, 0});
  state_.isEyeInWater = 3;
  expectColor(fogColorOf(state_), {0.623f, 0.734f, 0.785f});
}

TEST_F(Fog, darkens_and_brightens_with_effects) {
  state_.environment.fogColor = {0.2f, 0.1f, 0.4f};
  Player& player = state_.environment.player;
  player.nightVision = 1;
  expectColor(fogColorOf(state_), {0.5f, 0.25f, 1});
  player.nightVision = 0.5f;
  expectColor(fogColorOf(state_), {0.35f, 0.175f, 0.7f});
  player.darkness = 0.5f;
  expectColor(fogColorOf(state_), {0.05f, 0.025f, 0.1f});
  player.blindness = 1;
  expectColor(fogColorOf(state_), {0, 0, 0});
}

TEST_F(Fog, of_a_frame_is_that_of_its_eye) {
  FrameInput input;
  input.environment.time = 6000;
  expectColor(nextFrameState(input, {}, nullptr).environment.fogColor, input.environment.fogColor);
  input.eye.fluid = 1;
  const FrameState below = nextFrameState(input, {}, nullptr);
  expectColor(below.environment.fogColor, {5 / 51.0f, 5 / 51.0f, 1});
  expectColor(nextFrameState(input, {}, &below).environment.fogColor, {5 / 51.0f, 5 / 51.0f, 1});
}

}  // namespace
}  // namespace orris
