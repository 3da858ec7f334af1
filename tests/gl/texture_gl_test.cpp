#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include <orris/gl/framebuffer.h>
#include <orris/gl/functions.h>
#include "gl/gl_test_context.h"
#include <orris/gl/texture.h>

namespace orris::gl {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::IsEmpty;

class TextureTest : public GlTest {};

TEST_F(TextureTest, of_every_format_is_made_in_each_dimension) {
  for (const TextureFormat& format : textureFormats()) {
    for (int dimensions = 1; dimensions <= 3; ++dimensions) {
      const Texture texture = createTexture(dimensions, format, 4, 3, 2, 1, "made");
      GLint width = 0, height = 0, depth = 0;
      GetTextureLevelParameteriv(texture.id(), 0, GL_TEXTURE_WIDTH, &width);
      GetTextureLevelParameteriv(texture.id(), 0, GL_TEXTURE_HEIGHT, &height);
      GetTextureLevelParameteriv(texture.id(), 0, GL_TEXTURE_DEPTH, &depth);
      const std::vector<int> size = {width, height, depth};
      EXPECT_EQ(size, (std::vector<int>{texture.width, texture.height, texture.depth}));
      EXPECT_THAT(size, ElementsAre(4, dimensions >= 2 ? 3 : 1, dimensions >= 3 ? 2 : 1));
      EXPECT_EQ(texture.integer, format.isInteger());
      EXPECT_THAT(context_->takeErrors(), IsEmpty()) << format.name << " " << dimensions << "D";
    }
  }
}

TEST_F(TextureTest, of_every_renderable_format_completes_a_framebuffer) {
  for (const TextureFormat& format : textureFormats()) {
    const Texture texture = createTexture(2, format, 4, 4, 1, 1, "target");
    std::string error;
    const Framebuffer framebuffer = createFramebuffer({&texture}, nullptr, "target", error);
    EXPECT_EQ(framebuffer.id() != 0, format.renderable) << format.name << ": " << error;
  }
}

TEST_F(TextureTest, upload_comes_back_in_3d_slice_after_slice) {
  const Texture texture = createTexture(3, *findFormat("R8UI"), 3, 2, 2, 1, "voxels");
  std::vector<std::uint8_t> bytes(12);
  for (size_t i = 0; i < bytes.size(); ++i) bytes[i] = std::uint8_t(i * 10);
  upload(texture, GL_RED_INTEGER, GL_UNSIGNED_BYTE, bytes.data());
  int channels = 0;
  EXPECT_THAT(readPixels(texture, channels),
              ElementsAre(0, 10, 20, 30, 40, 50, 60, 70, 80, 90, 100, 110));
  EXPECT_EQ(channels, 1);
}

TEST_F(TextureTest, upload_has_no_row_padding) {
  const Texture texture = createTexture(2, *findFormat("RGB8"), 1, 3, 1, 1, "column");
  const std::uint8_t bytes[] = {255, 0, 0, 0, 255, 0, 0, 0, 255};
  upload(texture, GL_RGB, GL_UNSIGNED_BYTE, bytes);
  int channels = 0;
  EXPECT_THAT(readPixels(texture, channels), ElementsAre(1, 0, 0, 0, 1, 0, 0, 0, 1));
}

TEST_F(TextureTest, upload_of_one_dimension) {
  const Texture texture = createTexture(1, *findFormat("R32F"), 3, 1, 1, 1, "line");
  const float values[] = {-1.5f, 0.f, 1e6f};
  upload(texture, GL_RED, GL_FLOAT, values);
  int channels = 0;
  EXPECT_THAT(readPixels(texture, channels), ElementsAre(-1.5f, 0.f, 1e6f));
}

TEST_F(TextureTest, depth_reads_as_one_channel) {
  const Texture texture = createDepthTexture(2, 2, 1, "depthtex0");
  std::string error;
  const Framebuffer framebuffer = createFramebuffer({}, &texture, "depth", error);
  ASSERT_NE(framebuffer.id(), 0u) << error;
  const float depth = 0.25f;
  ClearNamedFramebufferfv(framebuffer.id(), GL_DEPTH, 0, &depth);
  int channels = 0;
  const std::vector<float> pixels = readPixels(texture, channels);
  EXPECT_EQ(channels, 1);
  ASSERT_EQ(pixels.size(), 4u);
  for (const float value : pixels) EXPECT_NEAR(value, 0.25f, 1e-6f);
}

TEST_F(TextureTest, integer_texture_stays_nearest) {
  const Texture texture = createTexture(2, *findFormat("RGBA32UI"), 4, 4, 1, 1, "ids");
  setParameters(texture, {.linear = true});
  GLint filter = 0;
  GetTextureParameteriv(texture.id(), GL_TEXTURE_MAG_FILTER, &filter);
  EXPECT_EQ(filter, GL_NEAREST);
  GetTextureParameteriv(texture.id(), GL_TEXTURE_MIN_FILTER, &filter);
  EXPECT_EQ(filter, GL_NEAREST);
}

TEST_F(TextureTest, parameters_reach_the_sampler_state) {
  const Texture texture = createTexture(2, *findFormat("RGBA16F"), 4, 4, 1, 3, "history");
  setParameters(texture, {.linear = true, .repeat = true, .mipmaps = true});
  GLint value = 0;
  GetTextureParameteriv(texture.id(), GL_TEXTURE_MIN_FILTER, &value);
  EXPECT_EQ(value, GL_LINEAR_MIPMAP_LINEAR);
  GetTextureParameteriv(texture.id(), GL_TEXTURE_WRAP_S, &value);
  EXPECT_EQ(value, GL_REPEAT);
  GetTextureParameteriv(texture.id(), GL_TEXTURE_COMPARE_MODE, &value);
  EXPECT_EQ(value, GL_NONE);
  const Texture shadow = createDepthTexture(4, 4, 1, "shadowtex0");
  setParameters(shadow, {.compare = true});
  GetTextureParameteriv(shadow.id(), GL_TEXTURE_COMPARE_MODE, &value);
  EXPECT_EQ(value, GL_COMPARE_REF_TO_TEXTURE);
  GetTextureParameteriv(shadow.id(), GL_TEXTURE_WRAP_T, &value);
  EXPECT_EQ(value, GL_CLAMP_TO_EDGE);
}

TEST_F(TextureTest, mipmaps_average_level_zero) {
  const Texture texture = createTexture(2, *findFormat("R32F"), 2, 2, 1, 2, "mips");
  const float values[] = {0, 2, 4, 10};
  upload(texture, GL_RED, GL_FLOAT, values);
  generateMipmaps(texture);
  float average = 0;
  GetTextureImage(texture.id(), 1, GL_RED, GL_FLOAT, sizeof average, &average);
  EXPECT_FLOAT_EQ(average, 4);
}

// One value per class, chosen to be exact in the smallest format of the class.
struct RoundTrip {
  const char* format;
  std::vector<float> value;
};

class ClearRoundTripTest : public GlTest, public testing::WithParamInterface<RoundTrip> {};

void clearTo(unsigned framebuffer, const TextureFormat& format, const std::vector<float>& value) {
  if (format.formatClass == FormatClass::Int) {
    const std::vector<GLint> integers(value.begin(), value.end());
    ClearNamedFramebufferiv(framebuffer, GL_COLOR, 0, integers.data());
  } else if (format.formatClass == FormatClass::Uint) {
    const std::vector<GLuint> integers(value.begin(), value.end());
    ClearNamedFramebufferuiv(framebuffer, GL_COLOR, 0, integers.data());
  } else {
    ClearNamedFramebufferfv(framebuffer, GL_COLOR, 0, value.data());
  }
}

TEST_P(ClearRoundTripTest, comes_back_exactly_in_2d_and_3d) {
  const TextureFormat& format = *findFormat(GetParam().format);
  for (int dimensions = 2; dimensions <= 3; ++dimensions) {
    const Texture texture = createTexture(dimensions, format, 5, 3, 2, 1, "round trip");
    std::string error;
    const Framebuffer framebuffer = createFramebuffer({&texture}, nullptr, "round trip", error);
    ASSERT_NE(framebuffer.id(), 0u) << error;
    clearTo(framebuffer.id(), format, GetParam().value);
    int channels = 0;
    const std::vector<float> pixels = readPixels(texture, channels);
    EXPECT_EQ(channels, format.channels);
    ASSERT_EQ(pixels.size(), size_t(5 * 3 * (dimensions == 3 ? 2 : 1) * channels));
    for (size_t i = 0; i < pixels.size(); ++i) {
      EXPECT_EQ(pixels[i], GetParam().value[i % size_t(channels)]) << format.name << " texel " << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Classes, ClearRoundTripTest,
    testing::Values(RoundTrip{"RGBA8", {0, 1, 0, 1}}, RoundTrip{"R8", {1, 0, 0, 0}},
                    RoundTrip{"RGBA8_SNORM", {-1, 1, 0, -1}}, RoundTrip{"RG16", {1, 0, 0, 0}},
                    RoundTrip{"RGB16F", {-2.5f, 1024, 0.125f, 0}},
                    RoundTrip{"R11F_G11F_B10F", {0.5f, 4, 16, 0}},
                    RoundTrip{"RGBA32F", {-1e20f, 3.25f, 0, 7}}, RoundTrip{"R8I", {-128, 0, 0, 0}},
                    RoundTrip{"RGBA16I", {-32768, 32767, 0, 1}},
                    RoundTrip{"RGBA32I", {-16777216, 16777216, 0, 5}},
                    RoundTrip{"RG8UI", {255, 1, 0, 0}}, RoundTrip{"RGB32UI", {16777216, 0, 3, 0}},
                    RoundTrip{"RGB10_A2UI", {1023, 0, 5, 3}}),
    [](const auto& test) { return std::string(test.param.format); });

}  // namespace
}  // namespace orris::gl
