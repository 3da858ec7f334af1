// What a frame runs besides the drawing of a world: programs, extensions, stores.
#include <gmock/gmock.h>

#include <orris/gl/functions.h>
#include <orris/render/frame_renderer.h>
#include "render/render_fixture.h"

namespace orris {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

class FrameRendererGL : public RenderTest {};

TEST_F(FrameRendererGL, renderers_with_one_pool_build_a_program_once) {
  pool_ = std::make_shared<ProgramPool>();
  files_["/shaders.properties"] = "skipAllRendering=true\nuniform.float.one = 1.0\n";
  addProgram("composite", "uniform float one;\nvoid main() { gl_FragColor = vec4(one); }\n");
  addProgram("final", kPass);
  ASSERT_TRUE(start(floorWorld())) << messages();
  EXPECT_EQ(session_->reloads().front().report.programsBuilt, 2);
  ASSERT_TRUE(start(floorWorld())) << messages();
  EXPECT_EQ(session_->reloads().front().report.programsBuilt, 0);
  draw();
  EXPECT_THAT(pixel("colortex0", 5, 5), ElementsAre(1, 1, 1, 1));
  // Another list of custom uniforms: `one` is in another place.
  files_["/shaders.properties"] =
      "skipAllRendering=true\nuniform.float.nought = 0.0\nuniform.float.one = 1.0\n";
  ASSERT_TRUE(start(floorWorld())) << messages();
  EXPECT_EQ(session_->reloads().front().report.programsBuilt, 2);
  draw();
  EXPECT_THAT(pixel("colortex0", 5, 5), ElementsAre(1, 1, 1, 1));
}

TEST_F(FrameRendererGL, every_renderer_of_a_pool_reports_what_its_driver_lacks) {
  if (!gl::isSoftwareRenderer(context_->driver().renderer)) GTEST_SKIP() << "this driver lacks nothing";
  pool_ = std::make_shared<ProgramPool>();
  files_["/shaders.properties"] = "skipAllRendering=true\n";
  files_["/composite.csh"] =
      "#version 430 compatibility\nlayout(local_size_x = 64) in;\n"
      "const ivec3 workGroups = ivec3(1, 1, 1);\nshared float much[12000];\n"
      "layout(rgba8) uniform image2D colorimg0;\n"
      "void main() { much[gl_LocalInvocationIndex] = 1.0; barrier();\n"
      "  imageStore(colorimg0, ivec2(0), vec4(much[63 - gl_LocalInvocationIndex])); }\n";
  addProgram("final", kPass);
  for (int i = 0; i < 2; ++i) {
    ASSERT_TRUE(start(floorWorld())) << messages();
    EXPECT_THAT(messages(), HasSubstr("rule shared-buffer"));
  }
}

TEST_F(FrameRendererGL, custom_uniforms_and_images_and_buffers_work_together) {
  files_["/shaders.properties"] = R"(skipAllRendering=true
iris.features.required=CUSTOM_IMAGES SSBO COMPUTE_SHADERS
uniform.float.doubled = viewWidth * 2.0
image.store = storeSampler RED R32F FLOAT false false 4 4
bufferObject.0 = 16
)";
  files_["/begin.csh"] = R"(#version 430 compatibility
layout(local_size_x = 4, local_size_y = 4) in;
const ivec3 workGroups = ivec3(1, 1, 1);
layout(r32f) uniform image2D store;
layout(std430, binding = 0) buffer Counter { uint count; };
uniform float doubled;
void main() {
  atomicAdd(count, 1u);
  imageStore(store, ivec2(gl_LocalInvocationID.xy), vec4(doubled));
}
)";
  addProgram("final", R"(
uniform sampler2D storeSampler;
layout(std430, binding = 0) buffer Counter { uint count; };
void main() { gl_FragColor = vec4(texelFetch(storeSampler, ivec2(1), 0).r, float(count), 0.0, 1.0); }
)");
  files_["/final.fsh"].replace(0, files_["/final.fsh"].find('\n'), "#version 430 compatibility");
  ASSERT_TRUE(start(floorWorld())) << messages();
  draw(2);
  EXPECT_THAT(pixel("store", 0, 0), ElementsAre(64));
}

TEST_F(FrameRendererGL, only_passes_that_store_and_those_after_them_wait) {
  files_["/shaders.properties"] = R"(skipAllRendering=true
iris.features.required=CUSTOM_IMAGES SSBO
image.store = storeSampler RED R32F FLOAT false false 4 4
bufferObject.0 = 16
)";
  for (const char* name : {"composite", "composite1", "composite3", "final"}) addProgram(name, kPass);
  addProgram("composite2",
             "layout(r32f) uniform image2D store;\nvoid main() {\n  imageStore(store, ivec2(0), vec4(1));\n"
             "  gl_FragData[0] = vec4(1);\n}\n");
  addProgram("composite4",
             "layout(std430, binding = 0) buffer Counter { uint count; };\nvoid main() {\n"
             "  atomicAdd(count, 1u);\n  gl_FragData[0] = vec4(1);\n}\n");
  for (const char* name : {"/composite2.fsh", "/composite4.fsh"})
    files_[name].replace(0, files_[name].find('\n'), "#version 430 compatibility");
  ASSERT_TRUE(start(floorWorld())) << messages();
  static int barriers;
  const auto original = std::exchange(gl::MemoryBarrier, [](GLbitfield) { ++barriers; });
  std::map<std::string, int> before;
  session_->renderer().watchSteps([&](const Step& step) { before[step.name] += std::exchange(barriers, 0); });
  barriers = 0;
  draw();
  gl::MemoryBarrier = original;
  for (const auto& [name, count] : before) {
    const bool waits = name == "composite2" || name == "composite3" || name == "composite4" || name == "final";
    EXPECT_EQ(count, waits ? 1 : 0) << name;
  }
}

TEST_F(FrameRendererGL, passes_over_the_screen_have_an_alpha_test_that_all_pass) {
  addProgram("composite", kPass);
  addProgram("final", kPass);
  ASSERT_TRUE(start(floorWorld())) << messages();
  int passes = 0;
  session_->renderer().watchSteps([&](const Step& step) {
    if (step.name != "composite" && step.name != "final") return;
    ++passes;
    int function = 0;
    gl::GetIntegerv(GL_ALPHA_TEST_FUNC, &function);
    EXPECT_TRUE(gl::IsEnabled(GL_ALPHA_TEST)) << step.name;
    EXPECT_EQ(function, GL_ALWAYS) << step.name;
  });
  draw();
  EXPECT_EQ(passes, 2);
}

TEST_F(FrameRendererGL, an_extension_that_the_driver_lacks_is_a_limit_of_the_driver) {
  addProgram("composite",
             "#extension GL_NONE_such : enable\nvoid main() {\n  gl_FragColor = noSuch(uv);\n}\n");
  addProgram("final", kPass);
  ASSERT_TRUE(start(floorWorld())) << messages();
  EXPECT_THAT(messages(), testing::ContainsRegex("/composite.fsh:[23].*: warning: extension .*NONE_such.* "
                                        "(unsupported in fragment shader|not supported)"));
  EXPECT_THAT(messages(), HasSubstr("this driver cannot run the program; it is left out"));
  EXPECT_THAT(messages(), Not(HasSubstr("noSuch")));
}

}  // namespace
}  // namespace orris
