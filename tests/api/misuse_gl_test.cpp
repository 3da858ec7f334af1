// Wrong calls: each gives a status, and the next right call works.
#include <cmath>
#include <limits>

#include "api/api_fixture.h"

namespace orris_test {
namespace {

using testing::HasSubstr;

class Misuse : public ApiTest {};

TEST_F(Misuse, null_handles_are_refused_everywhere) {
  OrrisFrame frame;
  OrrisOption option{};
  option.struct_size = sizeof(option);
  OrrisContextFacts facts{};
  facts.struct_size = sizeof(facts);
  const char* text = nullptr;
  std::uint32_t number = 0;
  unsigned char pixel[4];
  const OrrisStatus all[] = {orris_context_facts(nullptr, &facts),
                             orris_context_destroy(nullptr),
                             orris_renderer_destroy(nullptr),
                             orris_renderer_reload(nullptr),
                             orris_renderer_resize(nullptr, 1, 1),
                             orris_renderer_set_dimension(nullptr, "minecraft:the_end"),
                             orris_renderer_option_count(nullptr, &number),
                             orris_renderer_option(nullptr, 0, &option),
                             orris_renderer_option_value(nullptr, 0, 0, &text),
                             orris_renderer_set_option(nullptr, "A", "B"),
                             orris_renderer_profile_count(nullptr, &number),
                             orris_renderer_profile_name(nullptr, 0, &text),
                             orris_renderer_profile(nullptr, &text),
                             orris_renderer_set_profile(nullptr, "A"),
                             orris_renderer_frame_init(nullptr, &frame, sizeof(frame)),
                             orris_renderer_draw_frame(nullptr, nullptr),
                             orris_renderer_output(nullptr, 0, 0, 0, 1, 1),
                             orris_renderer_read(nullptr, pixel, 4),
                             orris_renderer_texture(nullptr, "screen", &number)};
  for (const OrrisStatus status : all) EXPECT_EQ(status, ORRIS_ERROR_HANDLE);
  EXPECT_THAT(orris_last_error(), HasSubstr("OrrisRenderer"));
}

TEST_F(Misuse, handles_of_another_kind_or_destroyed_are_refused) {
  EXPECT_EQ(orris_renderer_reload(reinterpret_cast<OrrisRenderer*>(context_)), ORRIS_ERROR_HANDLE);
  OrrisRenderer* renderer = make(request(testPack()));
  forget(renderer);
  EXPECT_EQ(orris_context_destroy(reinterpret_cast<OrrisContext*>(renderer)), ORRIS_ERROR_HANDLE);
  EXPECT_EQ(orris_context_destroy(context_), ORRIS_ERROR_ORDER);
  EXPECT_EQ(orris_renderer_destroy(renderer), ORRIS_OK);
  EXPECT_EQ(orris_renderer_destroy(renderer), ORRIS_ERROR_HANDLE);
  EXPECT_EQ(orris_renderer_draw_frame(renderer, nullptr), ORRIS_ERROR_HANDLE);
}

TEST_F(Misuse, null_arguments_are_refused) {
  OrrisRenderer* renderer = make(request(testPack()));
  OrrisRendererRequest asked = request(testPack());
  OrrisContext* context = nullptr;
  const OrrisStatus all[] = {orris_context_create("auto", nullptr),
                             orris_context_create("vulkan", &context),
                             orris_context_create("glfw", &context),
                             orris_context_adopt(nullptr, nullptr, &context),
                             orris_renderer_create(context_, nullptr, &renderer),
                             orris_renderer_create(context_, &asked, nullptr),
                             orris_context_facts(context_, nullptr)};
  for (const OrrisStatus status : all) EXPECT_EQ(status, ORRIS_ERROR_ARGUMENT);
  orris_renderer_request_init(nullptr, 100);
  asked.pack = nullptr;
  OrrisRenderer* none = nullptr;
  EXPECT_EQ(orris_renderer_create(context_, &asked, &none), ORRIS_ERROR_ARGUMENT);
}

TEST_F(Misuse, arguments_of_a_renderer_are_checked) {
  OrrisRenderer* renderer = make(request(testPack()));
  OrrisFrame frame = frameOf(renderer);
  const OrrisStatus all[] = {orris_renderer_frame_init(renderer, nullptr, 4),
                             orris_renderer_set_option(renderer, nullptr, "B"),
                             orris_renderer_set_option(renderer, "A", nullptr),
                             orris_renderer_set_profile(renderer, nullptr),
                             orris_renderer_set_uniform(renderer, nullptr, &frame.rain, 1),
                             orris_renderer_set_uniform(renderer, "isRiding", nullptr, 1),
                             orris_renderer_option_count(renderer, nullptr),
                             orris_renderer_set_dimension(renderer, nullptr)};
  for (const OrrisStatus status : all) EXPECT_EQ(status, ORRIS_ERROR_ARGUMENT);
  unsigned char pixel[4];
  EXPECT_EQ(orris_renderer_read(renderer, pixel, 4), ORRIS_ERROR_ORDER) << "nothing was drawn";
  EXPECT_EQ(orris_renderer_output(renderer, 0, 0, 0, 1, 1), ORRIS_ERROR_ORDER);
  ASSERT_EQ(orris_renderer_draw_frame(renderer, &frame), ORRIS_OK);
  EXPECT_EQ(orris_renderer_read(renderer, pixel, 4), ORRIS_ERROR_ARGUMENT);
  EXPECT_EQ(orris_renderer_read(renderer, nullptr, 4), ORRIS_ERROR_ARGUMENT);
  EXPECT_EQ(orris_renderer_output(renderer, 4711, 0, 0, 1, 1), ORRIS_ERROR_ARGUMENT);
  EXPECT_EQ(orris_renderer_output(renderer, 0, 0, 0, -1, 1), ORRIS_ERROR_ARGUMENT);
}

TEST_F(Misuse, structs_of_another_version_are_refused) {
  OrrisRendererRequest asked = request(testPack());
  asked.struct_size = 12;
  OrrisRenderer* renderer = nullptr;
  EXPECT_EQ(orris_renderer_create(context_, &asked, &renderer), ORRIS_ERROR_ARGUMENT);
  EXPECT_THAT(orris_last_error(), HasSubstr("request->struct_size is 12"));
  // A caller with a shorter struct: no byte beyond it is written.
  unsigned char small[24];
  std::memset(small, 0xee, sizeof(small));
  orris_renderer_request_init(reinterpret_cast<OrrisRendererRequest*>(small), 16);
  EXPECT_EQ(small[16], 0xee);
}

TEST_F(Misuse, numbers_out_of_range_leave_the_frame_before) {
  OrrisRenderer* renderer = make(request(testPack()));
  const OrrisFrame good = frameOf(renderer);
  std::vector<OrrisFrame> bad(13, good);
  bad[0].time = 24000;
  bad[1].rain = std::numeric_limits<float>::quiet_NaN();
  bad[2].camera.fov = 180;
  bad[3].camera.position[1] = std::numeric_limits<double>::infinity();
  bad[4].camera.mode = static_cast<OrrisCameraMode>(7);
  bad[5].camera.mode = ORRIS_CAMERA_DIRECTION;
  bad[5].camera.direction[2] = 0;
  bad[6].camera.mode = ORRIS_CAMERA_MATRICES;
  std::fill_n(bad[6].camera.projection, 16, 0.0f);
  bad[7].clouds = 3;
  bad[8].render_distance = 0;
  bad[9].frame_time = -1;
  bad[10].struct_size = 0;
  bad[12].selected_block = "chest[";
  bad[11].sky_color[0] = std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < bad.size(); ++i) {
    EXPECT_EQ(orris_renderer_draw_frame(renderer, &bad[i]), ORRIS_ERROR_ARGUMENT) << i;
    EXPECT_THAT(orris_last_error(), HasSubstr("frame->")) << i;
  }
  EXPECT_EQ(frameOf(renderer).time, good.time);
  EXPECT_EQ(orris_renderer_draw_frame(renderer, &good), ORRIS_OK);
}

TEST_F(Misuse, no_current_context_is_one_message) {
  OrrisContext* adopted = nullptr;
  const auto none = [](const char*, void*) -> void* { return nullptr; };
  EXPECT_EQ(orris_context_adopt(none, nullptr, &adopted), ORRIS_ERROR_CONTEXT);
  EXPECT_EQ(adopted, nullptr);
  EXPECT_THAT(orris_last_error(), HasSubstr("no GL context is current on this thread"));
}

// A callback that calls back: the library is busy, and says so.
TEST_F(Misuse, calls_from_a_callback_are_refused) {
  struct Caller {
    OrrisContext* context;
    OrrisStatus status = ORRIS_OK;
  } caller{context_};
  OrrisRendererRequest asked = request(testPack("blend-bad"));
  asked.user = &caller;
  asked.on_diagnostic = [](const OrrisDiagnostic*, void* user) {
    auto* self = static_cast<Caller*>(user);
    self->status = orris_context_destroy(self->context);
  };
  OrrisRenderer* renderer = nullptr;
  EXPECT_EQ(orris_renderer_create(context_, &asked, &renderer), ORRIS_ERROR_PACK);
  EXPECT_EQ(caller.status, ORRIS_ERROR_ORDER);
}

}  // namespace
}  // namespace orris_test
