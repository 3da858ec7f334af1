#include <cmath>
#include <set>

#include "api/api_fixture.h"

namespace orris_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

class RendererApi : public ApiTest {
 protected:
  const std::string world_ = std::string(ORRIS_SOURCE_DIR) + "/worlds/lamps";
  OrrisRenderer* ofWorld() { return make(request(testPack(), world_.c_str())); }
};

TEST_F(RendererApi, library_and_header_agree) {
  EXPECT_EQ(orris_api_version(), std::uint32_t{ORRIS_API_VERSION});
  EXPECT_STREQ(orris_status_name(ORRIS_ERROR_ORDER), "ORRIS_ERROR_ORDER");
  EXPECT_STREQ(orris_status_name(static_cast<OrrisStatus>(99)), "unknown");
}

TEST_F(RendererApi, facts_are_those_of_the_driver) {
  OrrisContextFacts facts;
  facts.struct_size = sizeof(facts);
  ASSERT_EQ(orris_context_facts(context_, &facts), ORRIS_OK);
  EXPECT_GE(facts.gl_version, 430);
  EXPECT_GE(facts.max_texture_units, 32);
  EXPECT_STRNE(facts.renderer, "");
  EXPECT_THAT(facts.backend, testing::AnyOf(testing::StrEq("osmesa"), testing::StrEq("egl")));
}

TEST_F(RendererApi, a_world_of_orris_is_drawn) {
  OrrisRenderer* renderer = ofWorld();
  const auto pixels = drawn(renderer);
  std::set<Rgb> colors;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) colors.insert(at(pixels, x, y));
  EXPECT_GT(colors.size(), 50u);
  EXPECT_EQ(pixels[3], 255);
}

TEST_F(RendererApi, angles_direction_and_matrices_of_one_camera_give_one_picture) {
  OrrisRenderer* renderer = ofWorld();
  OrrisFrame frame = frameOf(renderer);
  frame.camera.yaw = 180;  // looks north, along -z
  frame.camera.pitch = 0;
  frame.camera.fov = 70;
  ASSERT_EQ(orris_renderer_draw_frame(renderer, &frame), ORRIS_OK);
  const auto byAngles = read(renderer);
  frame.camera.mode = ORRIS_CAMERA_DIRECTION;
  frame.camera.direction[0] = frame.camera.direction[1] = 0;
  frame.camera.direction[2] = -3;
  ASSERT_EQ(orris_renderer_draw_frame(renderer, &frame), ORRIS_OK);
  EXPECT_EQ(read(renderer), byAngles);
  frame.camera.mode = ORRIS_CAMERA_MATRICES;
  const float nearPlane = 0.05f, farPlane = 4.0f * static_cast<float>(frame.render_distance);
  const float focal = 1.0f / std::tan(35.0f * 3.14159265f / 180);
  const float projection[16] = {focal * kHeight / kWidth,
                                0,
                                0,
                                0,
                                0,
                                focal,
                                0,
                                0,
                                0,
                                0,
                                -(farPlane + nearPlane) / (farPlane - nearPlane),
                                -1,
                                0,
                                0,
                                -2 * farPlane * nearPlane / (farPlane - nearPlane),
                                0};
  std::copy_n(projection, 16, frame.camera.projection);
  for (int i = 0; i < 16; ++i) frame.camera.view[i] = i % 5 == 0 ? 1.0f : 0.0f;  // -z is north
  ASSERT_EQ(orris_renderer_draw_frame(renderer, &frame), ORRIS_OK);
  const auto byMatrices = read(renderer);
  int different = 0;
  for (std::size_t i = 0; i < byMatrices.size(); ++i)
    different += std::abs(byMatrices[i] - byAngles[i]) > 2;
  EXPECT_LT(different, 12) << "but for texels that rounding moves";
}

