// Rows of docs/contract.md that only a drawn frame can show.
#include "render/render_fixture.h"

namespace orris {
namespace {

class ContractGL : public RenderTest {
 protected:
  /// Draws the floor with `fragment` in `program`, whose output goes to colortex1, and gives the
  /// pixel in the middle.
  std::vector<float> drawn(const std::string& program, const std::string& fragment,
                           const std::string& vertex = kVertex) {
    addProgram(program,
               "/* RENDERTARGETS: 1 */\n/*\nconst int colortex1Format = RGBA32F;\n*/\n" + fragment);
    files_["/" + program + ".vsh"] = vertex;
    addProgram("final",
               "uniform sampler2D colortex1;\nvoid main() {\n"
               "  gl_FragData[0] = texture2D(colortex1, uv); }\n");
    if (!start(floorWorld())) {
      ADD_FAILURE() << messages();
      return {};
    }
    draw();
    return pixel("colortex1", 16, 16);
  }

  /// What the vertex shader of `program` stores in `value`, a vec4.
  std::vector<float> vertexValue(const std::string& attributes, const std::string& code,
                                 const std::string& program = "gbuffers_terrain") {
    return drawn(program, "flat in vec4 value;\nvoid main() { gl_FragData[0] = value; }\n",
                 "#version 330 compatibility\n" + attributes + "\nout vec2 uv;\nflat out vec4 value;\nvoid main() {\n" +
                     "  gl_Position = ftransform();\n  uv = gl_MultiTexCoord0.xy;\n" + code + "\n}\n");
  }
};

TEST_F(ContractGL, fixed_function_state_reaches_fullscreen_programs) {
  const auto value = drawn("composite", R"(uniform float far;
void main() {
  bool matrices = gl_ModelViewMatrix == mat4(1.0) && gl_TextureMatrix[7] == mat4(1.0) &&
                  gl_ProjectionMatrix[0][0] == 2.0 && gl_ProjectionMatrix[3][0] == -1.0 &&
                  gl_NormalMatrix == mat3(1.0);
  gl_FragData[0] = vec4(matrices, gl_Fog.end == far, abs(gl_Fog.start - 0.9 * far) < 0.1, 1.0);
}
)");
  EXPECT_EQ(value, (std::vector<float>{1, 1, 1, 1}));
}

TEST_F(ContractGL, every_attribute_has_its_value) {
  const auto value = vertexValue(R"(in vec3 vaPosition; in vec4 vaColor; in vec2 vaUV0; in ivec2 vaUV2; in vec3 vaNormal;
in vec2 mc_midTexCoord; in vec4 at_tangent;)",
                                 R"(
  bool core = vaPosition == gl_Vertex.xyz && vaColor == gl_Color && vaUV0 == gl_MultiTexCoord0.xy &&
              distance(vaNormal, gl_Normal) < 0.01;
  bool light = vaUV2 == ivec2(gl_MultiTexCoord1.xy) && gl_MultiTexCoord1 == gl_MultiTexCoord2;
  bool other = gl_MultiTexCoord3.xy == mc_midTexCoord && gl_MultiTexCoord5 == vec4(0, 0, 0, 1) &&
               abs(dot(at_tangent.xyz, vaNormal)) < 0.01;
  value = vec4(core, light, other, 1.0);)");
  EXPECT_EQ(value, (std::vector<float>{1, 1, 1, 1}));
}

TEST_F(ContractGL, attributes_without_data_have_their_constant) {
  const auto value = vertexValue("in ivec2 vaUV1; in float mc_chunkFade; in vec3 at_velocity;",
                                 "value = vec4(vaUV1 == ivec2(0, 10), mc_chunkFade == 1.0, at_velocity == vec3(0), 1.0);");
  EXPECT_EQ(value, (std::vector<float>{1, 1, 1, 1}));
}

TEST_F(ContractGL, chunks_have_faded_in_and_nothing_else_has) {
  const auto fade = [&](const std::string& program) {
    return vertexValue("in float mc_chunkFade;", "value = vec4(mc_chunkFade, 0, 0, 1);", program);
  };
  EXPECT_EQ(fade("gbuffers_terrain"), (std::vector<float>{1, 0, 0, 1}));
  EXPECT_EQ(fade("composite"), (std::vector<float>{-1, 0, 0, 1}));
}

TEST_F(ContractGL, samplers_of_geometry_programs_have_their_textures) {
  const auto value = drawn("gbuffers_terrain", R"(
uniform sampler2D gtexture, normals, specular, lightmap;
void main() {
  vec4 normal = texture2D(normals, uv);
  bool atlas = textureSize(gtexture, 0) == textureSize(normals, 0) &&
               textureSize(gtexture, 0) == textureSize(specular, 0) && texture2D(gtexture, uv).a == 1.0;
  gl_FragData[0] = vec4(atlas, normal.b > 0.5, textureSize(lightmap, 0) == ivec2(16), 1.0);
}
)");
  EXPECT_EQ(value, (std::vector<float>{1, 1, 1, 1}));
}

TEST_F(ContractGL, distant_depth_is_empty) {
  const auto value = drawn("composite", R"(
uniform sampler2D dhDepthTex, dhDepthTex0, dhDepthTex1;
void main() {
  gl_FragData[0] = vec4(texture2D(dhDepthTex, uv).r, texture2D(dhDepthTex0, uv).r,
                        texture2D(dhDepthTex1, uv).r, 1.0);
}
)");
  EXPECT_EQ(value, (std::vector<float>{1, 1, 1, 1}));
}

}  // namespace
}  // namespace orris
