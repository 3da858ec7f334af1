#include <algorithm>

#include <orris/gl/framebuffer.h>
#include <orris/gl/functions.h>
#include "gl/gl_test_context.h"
#include <orris/gl/program.h>

namespace orris::gl {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr std::string_view kVertex = R"(#version 330 compatibility
in vec3 mc_Entity;
in ivec2 vaUV2;
uniform mat4 gbufferModelView;
uniform float weights[4];
struct Light { vec3 color; float reach; };
uniform Light lights[2];
out float shade;
void main() {
  shade = mc_Entity.x + float(vaUV2.y) + weights[3] + lights[0].reach + lights[1].color.x;
  gl_Position = gbufferModelView * gl_ModelViewMatrix * gl_Vertex;
})";

constexpr std::string_view kFragment = R"(#version 430 compatibility
in float shade;
uniform sampler2D colortex0;
uniform usampler3D voxels[2];
uniform sampler2DShadow shadowtex0;
layout(rgba16f) uniform image2D colorimg3;
out vec4 outColor1;
out vec4 outColor0;
void main() {
  outColor0 = texture(colortex0, vec2(shade)) + imageLoad(colorimg3, ivec2(0));
  outColor1 = vec4(texelFetch(voxels[0], ivec3(0), 0) + texelFetch(voxels[1], ivec3(0), 0)) +
              texture(shadowtex0, vec3(shade));
})";

class ProgramTest : public GlTest {
 protected:
  static const ActiveVariable* find(const std::vector<ActiveVariable>& list,
                                    std::string_view name) {
    const auto found = std::find_if(list.begin(), list.end(),
                                    [name](const auto& variable) { return variable.name == name; });
    return found == list.end() ? nullptr : &*found;
  }
};

TEST_F(ProgramTest, tells_its_uniforms_with_types_and_sizes) {
  const Program program = buildProgram(
      {{GL_VERTEX_SHADER, kVertex}, {GL_FRAGMENT_SHADER, kFragment}}, {}, "gbuffers_terrain");
  ASSERT_TRUE(program.linked) << program.stageLogs[0] << program.stageLogs[1] << program.linkLog;
  struct Expected {
    const char* name;
    unsigned type;
    int size;
  };
  const Expected expected[] = {
      {"gbufferModelView", GL_FLOAT_MAT4, 1},  {"weights", GL_FLOAT, 4},
      {"lights[0].reach", GL_FLOAT, 1},        {"lights[1].color", GL_FLOAT_VEC3, 1},
      {"colortex0", GL_SAMPLER_2D, 1},         {"voxels", GL_UNSIGNED_INT_SAMPLER_3D, 2},
      {"shadowtex0", GL_SAMPLER_2D_SHADOW, 1}, {"colorimg3", GL_IMAGE_2D, 1}};
  for (const Expected& row : expected) {
    const ActiveVariable* variable = find(program.uniforms, row.name);
    ASSERT_NE(variable, nullptr) << row.name;
    EXPECT_EQ(variable->type, row.type) << row.name;
    EXPECT_EQ(variable->size, row.size) << row.name;
    EXPECT_GE(variable->location, 0) << row.name;
  }
}

TEST_F(ProgramTest, tells_its_attributes_and_which_are_built_in) {
  const Program program = buildProgram(
      {{GL_VERTEX_SHADER, kVertex}, {GL_FRAGMENT_SHADER, kFragment}}, {}, "gbuffers_terrain");
  ASSERT_TRUE(program.linked);
  EXPECT_EQ(find(program.attributes, "mc_Entity")->type, unsigned(GL_FLOAT_VEC3));
  EXPECT_GE(find(program.attributes, "mc_Entity")->location, 0);
  EXPECT_EQ(find(program.attributes, "vaUV2")->type, unsigned(GL_INT_VEC2));
  ASSERT_NE(find(program.attributes, "gl_Vertex"), nullptr);
  EXPECT_EQ(find(program.attributes, "gl_Vertex")->location, -1);
  EXPECT_THAT(program.computeLocalSize, IsEmpty());
}

TEST_F(ProgramTest, binds_the_fragment_outputs_by_name) {
  for (const int first : {0, 1}) {
    const Program program =
        buildProgram({{GL_VERTEX_SHADER, kVertex}, {GL_FRAGMENT_SHADER, kFragment}},
                     {{"outColor0", first}, {"outColor1", 1 - first}}, "gbuffers_terrain");
    ASSERT_TRUE(program.linked);
    EXPECT_EQ(GetFragDataLocation(program.id(), "outColor0"), first);
    EXPECT_EQ(GetFragDataLocation(program.id(), "outColor1"), 1 - first);
  }
}

