// Drawing as packs do it: compatibility arrays, fixed-function matrices, generic attributes.
#include <algorithm>
#include <cstdlib>

#include <orris/gl/framebuffer.h>
#include <orris/gl/functions.h>
#include "gl/gl_test_context.h"
#include <orris/gl/program.h>

namespace orris::gl {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr int kSize = 32;

constexpr std::string_view kQuadVertex = R"(#version 120
attribute vec4 mc_Entity;
varying vec4 tint;
void main() {
  tint = gl_Color * mc_Entity.x;
  gl_Position = gl_ProjectionMatrix * gl_ModelViewMatrix * gl_Vertex;
})";
constexpr std::string_view kQuadFragment = R"(#version 120
varying vec4 tint;
void main() { gl_FragData[0] = tint; })";

// A right triangle over the lower left half, red at the left and green at the right corner, drawn
// in [0,1]^2 through the projection matrix.
std::vector<float> drawTriangle() {
  const Texture color = createTexture(2, *findFormat("RGBA8"), kSize, kSize, 1, 1, "colortex0");
  const Texture depth = createDepthTexture(kSize, kSize, 1, "depthtex0");
  std::string error;
  const Framebuffer framebuffer = createFramebuffer({&color}, &depth, "triangle", error);
  EXPECT_NE(framebuffer.id(), 0u) << error;
  const Program program = buildProgram(
      {{GL_VERTEX_SHADER, kQuadVertex}, {GL_FRAGMENT_SHADER, kQuadFragment}}, {}, "gbuffers_basic");
  EXPECT_TRUE(program.linked);
  BindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
  Viewport(0, 0, kSize, kSize);
  ClearColor(0, 0, 1, 1);
  ClearDepth(1);
  Enable(GL_DEPTH_TEST);
  Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  const float projection[] = {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, -1, 0, -1, -1, 0, 1};
  MatrixMode(GL_PROJECTION);
  LoadMatrixf(projection);
  MatrixMode(GL_MODELVIEW);
  LoadIdentity();
  const float positions[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  const float colors[] = {1, 0, 0, 1, 0, 1, 0, 1, 1, 0, 0, 1};
  UseProgram(program.id());
  const GLint entity = GetAttribLocation(program.id(), "mc_Entity");
  VertexAttrib4f(GLuint(entity), 1, 0, 0, 0);
  EnableClientState(GL_VERTEX_ARRAY);
  EnableClientState(GL_COLOR_ARRAY);
  VertexPointer(3, GL_FLOAT, 0, positions);
  ColorPointer(4, GL_FLOAT, 0, colors);
  DrawArrays(GL_TRIANGLES, 0, 3);
  DisableClientState(GL_COLOR_ARRAY);
  DisableClientState(GL_VERTEX_ARRAY);
  UseProgram(0);
  BindFramebuffer(GL_FRAMEBUFFER, 0);
  int channels = 0;
  return readPixels(color, channels);
}

std::vector<float> texelAt(const std::vector<float>& pixels, int x, int y) {
  const auto at = pixels.begin() + (y * kSize + x) * 4;
  return {at, at + 4};
}

class DrawTest : public GlTest {};

TEST_F(DrawTest, triangle_from_compatibility_arrays) {
  const std::vector<float> pixels = drawTriangle();
  const std::vector<float> background = {0, 0, 1, 1};
  EXPECT_EQ(texelAt(pixels, kSize - 1, kSize - 1), background);
  EXPECT_EQ(texelAt(pixels, kSize - 2, 4), background);
  const std::vector<float> left = texelAt(pixels, 0, 0);
  EXPECT_NEAR(left[0], 1, 0.05);
  EXPECT_NEAR(left[1], 0, 0.05);
  EXPECT_EQ(left[2], 0);
  const std::vector<float> middle = texelAt(pixels, kSize / 2, 1);
  EXPECT_NEAR(middle[0], 0.5, 0.05);
  EXPECT_NEAR(middle[1], 0.5, 0.05);
  const auto covered = std::count_if(pixels.begin(), pixels.end(), [&](const float& value) {
    return (&value - pixels.data()) % 4 == 2 && value == 0;
  });
  EXPECT_NEAR(double(covered), kSize * kSize / 2.0, kSize);
}

std::vector<float> triangleOf(Backend backend, std::string& missing) {
  ContextRequest request;
  request.backend = backend;
  request.visible = false;
  Diagnostics diagnostics;
  const auto context = createContext(request, diagnostics);
  if (context == nullptr) {
    missing = diagnostics.front().message;
    return {};
  }
  std::vector<float> pixels = drawTriangle();
  EXPECT_THAT(context->takeErrors(), IsEmpty());
  return pixels;
}

TEST(DrawBackends, osmesa_and_egl_give_the_same_pixels) {
  std::string missing;
  const std::vector<float> osmesa = triangleOf(Backend::OSMesa, missing);
  const std::vector<float> egl = triangleOf(Backend::Egl, missing);
  if (!missing.empty()) GTEST_SKIP() << missing;
  EXPECT_EQ(osmesa, egl);
}

TEST(DrawBackends, window_and_egl_give_the_same_pixels) {
  if (std::getenv("DISPLAY") == nullptr) GTEST_SKIP() << "needs a display, DISPLAY is not set";
  std::string missing;
  const std::vector<float> window = triangleOf(Backend::Glfw, missing);
  const std::vector<float> egl = triangleOf(Backend::Egl, missing);
  if (!missing.empty()) GTEST_SKIP() << missing;
  EXPECT_EQ(window, egl);
}

TEST_F(DrawTest, integer_attribute_arrives_unconverted) {
  const Texture color = createTexture(2, *findFormat("RG32UI"), 1, 1, 1, 1, "ids");
  std::string error;
  const Framebuffer framebuffer = createFramebuffer({&color}, nullptr, "ids", error);
  const Program program = buildProgram({{GL_VERTEX_SHADER, R"(#version 330 compatibility
in ivec2 vaUV2;
flat out uvec2 id;
void main() { id = uvec2(vaUV2); gl_Position = gl_Vertex; })"},
                                        {GL_FRAGMENT_SHADER, R"(#version 330 compatibility
flat in uvec2 id;
layout(location = 0) out uvec2 outId;
void main() { outId = id; })"}},
                                       {}, "ids");
  ASSERT_TRUE(program.linked) << program.linkLog;
  BindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
  Viewport(0, 0, 1, 1);
  const float positions[] = {-1, -1, 0, 3, -1, 0, -1, 3, 0};
  const short light[] = {240, 16, 240, 16, 240, 16};
  UseProgram(program.id());
  const GLuint location = GLuint(GetAttribLocation(program.id(), "vaUV2"));
  EnableClientState(GL_VERTEX_ARRAY);
  VertexPointer(3, GL_FLOAT, 0, positions);
  EnableVertexAttribArray(location);
  VertexAttribIPointer(location, 2, GL_SHORT, 0, light);
  DrawArrays(GL_TRIANGLES, 0, 3);
  DisableVertexAttribArray(location);
  DisableClientState(GL_VERTEX_ARRAY);
  BindFramebuffer(GL_FRAMEBUFFER, 0);
  int channels = 0;
  EXPECT_THAT(readPixels(color, channels), ElementsAre(240, 16));
}

}  // namespace
}  // namespace orris::gl
