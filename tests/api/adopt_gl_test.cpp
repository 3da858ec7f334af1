// An engine's own context: what Orris does in it and what it leaves behind.
#include <map>
#include <thread>

#include "api/api_fixture.h"
#include "api/own_context.h"

namespace orris_test {
namespace {

using testing::HasSubstr;

class AdoptedContext : public testing::TestWithParam<bool> {
 protected:
  void SetUp() override {
    if (!own_) GTEST_SKIP() << "no OSMesa here";
    ASSERT_EQ(orris_context_adopt(OwnContext::resolve, &own_, &context_), ORRIS_OK)
        << orris_last_error();
    OrrisRendererRequest request;
    orris_renderer_request_init(&request, sizeof(request));
    request.width = 32;
    request.height = 16;
    pack_ = testPack();
    world_ = std::string(ORRIS_SOURCE_DIR) + "/worlds/lamps";
    request.pack = pack_.c_str();
    request.world = world_.c_str();
    ASSERT_EQ(orris_renderer_create(context_, &request, &renderer_), ORRIS_OK)
        << orris_last_error();
  }
  void TearDown() override {
    if (renderer_ != nullptr) {
      EXPECT_EQ(orris_renderer_destroy(renderer_), ORRIS_OK);
    }
    if (context_ != nullptr) {
      EXPECT_EQ(orris_context_destroy(context_), ORRIS_OK);
    }
  }

  int integer(GLenum name) const {
    int values[4] = {};
    OWN_GL(own_, GetIntegerv)(name, values);
    return values[0];
  }
  /// Everything that the page of the interface promises, by name.
  std::map<GLenum, int> state() const {
    std::map<GLenum, int> result;
    for (const GLenum name : {GL_DRAW_FRAMEBUFFER_BINDING,
                              GL_READ_FRAMEBUFFER_BINDING,
                              GL_CURRENT_PROGRAM,
                              GL_VERTEX_ARRAY_BINDING,
                              GL_ARRAY_BUFFER_BINDING,
                              GL_ACTIVE_TEXTURE,
                              GL_TEXTURE_BINDING_2D,
                              GL_SAMPLER_BINDING,
                              GL_DEPTH_FUNC,
                              GL_DEPTH_WRITEMASK,
                              GL_CULL_FACE_MODE,
                              GL_FRONT_FACE,
                              GL_BLEND_SRC_RGB,
                              GL_BLEND_DST_ALPHA,
                              GL_BLEND_EQUATION_RGB,
                              GL_PACK_ALIGNMENT,
                              GL_UNPACK_ROW_LENGTH,
                              GL_STENCIL_FUNC,
                              GL_STENCIL_REF,
                              GL_STENCIL_BACK_WRITEMASK,
                              GL_POLYGON_MODE,
                              GL_CLIP_ORIGIN,
                              GL_PATCH_VERTICES,
                              GL_VIEWPORT,
                              GL_SCISSOR_BOX,
                              GL_COLOR_WRITEMASK})
      result[name] = integer(name);
    for (const GLenum name : {GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_BLEND, GL_CULL_FACE,
                              GL_DEPTH_TEST, GL_RASTERIZER_DISCARD, GL_POLYGON_OFFSET_FILL,
                              GL_FRAMEBUFFER_SRGB, GL_DEPTH_CLAMP, GL_COLOR_LOGIC_OP})
      result[name] = OWN_GL(own_, IsEnabled)(name);
    return result;
  }
  std::vector<unsigned char> picture() {
    EXPECT_EQ(orris_renderer_draw_frame(renderer_, nullptr), ORRIS_OK) << orris_last_error();
    std::vector<unsigned char> pixels(32 * 16 * 4);
    EXPECT_EQ(orris_renderer_read(renderer_, pixels.data(), pixels.size()), ORRIS_OK);
    return pixels;
  }
  /// What no renderer could draw under.
  void setOtherState() const {
    for (const GLenum name : {GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_BLEND, GL_CULL_FACE,
                              GL_RASTERIZER_DISCARD, GL_POLYGON_OFFSET_FILL, GL_COLOR_LOGIC_OP})
      OWN_GL(own_, Enable)(name);
    OWN_GL(own_, Scissor)(1, 2, 3, 4);
    OWN_GL(own_, Viewport)(5, 6, 7, 8);
    OWN_GL(own_, StencilFunc)(GL_NEVER, 3, 0xff);
    OWN_GL(own_, StencilMask)(0x0f);
    OWN_GL(own_, DepthFunc)(GL_NEVER);
    OWN_GL(own_, DepthMask)(GL_FALSE);
    OWN_GL(own_, CullFace)(GL_FRONT_AND_BACK);
    OWN_GL(own_, FrontFace)(GL_CW);
    OWN_GL(own_, BlendFunc)(GL_ZERO, GL_ZERO);
    OWN_GL(own_, BlendEquation)(GL_FUNC_REVERSE_SUBTRACT);
    OWN_GL(own_, ColorMask)(GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE);
    OWN_GL(own_, PixelStorei)(GL_PACK_ALIGNMENT, 8);
    OWN_GL(own_, PixelStorei)(GL_UNPACK_ROW_LENGTH, 1000);
    OWN_GL(own_, PolygonMode)(GL_FRONT_AND_BACK, GL_POINT);
    OWN_GL(own_, ClipControl)(GL_UPPER_LEFT, GL_ZERO_TO_ONE);
    OWN_GL(own_, PatchParameteri)(GL_PATCH_VERTICES, 5);
    GLuint names[5];
    OWN_GL(own_, CreateVertexArrays)(1, &names[0]);
    OWN_GL(own_, BindVertexArray)(names[0]);
    OWN_GL(own_, CreateBuffers)(1, &names[1]);
    OWN_GL(own_, BindBuffer)(GL_ARRAY_BUFFER, names[1]);
    OWN_GL(own_, CreateFramebuffers)(1, &names[2]);
    OWN_GL(own_, BindFramebuffer)(GL_FRAMEBUFFER, names[2]);
    OWN_GL(own_, CreateSamplers)(1, &names[3]);
    OWN_GL(own_, ActiveTexture)(GL_TEXTURE2);
    OWN_GL(own_, BindSampler)(2, names[3]);
    OWN_GL(own_, CreateTextures)(GL_TEXTURE_2D, 1, &names[4]);
    OWN_GL(own_, BindTexture)(GL_TEXTURE_2D, names[4]);
  }

