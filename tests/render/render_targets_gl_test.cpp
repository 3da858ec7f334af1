// What the passes of a frame read and write.
#include <gmock/gmock.h>

#include <orris/render/frame_renderer.h>
#include "render/render_fixture.h"

namespace orris {
namespace {

using ::testing::ElementsAre;
using ::testing::FloatNear;

class RenderTargetsGL : public RenderTest {};

TEST_F(RenderTargetsGL, programs_read_what_the_last_one_wrote) {
  // Each composite adds its own digit; a wrong side loses one.
  files_["/shaders.properties"] = "skipAllRendering=true\n";
  const std::string add = R"(
/* RENDERTARGETS: 4 */
/*
const int colortex4Format = R32F;
*/
uniform sampler2D colortex4;
void main() { gl_FragColor = vec4(texture2D(colortex4, uv).r * 10.0 + float(DIGIT)); }
)";
  const auto digit = [&](int d) { return "#define DIGIT " + std::to_string(d) + "\n" + add; };
  addProgram("composite", digit(1));
  addProgram("composite1", digit(2));
  addProgram("composite2", digit(3));
  addProgram("final", kPass);
  ASSERT_TRUE(start(floorWorld())) << messages();
  draw(3);
  EXPECT_THAT(pixel("colortex4", 3, 3), ElementsAre(123));
}

TEST_F(RenderTargetsGL, an_uncleared_buffer_counts_frames) {
  files_["/shaders.properties"] = "skipAllRendering=true\n";
  files_["/composite.vsh"] = kVertex;
  files_["/composite.fsh"] = R"(#version 330 compatibility
in vec2 uv;
/* RENDERTARGETS: 4 */
/*
const int colortex4Format = R32F;
*/
const bool colortex4Clear = false;
uniform sampler2D colortex4;
void main() { gl_FragColor = vec4(texture2D(colortex4, uv).r + 1.0); }
)";
  addProgram("final", kPass);
  ASSERT_TRUE(start(floorWorld())) << messages();
  draw(5);
  EXPECT_THAT(pixel("colortex4", 0, 0), ElementsAre(5));
}

TEST_F(RenderTargetsGL, depth_copies_leave_out_translucent_blocks) {
  World world = floorWorld();
  world.blocks.set({0, 2, 0},
                   world.blocks.paletteIndex(*parseBlockState("minecraft:red_stained_glass")));
  addProgram(
      "final",
      "uniform sampler2D depthtex0;\nuniform sampler2D depthtex1;\n"
      "void main() { gl_FragColor = texture2D(depthtex0, uv) + texture2D(depthtex1, uv); }\n");
  ASSERT_TRUE(start(world)) << messages();
  draw();
  EXPECT_LT(pixel("depthtex0", 16, 16)[0], pixel("depthtex1", 16, 16)[0]);
  EXPECT_EQ(pixel("depthtex0", 2, 2)[0], pixel("depthtex1", 2, 2)[0]);
}

TEST_F(RenderTargetsGL, buffer_without_an_output_stays_as_it_was) {
  files_["/shaders.properties"] = "blend.gbuffers_water = SRC_ALPHA ONE_MINUS_SRC_ALPHA ONE ONE\n";
  addProgram("gbuffers_terrain", "/* RENDERTARGETS: 0,1 */\n"
                                 "void main() { gl_FragData[0] = gl_FragData[1] = vec4(0.5); }\n");
  addProgram("gbuffers_water", "/* RENDERTARGETS: 0,1 */\n"
                               "void main() { gl_FragData[1] = vec4(1.0, 0.0, 0.0, 1.0); }\n");
  addProgram("composite", "/* RENDERTARGETS: 2,3 */\nlayout(location = 1) out vec4 color;\n"
                          "void main() { color = vec4(0.25); }\n");
  addProgram("final", "uniform sampler2D colortex0, colortex1, colortex2, colortex3;\n"
                      "layout(location = 0) out vec4 c;\nvoid main() { c = texture(colortex0, uv) + "
                      "texture(colortex1, uv) + texture(colortex2, uv) + texture(colortex3, uv); }\n");
  World world = floorWorld();
  const auto water = world.blocks.paletteIndex(*parseBlockState("minecraft:water"));
  world.blocks.fill({-4, 1, -4}, {4, 1, 4}, water);
  ASSERT_TRUE(start(world)) << messages();
  draw();
  EXPECT_THAT(pixel("colortex0", 16, 16), testing::Each(testing::FloatNear(0.5f, .01f)));
  EXPECT_NEAR(pixel("colortex1", 16, 16)[0], 1, .01);
  EXPECT_THAT(pixel("colortex2", 16, 16), testing::Each(0));
  EXPECT_NEAR(pixel("colortex3", 16, 16)[0], 0.25, .01);
}

TEST_F(RenderTargetsGL, the_last_of_32_buffers_is_drawn_and_read) {
  addProgram("composite",
             "/*\nconst int colortex31Format = RGBA32F;\nconst int colortex16Format = RG16F;\n"
             "const bool colortex31Clear = false;\n"
             "const vec4 colortex16ClearColor = vec4(0.25, 0.5, 0.0, 1.0);\n*/\n"
             "/* RENDERTARGETS: 31 */\nuniform sampler2D colortex16, colortex31;\n"
             "void main() { gl_FragData[0] = texture2D(colortex31, uv) +\n"
             "    vec4(texture2D(colortex16, uv).rg, 1.0, 1.0); }\n");
  addProgram("final",
             "uniform sampler2D colortex31;\nvoid main() {\n"
             "  gl_FragData[0] = texture2D(colortex31, uv); }\n");
  ASSERT_TRUE(start(floorWorld())) << messages();
  // Flipped, kept from frame to frame, and none of the 29 others is made.
  draw(3);
  EXPECT_EQ(pixel("colortex31", 16, 16), (std::vector<float>{0.75f, 1.5f, 3, 3}));
  EXPECT_EQ(pixel("colortex16", 16, 16)[0], 0.25f);
  EXPECT_TRUE(pixel("colortex15", 16, 16).empty());
}

// What GL refuses fails the test at its end.
TEST_F(RenderTargetsGL, scales_beyond_all_pictures_are_no_mistakes_of_gl) {
  addProgram("composite", "/* RENDERTARGETS: 0 */\nvoid main() { gl_FragColor = vec4(1.0); }\n");
  for (const std::string scale : {"1e30", "-2", "1 -1e30 1e30"}) {
    files_["/shaders.properties"] = "scale.composite=" + scale + "\n";
    ASSERT_TRUE(start(floorWorld())) << messages();
    draw();
    const bool covers = scale == "1e30";
    EXPECT_EQ(pixel("colortex0", 16, 16) == std::vector<float>(4, 1.0f), covers) << scale;
  }
}

}  // namespace
}  // namespace orris