TEST_F(RendererApi, uniforms_of_the_player_reach_the_pack) {
  OrrisRenderer* renderer = make(request(testPack()));
  OrrisFrame frame = frameOf(renderer);
  for (float& part : frame.fog_color) part = 0;  // the background
  ASSERT_EQ(orris_renderer_draw_frame(renderer, &frame), ORRIS_OK);
  EXPECT_EQ(at(read(renderer), 5, 5), (Rgb{0, 0, 0}));
  frame.main_hand = "minecraft:torch";
  frame.eye_fluid = 1;
  frame.selected_block = "minecraft:gold_block";
  frame.selected_position[2] = frame.camera.position[2] - 6;
  ASSERT_EQ(orris_renderer_draw_frame(renderer, &frame), ORRIS_OK) << orris_last_error();
  EXPECT_EQ(at(read(renderer), 5, 5), (Rgb{153, 255, 255}));
  const OrrisFrame kept = frameOf(renderer);
  EXPECT_STREQ(kept.main_hand, "minecraft:torch");
  EXPECT_STREQ(kept.selected_block, "minecraft:gold_block");
  ASSERT_EQ(orris_renderer_draw_frame(renderer, &kept), ORRIS_OK);
  EXPECT_EQ(at(read(renderer), 5, 5), (Rgb{153, 255, 255}));
  frame.lightning = 1;
  frame.lightning_position[1] = frame.camera.position[1] + 4;
  ASSERT_EQ(orris_renderer_draw_frame(renderer, &frame), ORRIS_OK);
  EXPECT_EQ(at(read(renderer), 5, 5), (Rgb{102, 102, 102}));
}

TEST_F(RendererApi, what_orris_cannot_know_is_stated) {
  OrrisRenderer* renderer = make(request(testPack()));
  const float health = 0.4f, much = 2;
  ASSERT_EQ(orris_renderer_set_uniform(renderer, "currentPlayerHealth", &health, 1), ORRIS_OK);
  EXPECT_EQ(at(drawn(renderer), 5, 5), (Rgb{102, 102, 102}));
  EXPECT_EQ(orris_renderer_set_uniform(renderer, "currentPlayerHealth", &much, 1), ORRIS_ERROR_ARGUMENT);
  EXPECT_EQ(orris_renderer_set_uniform(renderer, "currentTime", &health, 1), ORRIS_ERROR_ARGUMENT);
  EXPECT_EQ(orris_renderer_set_uniform(renderer, "sunAngle", &health, 1), ORRIS_ERROR_NOT_FOUND);
  OrrisFrame frame = frameOf(renderer);
  ASSERT_EQ(orris_renderer_draw_frame(renderer, &frame), ORRIS_OK);
  EXPECT_EQ(at(read(renderer), 5, 5), (Rgb{102, 102, 102})) << "until something else is stated";
}

TEST_F(RendererApi, options_are_read_and_set) {
  OrrisRenderer* renderer = make(request(testPack()));
  std::uint32_t count = 0;
  ASSERT_EQ(orris_renderer_option_count(renderer, &count), ORRIS_OK);
  ASSERT_EQ(count, 2u);
  OrrisOption option;
  option.struct_size = sizeof(option);
  ASSERT_EQ(orris_renderer_option(renderer, 0, &option), ORRIS_OK);
  EXPECT_STREQ(option.name, "BRIGHTNESS");
  EXPECT_STREQ(option.value, "1.0");
  EXPECT_EQ(option.value_count, 2u);
  const char* value = nullptr;
  ASSERT_EQ(orris_renderer_option_value(renderer, 0, 0, &value), ORRIS_OK);
  EXPECT_STREQ(value, "0.5");
  const Rgb bright = at(drawn(renderer), 5, 5);
  ASSERT_EQ(orris_renderer_set_option(renderer, "BRIGHTNESS", value), ORRIS_OK)
      << orris_last_error();
  EXPECT_NEAR(at(drawn(renderer), 5, 5)[2], bright[2] / 2, 1);
  ASSERT_EQ(orris_renderer_option(renderer, 0, &option), ORRIS_OK);
  EXPECT_STREQ(option.value, "0.5");
  EXPECT_STREQ(option.default_value, "1.0");
  EXPECT_EQ(orris_renderer_option(renderer, 2, &option), ORRIS_ERROR_NOT_FOUND);
  EXPECT_EQ(orris_renderer_option_value(renderer, 0, 2, &value), ORRIS_ERROR_NOT_FOUND);
}