TEST_F(ProgramTest, of_compute_tells_its_local_size) {
  const Program program = buildProgram({{GL_COMPUTE_SHADER, R"(#version 430
layout(local_size_x = 8, local_size_y = 4, local_size_z = 2) in;
layout(std430, binding = 0) buffer Out { uint counts[]; };
uniform int step_;
void main() { counts[gl_LocalInvocationIndex] = uint(step_); })"}},
                                       {}, "shadowcomp");
  ASSERT_TRUE(program.linked) << program.stageLogs[0];
  EXPECT_THAT(program.computeLocalSize, ElementsAre(8, 4, 2));
  ASSERT_EQ(program.uniforms.size(), 1u);
  EXPECT_EQ(program.uniforms[0].name, "step_");
}

TEST_F(ProgramTest, keeps_the_log_of_each_stage_that_fails) {
  const Program program =
      buildProgram({{GL_VERTEX_SHADER, "#version 330\nvoid main() {\n  gl_Position = wrong;\n}\n"},
                    {GL_FRAGMENT_SHADER, "#version 330\nout vec4 c;\nvoid main() { c = 1; }\n"}},
                   {}, "composite");
  EXPECT_FALSE(program.linked);
  EXPECT_EQ(program.id(), 0u);
  EXPECT_THAT(program.stageFailed, ElementsAre(true, true));
  EXPECT_THAT(program.stageLogs[0], HasSubstr("wrong"));
  EXPECT_THAT(program.stageLogs[0], HasSubstr("3"));
  EXPECT_THAT(program.stageLogs[1], HasSubstr("3"));
  EXPECT_THAT(program.linkLog, IsEmpty());
}

TEST_F(ProgramTest, a_good_stage_beside_a_failed_one_is_distinguished) {
  const Program program = buildProgram(
      {{GL_VERTEX_SHADER, kVertex}, {GL_FRAGMENT_SHADER, "#version 330\nnonsense\n"}}, {}, "final");
  EXPECT_THAT(program.stageFailed, ElementsAre(false, true));
}

TEST_F(ProgramTest, keeps_the_log_of_a_failed_link) {
  const Program program = buildProgram(
      {{GL_VERTEX_SHADER, "#version 330\nout vec3 a;\nvoid main() { gl_Position = vec4(a, 1); }\n"},
       {GL_FRAGMENT_SHADER,
        "#version 330\nin vec2 a;\nout vec4 c;\nvoid main() { c = vec4(a, 0, 1); }\n"}},
      {}, "composite1");
  EXPECT_FALSE(program.linked);
  EXPECT_EQ(program.id(), 0u);
  EXPECT_THAT(program.stageFailed, ElementsAre(false, false));
  EXPECT_THAT(program.linkLog, HasSubstr("a"));
}

TEST_F(ProgramTest, source_need_not_end_with_a_nul) {
  const std::string text = std::string(kFragment) + "this is not part of the source";
  const Program program =
      buildProgram({{GL_VERTEX_SHADER, kVertex},
                    {GL_FRAGMENT_SHADER, std::string_view(text).substr(0, kFragment.size())}},
                   {}, "cut");
  EXPECT_TRUE(program.linked);
}

TEST(OpaqueTypes, are_distinguished) {
  EXPECT_TRUE(isSampler(GL_SAMPLER_3D));
  EXPECT_TRUE(isSampler(GL_SAMPLER_2D_SHADOW));
  EXPECT_FALSE(isSampler(GL_IMAGE_2D));
  EXPECT_FALSE(isSampler(GL_FLOAT_VEC4));
  EXPECT_TRUE(isShadowSampler(GL_SAMPLER_2D_SHADOW));
  EXPECT_FALSE(isShadowSampler(GL_SAMPLER_2D));
  EXPECT_TRUE(isImage(GL_UNSIGNED_INT_IMAGE_3D));
  EXPECT_FALSE(isImage(GL_SAMPLER_2D));
  EXPECT_EQ(dimensionsOf(GL_SAMPLER_1D), 1);
  EXPECT_EQ(dimensionsOf(GL_SAMPLER_2D_SHADOW), 2);
  EXPECT_EQ(dimensionsOf(GL_UNSIGNED_INT_IMAGE_3D), 3);
  EXPECT_EQ(dimensionsOf(GL_SAMPLER_CUBE), 0);
  EXPECT_EQ(dimensionsOf(GL_FLOAT), 0);
}

}  // namespace
}  // namespace orris::gl
