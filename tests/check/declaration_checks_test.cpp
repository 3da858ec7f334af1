// Varyings, outputs and limits.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "declaration_fixture.h"

namespace orris {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

// ---- varyings

TEST(Varyings, a_pair_that_fits_is_silent) {
  EXPECT_THAT(
      messages(packOf("out vec2 uv;\nflat out int id;\nvoid main() { uv = vec2(0); id = 1; }",
                      "in vec2 uv;\nflat in int id;\nvoid main() { gl_FragColor = "
                      "vec4(uv, id, 1); }")),
      IsEmpty());
}

TEST(Varyings, another_width_is_one_finding_with_both_declarations) {
  EXPECT_THAT(
      messages(packOf("out vec3 tint;\nvoid main() { tint = vec3(1); }",
                      "\nin vec2 tint;\nvoid main() { gl_FragColor = tint.xyxy; }")),
      ElementsAre(
          "varying-type /composite.fsh:3:9: warning: 'tint' is vec3 in the vertex stage and "
          "vec2 in the fragment stage; /composite.vsh:2:10: the other declaration"));
}

TEST(Varyings, matrices_of_two_sizes_are_converted) {
  EXPECT_THAT(messages(packOf("out mat3 sky;\nvoid main() { sky = mat3(1); }",
                              "in mat4x3 sky;\nvoid main() { gl_FragColor = sky[0].xyzx; }")),
              ElementsAre(testing::HasSubstr("warning: 'sky' is mat3 in the vertex stage and mat4x3")));
}

TEST(Varyings, what_iris_cannot_convert_is_an_error) {
  EXPECT_THAT(
      messages(packOf("out mat3 tbn;\nvoid main() { tbn = mat3(1); }",
                      "in vec3 tbn;\nvoid main() { gl_FragColor = tbn.xyzx; }")),
      ElementsAre("varying-type /composite.fsh:2:9: error: 'tbn' is mat3 in the vertex stage and "
                  "vec3 in the fragment stage; /composite.vsh:2:10: the other declaration"));
}

TEST(Varyings, array_sizes_are_compared_where_they_are_known) {
  EXPECT_THAT(
      messages(packOf("const int N = 2;\nout vec3 a[N + 1];\nvoid main() { a[0] = vec3(1); }",
                      "in vec3 a[3];\nvoid main() { gl_FragColor = a[0].xyzx; }")),
      IsEmpty());
  EXPECT_THAT(messages(packOf("out vec3 a[2];\nvoid main() { a[0] = vec3(1); }",
                              "in vec3 a[3];\nvoid main() { gl_FragColor = a[0].xyzx; }")),
              ElementsAre("varying-type /composite.fsh:2:9: error: 'a' is vec3[2] in the vertex "
                          "stage and vec3[3] in the fragment stage; /composite.vsh:2:10: the other "
                          "declaration"));
}

TEST(Varyings, flat_on_one_side_only) {
  EXPECT_THAT(
      messages(packOf("out vec3 a;\nvoid main() { a = vec3(1); }",
                      "flat in vec3 a;\nvoid main() { gl_FragColor = a.xyzx; }")),
      ElementsAre("varying-interpolation /composite.fsh:2:14: warning: 'a' is smooth in the "
                  "vertex stage and flat in the fragment stage; /composite.vsh:2:10: the other "
                  "declaration"));
}

TEST(Varyings, from_glsl_440_on_the_fragment_stage_alone_says_how_it_interpolates) {
  const std::string vertex = "out vec3 a;\nvoid main() { a = vec3(1); }";
  const std::string fragment = "flat in vec3 a;\nvoid main() { gl_FragColor = a.xyzx; }";
  const std::string version = "#version 460 compatibility\n";
  EXPECT_THAT(messages({{"/composite.vsh", version + vertex}, {"/composite.fsh", version + fragment}}),
              IsEmpty());
  EXPECT_THAT(messages({{"/composite.vsh", kVersion + vertex}, {"/composite.fsh", version + fragment}}),
              testing::SizeIs(1));
}

TEST(Varyings, a_missing_one_names_the_line_that_declares_it_for_other_options) {
  const ShaderPack pack = loadClean(
      packOf("#ifdef LATER\nflat out int a;\n#endif\nvoid main() { gl_Position = ftransform(); }",
             "flat in int a;\nvoid main() { gl_FragColor = vec4(a); }"));
  Diagnostics diagnostics;
  const Schedule schedule = buildSchedule(pack, 64, 32, {}, diagnostics);
  checkDeclarations({.pack = pack, .schedule = schedule, .target = *findTarget("iris")},
                    diagnostics);
  const auto missing = std::ranges::find_if(
      diagnostics, [](const Diagnostic& d) { return d.id == "varying-missing"; });
  ASSERT_NE(missing, diagnostics.end());
  EXPECT_THAT(missing->notes,
              ElementsAre("in /composite", "/composite.vsh:3 declares it for other options or programs"));
}

TEST(Varyings, a_missing_one_is_reported_only_where_it_is_read) {
  EXPECT_THAT(
      messages(
          fragmentOf("in vec3 a;\nin vec3 b;\nvoid unused() { b; }\nvoid unused2() { unused(); }\n"
                     "void main() { gl_FragColor = a.xyzx; }")),
      ElementsAre("varying-missing /composite.fsh:2:9: warning: 'a' is read here, and the vertex "
                  "stage does not declare it"));
}

TEST(Varyings, locations_match_before_names) {
  EXPECT_THAT(
      messages(packOf("layout(location = 3) out vec3 a;\nvoid main() { a = vec3(1); }",
                      "layout(location = 3) in vec3 b;\nvoid main() { gl_FragColor = b.xyzx; }")),
      IsEmpty());
}

TEST(Varyings, blocks_match_by_block_name_and_members) {
  const std::string vertex =
      "out Data { vec2 uv; vec4 color; } data;\nvoid main() { data.uv = vec2(1); }";
  EXPECT_THAT(messages(packOf(vertex,
                              "in Data { vec2 uv; vec4 color; } v;\n"
                              "void main() { gl_FragColor = v.color; }")),
              IsEmpty());
  EXPECT_THAT(messages(packOf(vertex,
                              "in Data { vec3 uv; vec4 color; } v;\n"
                              "void main() { gl_FragColor = v.color; }")),
              ElementsAre("varying-type /composite.fsh:2:4: error: 'Data' has other members in the "
                          "vertex stage than in the fragment stage; /composite.vsh:2:5: the other "
                          "declaration"));
  EXPECT_THAT(
      messages(packOf(vertex,
                      "in Other { vec2 uv; } v;\n"
                      "void main() { gl_FragColor = v.uv.xyxy; }")),
      ElementsAre("varying-missing /composite.fsh:2:4: error: 'Other' is read here, and the "
                  "vertex stage does not declare it"));
}

TEST(Varyings, geometry_stages_see_arrays) {
  Files files = packOf("out vec2 uv;\nvoid main() { uv = vec2(0); }",
                       "in vec2 uvOut;\nvoid main() { gl_FragColor = uvOut.xyxy; }");
  files["/composite.gsh"] = kVersion +
                            "layout(triangles) in;\nlayout(triangle_strip, max_vertices = 3) out;\n"
                            "in vec2 uv[];\nout vec2 uvOut;\n"
                            "void main() { uvOut = uv[0]; EmitVertex(); }";
  EXPECT_THAT(messages(files), IsEmpty());
  files["/composite.gsh"].replace(files["/composite.gsh"].find("in vec2 uv[]"), 12, "in vec3 uv[]");
  EXPECT_THAT(messages(files),
              ElementsAre("varying-type /composite.gsh:4:9: warning: 'uv' is vec2 in the vertex "
                          "stage and vec3 in the geometry stage; /composite.vsh:2:10: the other "
                          "declaration"));
}

TEST(Varyings, never_written_in_any_branch) {
  const std::string fragment = "in vec3 a;\nvoid main() { gl_FragColor = a.xyzx; }";
  EXPECT_THAT(messages(packOf("out vec3 a;\nvoid main() {}", fragment)),
              ElementsAre("varying-unwritten /composite.vsh:2:10: warning: 'a' is never written, "
                          "and the fragment stage reads it"));
  EXPECT_THAT(
      messages(packOf("out vec3 a;\nvoid main() {\n#ifdef NO\na.x = 1.0;\n#endif\n}", fragment)),
      IsEmpty());
  // What a function does with its argument is known only where it is compiled.
  EXPECT_THAT(
      messages(packOf("out vec3 a;\nvoid main() {\n#ifdef NO\nfill(1, a);\n#endif\n}", fragment)),
      IsEmpty());
}

TEST(Varyings, one_that_nobody_reads_is_a_note) {
  EXPECT_THAT(messages(packOf("out vec3 a;\nvoid main() { a = vec3(1); }",
                              "void main() { gl_FragColor = vec4(1); }"),
                       "iris", true),
              ElementsAre("varying-unread /composite.vsh:2:10: note: 'a' is written, and the "
                          "fragment stage does not read it"));
}

TEST(Varyings, of_the_hosts_own_vertex_stage_are_none_of_the_authors) {
  EXPECT_THAT(messages({{"/gbuffers_basic.fsh",
                         kVersion + "in vec4 mine;\nvoid main() { gl_FragColor = mine; }\n"}},
                       "iris", true),
              ElementsAre(testing::StartsWith("varying-missing /gbuffers_basic.fsh:2:9: ")));
}

TEST(Varyings, one_renamed_in_one_stage_is_one_finding_with_both_places) {
  EXPECT_THAT(messages(packOf("out vec3 a;\nout vec2 c;\nvoid main() { a = vec3(1); c = a.xy; }",
                              "in vec3 b;\nvoid main() { gl_FragColor = b.xyzx; }")),
              ElementsAre("varying-missing /composite.fsh:2:9: warning: 'b' is read here, and the "
                          "vertex stage does not declare it; /composite.vsh:2:10: 'a', which is not "
                          "read"));
  // Which of two was meant nobody knows.
  EXPECT_THAT(messages(packOf("out vec3 a;\nout vec3 c;\nvoid main() { a = vec3(1); c = a; }",
                              "in vec3 b;\nvoid main() { gl_FragColor = b.xyzx; }")),
              ElementsAre("varying-missing /composite.fsh:2:9: warning: 'b' is read here, and the "
                          "vertex stage does not declare it"));
}

TEST(Varyings, one_misspelt_where_it_is_declared_is_reported_there) {
  EXPECT_THAT(messages(packOf("out vec3 torhcLight;\nout vec3 moonLight;\n"
                              "void main() { torchLight = moonLight = vec3(1); }",
                              "in vec3 torchLight;\nin vec3 moonLight;\n"
                              "void main() { gl_FragColor = vec4(torchLight + moonLight, 1); }")),
              ElementsAre("varying-missing /composite.vsh:2:10: warning: 'torchLight' is read in the "
                          "fragment stage, and the vertex stage declares 'torhcLight'; "
                          "/composite.fsh:2:9: where 'torchLight' is read"));
  // Both names occur where they are declared: neither is known to be wrong.
  EXPECT_THAT(messages(packOf("out vec3 torhcLight;\nvoid main() { torhcLight = vec3(1); }",
                              "in vec3 torchLight;\nvoid main() { gl_FragColor = torchLight.xyzx; }")),
              ElementsAre("varying-missing /composite.fsh:2:9: warning: 'torchLight' is read here, and "
                          "the vertex stage does not declare it; /composite.vsh:2:10: 'torhcLight', "
                          "which is not read"));
}

// ---- outputs

TEST(Outputs, a_program_that_computes_and_writes_nothing) {
  EXPECT_THAT(messages(fragmentOf("void main() {\n  vec4 a = gl_FragCoord;\n}\n")),
              ElementsAre("output-none /composite.fsh:4:1: warning: main() ends here, and the "
                          "program has written nothing"));
  EXPECT_THAT(messages(fragmentOf("void main() {\n  float a = 1.0;\n  if (a > 0.0) discard;\n}\n")),
              IsEmpty());
  EXPECT_THAT(messages(fragmentOf("void main() {\n}\n")), IsEmpty());
}

TEST(Outputs, one_beyond_the_list) {
  EXPECT_THAT(
      messages(fragmentOf("/* RENDERTARGETS: 0,3 */\nlayout(location = 0) out vec4 a;\n"
                          "layout(location = 3) out vec4 b;\n"
                          "void main() { a = vec4(1); b = vec4(1); }")),
      ElementsAre("output-unlisted /composite.fsh:4:31: warning: 'b' at location 3 is "
                  "written to no buffer: the program draws to colortex0, colortex3",
                  "output-unwritten /composite.fsh:2:1: warning: buffer 3 is listed, and the "
                  "program writes nothing to it"));
  EXPECT_THAT(messages(fragmentOf("void main() { gl_FragData[0] = vec4(1); gl_FragData[1] = "
                                  "vec4(1); }")),
              ElementsAre("output-unlisted /composite.fsh:2:41: warning: gl_FragData[1] is written "
                          "to no buffer: the program draws to colortex0"));
}

TEST(Outputs, several_that_nothing_is_written_to_are_one_finding) {
  EXPECT_THAT(messages(fragmentOf("/* DRAWBUFFERS:035 */\nvoid main() { gl_FragData[0] = vec4(1); }")),
              ElementsAre("output-unwritten /composite.fsh:2:1: warning: buffers 3, 5 are listed, and "
                          "the program writes nothing to them"));
}

TEST(Outputs, final_has_the_screen_alone) {
  const std::string vertex = kVersion + "void main() { gl_Position = vec4(0); }\n";
  const auto final = [&](const std::string& list) {
    return messages({{"/final.vsh", vertex},
                     {"/final.fsh", kVersion + "/* RENDERTARGETS: " + list + " */\n" +
                                        "void main() { gl_FragData[0] = vec4(1); }\n"}});
  };
  EXPECT_THAT(final("0,7"), ElementsAre("output-unwritten /final.fsh:2:1: warning: final draws to the "
                                        "screen only: the buffers listed get nothing"));
  EXPECT_THAT(final("0"), IsEmpty());
}

TEST(Outputs, several_beyond_the_list_are_one_finding) {
  const ShaderPack pack = loadClean(fragmentOf(
      "void main() { gl_FragData[0] = gl_FragData[1] =\ngl_FragData[2] = gl_FragData[1] = vec4(1); }"));
  Diagnostics diagnostics;
  const Schedule schedule = buildSchedule(pack, 64, 32, {}, diagnostics);
  checkDeclarations({.pack = pack, .schedule = schedule, .target = *findTarget("iris")}, diagnostics);
  ASSERT_EQ(diagnostics.size(), 1u);
  EXPECT_EQ(diagnostics.front().hint, "list 3 buffers in RENDERTARGETS, or drop the output");
  EXPECT_THAT(diagnostics.front().related,
              ElementsAre(RelatedPlace{{"/composite.fsh", 3, 1}, "gl_FragData[2] goes to no buffer either"}));
}

TEST(Outputs, a_location_that_is_the_number_of_a_buffer) {
  const ShaderPack pack = loadClean(fragmentOf(
      "/* RENDERTARGETS: 4 */\nlayout(location = 4) out vec4 a;\nvoid main() { a = vec4(1); }"));
  Diagnostics diagnostics;
  const Schedule schedule = buildSchedule(pack, 64, 32, {}, diagnostics);
  checkDeclarations({.pack = pack, .schedule = schedule, .target = *findTarget("iris")}, diagnostics);
  const auto found = std::ranges::find(diagnostics, "output-unlisted", &Diagnostic::id);
  ASSERT_NE(found, diagnostics.end());
  EXPECT_EQ(found->hint, "locations count places in the list: write layout(location = 0)");
}

TEST(Outputs, a_ninth_has_no_place_in_any_list) {
  const auto hintOf = [](const std::string& index) {
    const ShaderPack pack =
        loadClean(fragmentOf("void main() { gl_FragData[0] = gl_FragData[" + index + "] = vec4(1); }"));
    Diagnostics diagnostics;
    const Schedule schedule = buildSchedule(pack, 64, 32, {}, diagnostics);
    checkDeclarations({.pack = pack, .schedule = schedule, .target = *findTarget("iris")}, diagnostics);
    const auto found = std::ranges::find(diagnostics, "output-unlisted", &Diagnostic::id);
    return found == diagnostics.end() ? "" : found->hint;
  };
  EXPECT_EQ(hintOf("7"), "list 8 buffers in RENDERTARGETS, or drop the output");
  EXPECT_EQ(hintOf("8"), "number outputs by their place in RENDERTARGETS, from 0: drivers have 8");
}

TEST(Outputs, a_listed_buffer_that_other_options_write_is_no_warning) {
  EXPECT_THAT(messages(fragmentOf("/* DRAWBUFFERS:03 */\nvoid main() { gl_FragData[0] = vec4(1);\n"
                                  "#ifdef NO\ngl_FragData[1] = vec4(1);\n#endif\n}")),
              IsEmpty());
  EXPECT_THAT(messages(fragmentOf("/* DRAWBUFFERS:03 */\nvoid main() { discard; }")), IsEmpty());
}

TEST(Outputs, two_at_one_location) {
  EXPECT_THAT(
      messages(fragmentOf("layout(location = 0) out vec4 a;\n"
                          "layout(location = 0) out vec4 b;\n"
                          "void main() { a = b = vec4(1); }")),
      ElementsAre("output-overlap /composite.fsh:3:31: error: 'b' has the location 0, which "
                  "'a' has too"));
}

// ---- limits

TEST(TargetLimits, shared_memory_is_counted_as_mesa_counts_it) {
  const auto compute = [](const std::string& declaration) {
    Files files = fragmentOf("void main() { gl_FragColor = vec4(1); }");
    files["/composite.csh"] = "#version 430\nlayout(local_size_x = 8) in;\n" + declaration +
                              "void main() { data[0][0].x = 1.0; }\n";
    return files;
  };
  EXPECT_THAT(messages(compute("shared vec3 data[256][9];\n")),
              ElementsAre("target-limit /composite.csh:3:13: warning: the shared variables take "
                          "36860 bytes, Mesa's software rasteriser offers 32768"));
  EXPECT_THAT(messages(compute("const int n = 9;\nshared vec3 data[256][n];\n")),
              ElementsAre("target-limit /composite.csh:4:13: warning: the shared variables take "
                          "36860 bytes, Mesa's software rasteriser offers 32768"));
  EXPECT_THAT(messages(compute("shared vec4 data[256][8];\n")), IsEmpty());
  EXPECT_THAT(messages(compute("shared vec3 data[256][9];\n"), "nvidia"), IsEmpty());
  EXPECT_THAT(
      messages(compute("shared vec4 data[256][8];\n"), "apple"),
      ElementsAre("target-limit /composite.csh:1:1: warning: #version 430 is more than macOS "
                  "offers: 410",
                  "target-limit /composite.csh:1:1: warning: macOS has no compute shaders"));
}

TEST(TargetLimits, samplers_are_counted_where_they_are_used) {
  std::string text, sum = "vec4(0)";
  for (int i = 0; i < 17; ++i) {
    text += "uniform sampler2D " + (i < 16 ? "colortex" + std::to_string(i) : "noisetex") + ";\n";
    sum += " + texture2D(" + (i < 16 ? "colortex" + std::to_string(i) : "noisetex") + ", vec2(0))";
  }
  const Files files = fragmentOf(text + "void main() { gl_FragColor = " + sum + "; }");
  EXPECT_THAT(messages(files), IsEmpty());
  EXPECT_THAT(messages(files, "apple"),
              ElementsAre("target-limit /composite.fsh:18:19: warning: the fragment stage uses 17 "
                          "samplers, macOS offers 16"));
}

// ---- text that is no GLSL

TEST(Declarations, of_broken_text_are_read_without_harm) {
  for (const std::string text : {"uniform", "in vec3 a[", "void main() {",
                                 "out vec4 a[999999999999999999999];void main(){a;}",
                                 "struct S { S s[9]; }; shared S x; void main() { x; }",
                                 "layout(location = ) out vec4 a;", "((((((", "}}}}", "in B { vec3",
                                 "uniform float a = ", "layout(", "void main() { gl_FragData["}) {
    const StageText stage{Stage::Fragment, {.text = text}};
    readStageInterface(stage);
  }
}

}  // namespace
}  // namespace orris