TEST_F(RendererApi, options_that_are_none_are_refused_with_what_there_is) {
  OrrisRenderer* renderer = make(request(testPack()));
  EXPECT_EQ(orris_renderer_set_option(renderer, "BRIGHTNES", "1.0"), ORRIS_ERROR_NOT_FOUND);
  EXPECT_THAT(orris_last_error(), HasSubstr("BRIGHTNESS"));
  EXPECT_EQ(orris_renderer_set_option(renderer, "BRIGHTNESS", "2.0"), ORRIS_ERROR_ARGUMENT);
  EXPECT_THAT(orris_last_error(), HasSubstr("0.5, 1.0"));
}

TEST_F(RendererApi, profiles_are_read_and_set) {
  OrrisRenderer* renderer = make(request(testPack()));
  std::uint32_t count = 0;
  ASSERT_EQ(orris_renderer_profile_count(renderer, &count), ORRIS_OK);
  EXPECT_EQ(count, 2u);
  const char* name = nullptr;
  ASSERT_EQ(orris_renderer_profile(renderer, &name), ORRIS_OK);
  EXPECT_STREQ(name, "FULL");
  ASSERT_EQ(orris_renderer_set_profile(renderer, "DIM"), ORRIS_OK) << orris_last_error();
  ASSERT_EQ(orris_renderer_profile(renderer, &name), ORRIS_OK);
  EXPECT_STREQ(name, "DIM");
  EXPECT_EQ(orris_renderer_set_profile(renderer, "ULTRA"), ORRIS_ERROR_NOT_FOUND);
}

TEST_F(RendererApi, options_of_the_request_are_in_force_from_the_start) {
  OrrisRendererRequest asked = request(testPack());
  const char* lines[] = {"BRIGHTNESS=0.5"};
  asked.options = lines;
  asked.option_count = 1;
  const char* name = nullptr;
  ASSERT_EQ(orris_renderer_profile(make(asked), &name), ORRIS_OK);
  EXPECT_STREQ(name, "DIM");
  const char* broken[] = {"BRIGHTNESS"};
  asked.options = broken;
  OrrisRenderer* none = nullptr;
  EXPECT_EQ(orris_renderer_create(context_, &asked, &none), ORRIS_ERROR_ARGUMENT);
}

TEST_F(RendererApi, a_new_size_is_a_new_picture) {
  OrrisRenderer* renderer = ofWorld();
  drawn(renderer);
  ASSERT_EQ(orris_renderer_resize(renderer, 32, 16), ORRIS_OK);
  unsigned char pixels[32 * 16 * 4];
  EXPECT_EQ(orris_renderer_read(renderer, pixels, sizeof(pixels)), ORRIS_ERROR_ORDER);
  ASSERT_EQ(orris_renderer_draw_frame(renderer, nullptr), ORRIS_OK);
  EXPECT_EQ(orris_renderer_read(renderer, pixels, sizeof(pixels)), ORRIS_OK);
  EXPECT_EQ(orris_renderer_resize(renderer, 0, 16), ORRIS_ERROR_ARGUMENT);
  EXPECT_EQ(orris_renderer_resize(renderer, 32, 100000), ORRIS_ERROR_ARGUMENT);
}

TEST_F(RendererApi, another_dimension_and_reload_keep_drawing) {
  OrrisRenderer* renderer = ofWorld();
  EXPECT_EQ(orris_renderer_set_dimension(renderer, "minecraft:the_nether"), ORRIS_OK);
  EXPECT_EQ(orris_renderer_reload(renderer), ORRIS_OK);
  drawn(renderer);
}

