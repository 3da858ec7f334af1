// Names and types of what shaders declare: the contract's, custom ones, misspelt ones.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "declaration_fixture.h"

namespace orris {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(Names, known_and_own_names_are_silent) {
  EXPECT_THAT(messages(fragmentOf(
                  "uniform float frameTimeCounter, mine, preset = 1.0;\n"
                  "uniform sampler2D colortex5;\nuniform sampler2D lut;\n"
                  "uniform int hideGUI;\nuniform mat4 vxProj;\n"
                  "void main() { gl_FragColor = texture2D(colortex5, vec2(mine)) * "
                  "texture2D(lut, vec2(preset)) * frameTimeCounter * hideGUI * vxProj[0]; }",
                  "uniform.float.mine = 1.0\ncustomTexture.lut = minecraft:a.png\n")),
              IsEmpty());
}

TEST(Names, an_unknown_one_that_is_used_gets_the_nearest) {
  const Files files = fragmentOf(
      "uniform float frameTimeCounterr;\nuniform sampler2D colortexx5;\nuniform float unused1;\n"
      "void main() { gl_FragColor = texture2D(colortexx5, vec2(frameTimeCounterr)); }");
  EXPECT_THAT(messages(files),
              ElementsAre("uniform-unknown /composite.fsh:2:15: warning: no uniform is called "
                          "'frameTimeCounterr'",
                          "uniform-unknown /composite.fsh:3:19: warning: no sampler is called "
                          "'colortexx5'"));
  EXPECT_THAT(messages(files, "iris", true).back(),
              "uniform-unknown /composite.fsh:4:15: note: no uniform is called 'unused1'");
}

TEST(Names, what_a_fullscreen_program_does_not_get_is_not_proposed) {
  const auto hintOf = [](const std::string& program) {
    const ShaderPack pack = loadClean({{"/" + program + ".vsh", kVertexStage},
                                       {"/" + program + ".fsh", kVersion + "uniform sampler2D specularr;\n"
                                        "void main() { gl_FragColor = texture2D(specularr, vec2(0)); }"}});
    Diagnostics diagnostics;
    const Schedule schedule = buildSchedule(pack, 64, 32, {}, diagnostics);
    checkDeclarations({.pack = pack, .schedule = schedule, .target = *findTarget("iris")}, diagnostics);
    const auto found = std::ranges::find(diagnostics, "uniform-unknown", &Diagnostic::id);
    return found == diagnostics.end() ? "" : found->hint;
  };
  EXPECT_EQ(hintOf("gbuffers_basic"), "did you mean specular?");
  EXPECT_EQ(hintOf("composite"),
            "it reads texture unit 0: gtexture in gbuffers and shadow programs, colortex0 in fullscreen ones");
}

TEST(Names, used_by_one_program_is_used) {
  Files files = fragmentOf("#include \"/u.glsl\"\nvoid main() { gl_FragColor = vec4(1); }");
  files["/u.glsl"] = "uniform float nothing;\n";
  files["/final.vsh"] = kVertexStage;
  files["/final.fsh"] =
      kVersion + "#include \"/u.glsl\"\nvoid main() { gl_FragColor = vec4(nothing); }";
  EXPECT_THAT(messages(files), ElementsAre("uniform-unknown /u.glsl:1:15: warning: no uniform is "
                                           "called 'nothing'"));
}

TEST(Names, a_misspelt_declaration_is_found_although_only_the_right_name_is_used) {
  EXPECT_THAT(messages(fragmentOf("uniform float frameTimeCountr;\n"
                                  "void main() { gl_FragColor = vec4(frameTimeCounter); }")),
              ElementsAre("uniform-unknown /composite.fsh:2:15: warning: no uniform is called "
                          "'frameTimeCountr'"));
}

TEST(Names, an_unused_declaration_one_slip_from_a_known_name_is_a_warning) {
  EXPECT_THAT(messages(fragmentOf("uniform float playreMood;\nuniform sampler2D colotrex5;\n"
                                  "uniform sampler2D colortex55;\nuniform vec3 mineX;\n"
                                  "void main() { gl_FragColor = vec4(1); }",
                                  "uniform.float.mine = 1.0\n")),
              ElementsAre("uniform-unknown /composite.fsh:2:15: warning: no uniform is called "
                          "'playreMood'",
                          "uniform-unknown /composite.fsh:3:19: warning: no sampler is called "
                          "'colotrex5'"));
}

TEST(Names, a_misspelt_attribute_is_found_although_the_host_declares_the_right_one) {
  Files files = fragmentOf("void main() { gl_FragColor = vec4(1); }");
  files["/composite.vsh"] = kVersion +
                            "in vec3 vaNromal;\n"
                            "void main() { gl_Position = vec4(vaNormal, 1.0); }\n";
  EXPECT_THAT(messages(files),
              ElementsAre("attribute-unknown /composite.vsh:2:9: warning: no attribute is called "
                          "'vaNromal'"));
}

TEST(Names, a_global_that_nothing_uses_does_not_use_its_initialiser) {
  EXPECT_THAT(messages(fragmentOf("uniform float foo;\nfloat bar = foo * 2.0;\n"
                                  "void main() { gl_FragColor = vec4(1); }")),
              IsEmpty());
}

TEST(Names, variables_of_shaders_properties_are_not_seen_by_shaders) {
  EXPECT_THAT(
      messages(fragmentOf("uniform float step1;\nvoid main() { gl_FragColor = vec4(step1); }",
                          "variable.float.step1 = 1.0\n")),
      ElementsAre("uniform-unknown /composite.fsh:2:15: warning: 'step1' is a variable of "
                  "shaders.properties, which shaders do not see"));
}

TEST(Names, an_attribute_that_is_a_uniform_is_said_to_be_one) {
  const ShaderPack pack =
      loadClean(packOf("in int blockEntityId;\nvoid main() { gl_Position = vec4(blockEntityId); }",
                        "void main() { gl_FragColor = vec4(1); }"));
  Diagnostics diagnostics;
  const Schedule schedule = buildSchedule(pack, 64, 32, {}, diagnostics);
  checkDeclarations({.pack = pack, .schedule = schedule, .target = *findTarget("iris")},
                    diagnostics);
  ASSERT_EQ(diagnostics.size(), 1u);
  EXPECT_EQ(diagnostics[0].hint, "it is a uniform: write uniform int blockEntityId;");
}

TEST(Names, unknown_attributes) {
  EXPECT_THAT(messages(packOf("in vec4 at_tangant;\nin vec4 mc_Entity;\n"
                              "void main() { gl_Position = at_tangant + mc_Entity; }",
                              "void main() { gl_FragColor = vec4(1); }")),
              ElementsAre("attribute-unknown /composite.vsh:2:9: warning: no attribute is called "
                          "'at_tangant'"));
}

TEST(Names, attributes_with_a_number_may_be_found_by_it) {
  EXPECT_THAT(messages(packOf("layout(location = 0) in vec4 place;\n"
                              "void main() { gl_Position = place; }",
                              "void main() { gl_FragColor = vec4(1); }")),
              IsEmpty());
}

TEST(Names, a_declaration_made_by_a_macro_is_located_where_it_is_used) {
  EXPECT_THAT(messages(fragmentOf("#define DECLARE(name) uniform float name;\n\nDECLARE(nothing)\n"
                                  "void main() { gl_FragColor = vec4(nothing); }")),
              ElementsAre("uniform-unknown /composite.fsh:4:9: warning: no uniform is called "
                          "'nothing'"));
}

TEST(Types, of_the_contract_and_of_custom_uniforms) {
  EXPECT_THAT(messages(fragmentOf("uniform int frameTimeCounter;\nuniform vec3 mine;\n"
                                  "void main() { gl_FragColor = vec4(mine, frameTimeCounter); }",
                                  "uniform.float.mine = 1.0\n")),
              ElementsAre("uniform-type /composite.fsh:2:13: error: 'frameTimeCounter' is declared "
                          "as int, the host gives float",
                          "uniform-type /composite.fsh:3:14: error: 'mine' is declared as vec3, "
                          "shaders.properties gives float"));
}

TEST(Types, samplers_and_formats) {
  EXPECT_THAT(
      messages(fragmentOf("/*\nconst int colortex4Format = RG32UI;\n*/\n"
                          "uniform sampler2D colortex4;\nuniform usampler2D colortex5;\n"
                          "uniform sampler3D colortex6;\nuniform sampler2DShadow shadowtex0;\n"
                          "void main() { gl_FragColor = texture(colortex4, vec2(0)) + "
                          "texture(colortex5, vec2(0)) + texture(colortex6, vec3(0)) + "
                          "texture(shadowtex0, vec3(0)); }")),
      ElementsAre(
          "sampler-format /composite.fsh:5:19: warning: sampler2D cannot read colortex4, "
          "whose format is RG32UI",
          "sampler-format /composite.fsh:6:20: warning: usampler2D cannot read colortex5, "
          "whose format is RGBA",
          "sampler-type /composite.fsh:7:19: warning: sampler3D cannot read colortex6, whose "
          "format is RGBA",
          "sampler-type /composite.fsh:8:25: warning: sampler2DShadow reads shadowtex0, "
          "which is not compared"));
}

TEST(Types, hardware_samplers_are_bound_where_shadow_maps_are_compared) {
  const auto reads = [](const std::string& first) {
    return messages(fragmentOf(first + "uniform sampler2DShadow shadowtex0HW, shadowtex1HW;\nvoid main() { "
                                       "gl_FragColor = vec4(texture(shadowtex0HW, vec3(0))); }",
                               "iris.features.required=SEPARATE_HARDWARE_SAMPLERS\n"),
                    "iris", true);
  };
  EXPECT_THAT(reads(""), ElementsAre("sampler-type /composite.fsh:2:25: warning: shadowtex0HW is bound only "
                                     "where shadow maps are compared",
                                     "sampler-type /composite.fsh:2:39: note: shadowtex1HW is bound only "
                                     "where shadow maps are compared"));
  EXPECT_THAT(reads("const bool shadowHardwareFiltering = true;\n"), IsEmpty());
}

TEST(Types, an_image_instead_of_a_buffer_is_flat) {
  EXPECT_THAT(messages(fragmentOf("uniform samplerCube colortex4;\nvoid main() { gl_FragColor = "
                                  "texture(colortex4, vec3(0)); }",
                                  "texture.composite.colortex4 = minecraft:textures/atlas/"
                                  "blocks.png\n")),
              ElementsAre("sampler-type /composite.fsh:2:21: warning: samplerCube cannot read "
                          "minecraft:textures/atlas/blocks.png"));
  EXPECT_THAT(messages(fragmentOf("uniform samplerCube colortex4;\nvoid main() { gl_FragColor = "
                                  "vec4(1); }",
                                  "texture.composite.colortex4 = minecraft:textures/atlas/"
                                  "blocks.png\n")),
              IsEmpty());
}

TEST(Types, custom_images_and_their_samplers_have_the_type_of_their_format) {
  const auto shader = [](const std::string& image, const std::string& sampler) {
    return fragmentOf("layout(r32ui) uniform " + image + " cells;\nuniform " + sampler +
                          " cellSampler;\nvoid main() {\n  imageStore(cells, ivec3(0), uvec4(0));\n"
                          "  gl_FragColor = vec4(texture(cellSampler, vec3(0)).r);\n}",
                      "iris.features.required=CUSTOM_IMAGES\n"
                      "image.cells=cellSampler RED_INTEGER R32UI UNSIGNED_INT false false 4 4 4\n");
  };
  EXPECT_THAT(messages(shader("uimage3D", "usampler3D")), IsEmpty());
  EXPECT_THAT(
      messages(shader("image3D", "sampler3D")),
      ElementsAre("sampler-format /composite.fsh:2:31: warning: image3D cannot read cells, whose "
                  "format is R32UI",
                  "sampler-format /composite.fsh:3:19: warning: sampler3D cannot read cellSampler, "
                  "whose format is R32UI"));
}

TEST(Types, integer_images_of_one_float_are_a_note) {
  EXPECT_THAT(
      messages(fragmentOf("/*\nconst int colortex4Format = R32F;\nconst int colortex5Format = RG32F;\n"
                          "*/\nlayout(r32ui) uniform uimage2D colorimg4;\n"
                          "layout(rg32ui) uniform uimage2D colorimg5;\n"
                          "void main() { imageAtomicMin(colorimg4, ivec2(0), 1u); "
                          "imageStore(colorimg5, ivec2(0), uvec4(0)); gl_FragColor = vec4(1); }"),
               "iris", true),
      AllOf(Contains("sampler-format /composite.fsh:6:32: note: uimage2D cannot read colortex4, "
                     "whose format is R32F"),
            Contains("sampler-format /composite.fsh:7:33: warning: uimage2D cannot read colortex5, "
                     "whose format is RG32F")));
}

TEST(Types, a_raw_texture_may_have_any_type) {
  Files files = fragmentOf(
      "uniform sampler3D colortex6;\n"
      "void main() { gl_FragColor = texture(colortex6, vec3(0)); }",
      "texture.composite.colortex6 = a.dat TEXTURE_3D RGBA8 2 2 2 RGBA "
      "UNSIGNED_BYTE\n");
  files["/a.dat"] = std::string(32, 'x');
  EXPECT_THAT(messages(files), IsEmpty());
}

}  // namespace
}  // namespace orris
