#include <orris/gl/framebuffer.h>
#include <orris/gl/functions.h>
#include "gl/gl_test_context.h"

namespace orris::gl {
namespace {

using testing::ElementsAre;

class FramebufferTest : public GlTest {};

TEST_F(FramebufferTest, draw_buffers_follow_the_order_given) {
  const TextureFormat& format = *findFormat("RGBA8");
  const Texture first = createTexture(2, format, 1, 1, 1, 1, "first");
  const Texture second = createTexture(2, format, 1, 1, 1, 1, "second");
  std::string error;
  const Framebuffer framebuffer = createFramebuffer({&second, &first}, nullptr, "two", error);
  ASSERT_NE(framebuffer.id(), 0u) << error;
  EXPECT_EQ(framebuffer.colors, 2);
  const float red[] = {1, 0, 0, 1};
  const float green[] = {0, 1, 0, 1};
  ClearNamedFramebufferfv(framebuffer.id(), GL_COLOR, 0, red);
  ClearNamedFramebufferfv(framebuffer.id(), GL_COLOR, 1, green);
  int channels = 0;
  EXPECT_THAT(readPixels(second, channels), ElementsAre(1, 0, 0, 1));
  EXPECT_THAT(readPixels(first, channels), ElementsAre(0, 1, 0, 1));
}

TEST_F(FramebufferTest, without_attachments_is_refused) {
  std::string error;
  EXPECT_EQ(createFramebuffer({}, nullptr, "nothing", error).id(), 0u);
  EXPECT_EQ(error, "framebuffer \"nothing\" () is incomplete: it has no attachment");
}

TEST_F(FramebufferTest, of_a_format_not_drawable_names_it) {
  const Texture texture = createTexture(2, *findFormat("RGB9_E5"), 8, 4, 1, 1, "shared exponent");
  std::string error;
  EXPECT_EQ(createFramebuffer({&texture}, nullptr, "colortex3", error).id(), 0u);
  EXPECT_EQ(error,
            "framebuffer \"colortex3\" (RGB9_E5 8x4) is incomplete: RGB9_E5 cannot be drawn to");
}

TEST_F(FramebufferTest, size_is_the_common_part) {
  const Texture color = createTexture(2, *findFormat("RGBA8"), 8, 4, 1, 1, "color");
  const Texture depth = createDepthTexture(6, 9, 1, "depth");
  std::string error;
  const Framebuffer framebuffer = createFramebuffer({&color}, &depth, "mixed", error);
  EXPECT_EQ(framebuffer.width, 6);
  EXPECT_EQ(framebuffer.height, 4);
}

}  // namespace
}  // namespace orris::gl