TEST_F(RendererApi, problems_of_a_pack_come_to_the_callback_with_their_place) {
  OrrisRenderer* renderer = nullptr;
  const OrrisRendererRequest asked = request(testPack("blend-bad"));
  EXPECT_EQ(orris_renderer_create(context_, &asked, &renderer), ORRIS_ERROR_PACK);
  EXPECT_EQ(renderer, nullptr);
  ASSERT_FALSE(messages_.empty());
  const Message& first = messages_.front();
  EXPECT_EQ(first.severity, ORRIS_ERROR);
  EXPECT_EQ(first.file, "/shaders.properties");
  EXPECT_EQ(first.line, 1);
  EXPECT_EQ(first.column, 58);
  EXPECT_EQ(first.hint, "did you mean ONE_MINUS_SRC_ALPHA?");
  EXPECT_THAT(first.text, StartsWith("/shaders.properties:1:58: error: "));
  EXPECT_THAT(orris_last_error(), HasSubstr("is no blend factor"));
}

TEST_F(RendererApi, a_pack_or_a_world_that_is_not_there_is_an_error_in_words) {
  OrrisRenderer* renderer = nullptr;
  OrrisRendererRequest asked = request("/nowhere/pack.zip");
  EXPECT_EQ(orris_renderer_create(context_, &asked, &renderer), ORRIS_ERROR_PACK);
  EXPECT_THAT(orris_last_error(), HasSubstr("/nowhere/pack.zip"));
  asked = request(testPack(), "/nowhere/world");
  EXPECT_EQ(orris_renderer_create(context_, &asked, &renderer), ORRIS_ERROR_WORLD);
  EXPECT_THAT(orris_last_error(), HasSubstr("/nowhere/world"));
}

TEST_F(RendererApi, two_renderers_do_not_disturb_each_other) {
  OrrisRenderer *one = ofWorld(), *other = make(request(testPack()));
  const auto first = drawn(one), second = drawn(other);
  ASSERT_EQ(orris_renderer_set_option(other, "BRIGHTNESS", "0.5"), ORRIS_OK);
  drawn(other);
  EXPECT_EQ(drawn(one), first);
  EXPECT_NE(first, second);
}

TEST_F(RendererApi, two_contexts_take_turns) {
  OrrisContext* other = nullptr;
  ASSERT_EQ(orris_context_create("egl", &other), ORRIS_OK) << orris_last_error();
  OrrisRenderer *here = make(request(testPack())), *there = nullptr;
  const OrrisRendererRequest asked = request(testPack());
  ASSERT_EQ(orris_renderer_create(other, &asked, &there), ORRIS_OK) << orris_last_error();
  for (int i = 0; i < 2; ++i) EXPECT_EQ(drawn(here), drawn(there));
  EXPECT_EQ(orris_context_destroy(other), ORRIS_ERROR_ORDER) << "a renderer lives";
  EXPECT_EQ(orris_renderer_destroy(there), ORRIS_OK);
  EXPECT_EQ(orris_context_destroy(other), ORRIS_OK);
  drawn(here);
}

TEST_F(RendererApi, textures_of_the_frame_have_names) {
  OrrisRenderer* renderer = make(request(testPack()));
  std::uint32_t texture = 0;
  EXPECT_EQ(orris_renderer_texture(renderer, "screen", &texture), ORRIS_ERROR_ORDER);
  drawn(renderer);
  EXPECT_EQ(orris_renderer_texture(renderer, "colortex0", &texture), ORRIS_OK);
  EXPECT_NE(texture, 0u);
  EXPECT_EQ(orris_renderer_texture(renderer, "colortex99", &texture), ORRIS_ERROR_NOT_FOUND);
  EXPECT_THAT(orris_last_error(), HasSubstr("colortex0"));
}

}  // namespace
}  // namespace orris_test