  OwnContext own_{GetParam()};
  OrrisContext* context_ = nullptr;
  OrrisRenderer* renderer_ = nullptr;
  std::string pack_, world_;
};

TEST_P(AdoptedContext, is_known_for_what_it_is) {
  OrrisContextFacts facts;
  facts.struct_size = sizeof(facts);
  ASSERT_EQ(orris_context_facts(context_, &facts), ORRIS_OK);
  EXPECT_STREQ(facts.backend, "adopted");
  EXPECT_EQ(facts.core_profile, GetParam() ? 1 : 0);
}

TEST_P(AdoptedContext, engine_state_neither_disturbs_nor_changes) {
  const auto before = picture();
  setOtherState();
  const auto asSet = state();
  ASSERT_EQ(OWN_GL(own_, GetError)(), unsigned{GL_NO_ERROR});
  EXPECT_EQ(picture(), before);
  EXPECT_EQ(state(), asSet);
  EXPECT_EQ(OWN_GL(own_, GetError)(), unsigned{GL_NO_ERROR});
}

TEST_P(AdoptedContext, matrices_and_alpha_test_of_old_gl_come_back) {
  if (GetParam()) GTEST_SKIP() << "a core context has none";
  OWN_GL(own_, MatrixMode)(GL_PROJECTION);
  const float matrix[16] = {2, 0, 0, 0, 0, 3, 0, 0, 0, 0, 4, 0, 0, 0, 0, 5};
  OWN_GL(own_, LoadMatrixf)(matrix);
  OWN_GL(own_, AlphaFunc)(GL_NEVER, 0.25f);
  OWN_GL(own_, Enable)(GL_ALPHA_TEST);
  picture();
  float after[16];
  OWN_GL(own_, GetFloatv)(GL_PROJECTION_MATRIX, after);
  EXPECT_TRUE(std::equal(matrix, matrix + 16, after));
  EXPECT_EQ(integer(GL_MATRIX_MODE), GL_PROJECTION);
  EXPECT_EQ(integer(GL_ALPHA_TEST_FUNC), GL_NEVER);
  EXPECT_EQ(OWN_GL(own_, IsEnabled)(GL_ALPHA_TEST), GL_TRUE);
}

TEST_P(AdoptedContext, the_picture_goes_into_a_framebuffer_of_the_engine) {
  const auto drawn = picture();
  GLuint texture = 0, framebuffer = 0;
  OWN_GL(own_, CreateTextures)(GL_TEXTURE_2D, 1, &texture);
  OWN_GL(own_, TextureStorage2D)(texture, 1, GL_RGBA8, 64, 64);
  OWN_GL(own_, CreateFramebuffers)(1, &framebuffer);
  OWN_GL(own_, NamedFramebufferTexture)(framebuffer, GL_COLOR_ATTACHMENT0, texture, 0);
  OWN_GL(own_, Enable)(GL_SCISSOR_TEST);  // blits obey it
  OWN_GL(own_, Scissor)(0, 0, 1, 1);
  ASSERT_EQ(orris_renderer_output(renderer_, framebuffer, 16, 8, 32, 16), ORRIS_OK)
      << orris_last_error();
  std::vector<unsigned char> pixels(64 * 64 * 4);
  OWN_GL(own_, GetTextureImage)
  (texture, 0, GL_RGBA, GL_UNSIGNED_BYTE, GLsizei(pixels.size()), pixels.data());
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 32; ++x)
      for (int c = 0; c < 3; ++c)
        ASSERT_EQ(pixels[static_cast<std::size_t>(((8 + 15 - y) * 64 + 16 + x) * 4 + c)],
                  drawn[static_cast<std::size_t>((y * 32 + x) * 4 + c)])
            << x << ' ' << y;
  EXPECT_EQ(pixels[0], 0) << "beside the rectangle nothing is drawn";
  std::uint32_t name = 0;
  ASSERT_EQ(orris_renderer_texture(renderer_, "screen", &name), ORRIS_OK);
  EXPECT_EQ(OWN_GL(own_, IsTexture)(name), GL_TRUE);
}

TEST_P(AdoptedContext, is_missed_when_the_engine_has_another_or_none_current) {
  own_.release();
  EXPECT_EQ(orris_renderer_draw_frame(renderer_, nullptr), ORRIS_ERROR_CONTEXT);
  EXPECT_THAT(orris_last_error(), HasSubstr("is not current on this thread"));
  EXPECT_EQ(orris_renderer_destroy(renderer_), ORRIS_ERROR_CONTEXT);
  own_.makeCurrent();
  picture();
  OrrisStatus elsewhere = ORRIS_OK;
  std::thread([&] { elsewhere = orris_renderer_draw_frame(renderer_, nullptr); }).join();
  EXPECT_EQ(elsewhere, ORRIS_ERROR_CONTEXT);
  picture();
}

TEST_P(AdoptedContext, stays_when_orris_is_done_with_it) {
  void* callback = nullptr;
  ASSERT_EQ(orris_renderer_destroy(renderer_), ORRIS_OK);
  ASSERT_EQ(orris_context_destroy(context_), ORRIS_OK);
  renderer_ = nullptr;
  context_ = nullptr;
  OWN_GL(own_, GetPointerv)(GL_DEBUG_CALLBACK_FUNCTION, &callback);
  EXPECT_EQ(callback, nullptr);
  OWN_GL(own_, ClearColor)(0, 0, 0, 0);
  EXPECT_EQ(OWN_GL(own_, GetError)(), unsigned{GL_NO_ERROR});
}

INSTANTIATE_TEST_SUITE_P(Profiles, AdoptedContext, testing::Bool(), [](const auto& test) {
  return std::string(test.param ? "core" : "compatibility");
});

}  // namespace
}  // namespace orris_test
