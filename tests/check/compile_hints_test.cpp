#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include <orris/check/pack/file_name_checks.h>
#include <orris/check/compile/program_check.h>
#include <orris/check/hints/trial_memo.h>
#include "frame_fixture.h"

namespace orris {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

Lines linesOf(const Diagnostics& diagnostics) {
  Lines lines;
  for (const Diagnostic& d : diagnostics) {
    const std::string text = formatDiagnostic(d);
    lines.push_back(text.substr(0, text.find('\n')) + (d.hint.empty() ? "" : " | " + d.hint));
    for (const RelatedPlace& place : d.related)
      lines.back() += " | " + formatLocation(place.at) + ": " + place.message;
  }
  return lines;
}

Lines compile(Files files) {
  files.try_emplace("/composite.vsh", kVertexStage);
  const ShaderPack pack = loadClean(files);
  Verdicts verdicts;
  Diagnostics diagnostics;
  checkWithGlslang(pack, 1, verdicts, diagnostics);
  return linesOf(diagnostics);
}

TEST(CompileHints, a_contract_name_says_its_declaration) {
  EXPECT_THAT(
      compile({{"/composite.fsh",
                kVersion + "void main() { gl_FragColor = vec4(frameTimeCounter); }"}}),
      Contains(HasSubstr("/composite.fsh:2:35: error: 'frameTimeCounter' : undeclared identifier | "
                         "it must be declared: uniform float frameTimeCounter;")));
}

TEST(CompileHints, of_a_name_used_once_the_slip_may_be_at_either_end) {
  EXPECT_THAT(
      compile({{"/composite.fsh", kVersion + "in vec2 texocord;\n\n"
                                             "void main() { gl_FragColor = texcoord.xyxy; }"}}),
      ElementsAre("/composite.fsh:4:30: error: 'texcoord' : undeclared identifier | did "
                  "you mean texocord, declared at /composite.fsh:2? | /composite.fsh:2:9: nothing "
                  "uses 'texocord'"));
}

TEST(CompileHints, of_a_name_used_often_the_slip_is_in_the_declaration) {
  EXPECT_THAT(
      compile({{"/composite.fsh", kVersion + "in vec2 texocord;\n\nvoid main() { gl_FragColor = "
                                             "texcoord.xyxy + texcoord.x; }"}}),
      Contains("/composite.fsh:2:9: error: nothing uses 'texocord', and 'texcoord' is used without "
               "being declared"));
}

TEST(CompileHints, a_call_of_nearly_the_name_of_a_function) {
  EXPECT_THAT(compile({{"/composite.fsh",
                        kVersion + "vec4 shade(float x) { return vec4(x); }\n"
                                   "void main() { gl_FragColor = shad(1.0) * 2.0; }"}}),
              ElementsAre("/composite.fsh:3:30: error: 'shad' : no matching overloaded function "
                          "found | did you mean shade? | /composite.fsh:2:6: shade is defined "
                          "here"));
  EXPECT_THAT(compile({{"/composite.fsh",
                        kVersion + "void main() { gl_FragColor = vec4(normalise(vec3(1)), 1); }"}}),
              ElementsAre(HasSubstr("found | did you mean normalize?")));
  EXPECT_THAT(compile({{"/composite.fsh",
                        kVersion + "vec4 shade(float x) { return vec4(x); }\n"
                                   "void main() { gl_FragColor = shade(vec3(1)); }"}}),
              ElementsAre(HasSubstr("/composite.fsh:2:6: defined here with other parameters")));
}

TEST(CompileHints, a_varying_that_one_stage_does_not_declare) {
  const std::string writes = "void main() { tint = vec3(1); }";
  EXPECT_THAT(compile({{"/composite.vsh", kVersion + "out vec3 tint;\n" + writes},
                       {"/composite.fsh", kVersion + "void main() { gl_FragColor = tint.xyzx; }"}}),
              ElementsAre("/composite.fsh:2:30: error: 'tint' : undeclared identifier | declare "
                          "it: in vec3 tint; | /composite.vsh:2:10: the vertex stage writes it"));
  // The other one Iris declares.
  EXPECT_THAT(compile({{"/composite.vsh", kVersion + writes},
                       {"/composite.fsh", kVersion + "in vec3 tint;\nvoid main() { gl_FragColor = "
                                                     "tint.xyzx; }"}}),
              ElementsAre());
}

TEST(CompileHints, a_name_that_no_file_resembles_may_be_the_mods_that_takes_the_program) {
  const auto compileVoxy = [](const std::string& body) {
    Diagnostics diagnostics;
    const auto pack = loadShaderPack(
        memorySource({{"/composite.fsh", kVersion + "void main() { gl_FragColor = vec4(1.0); }"},
                      {"/voxy.json", "{ \"uniforms\": [], \"samplers\": [] }"},
                      {"/voxy_opaque.glsl",
                       "layout(location = 0) out vec4 color;\nvec4 tinting;\n"
                       "void voxy_emitFragment(VoxyFragmentParameters p) {\n" +
                           body + "\n}\n"}}),
        {.environment = standardMacros({}), .buildModPrograms = true}, diagnostics);
    Verdicts verdicts;
    checkWithGlslang(*pack, 1, verdicts, diagnostics);
    return linesOf(diagnostics);
  };
  EXPECT_THAT(compileVoxy("color = vec4(quadData);"),
              ElementsAre("/voxy_opaque.glsl:4:14: note: 'quadData' : undeclared identifier"));
  EXPECT_THAT(compileVoxy("color = tintign;"),
              Contains(HasSubstr("warning: 'tintign' : undeclared identifier | did you mean")));
}

TEST(CompileHints, a_bracket_that_nothing_opens_ends_the_search_for_a_definition) {
  const Lines lines = compile(
      {{"/composite.fsh", kVersion + "void main() { gl_FragColor = vec4(fog); }"},
       {"/lib.glsl", "float] fog = 1.0;\n] fog;\nconst float[2] fog = float[](1.0, 2.0);\n"}});
  EXPECT_THAT(lines, Contains(HasSubstr("/composite.fsh:2:35: error: 'fog' : undeclared")));
}

TEST(CompileHints, a_missing_include_is_placed_as_a_similar_file_has_it) {
  const std::string top = kVersion + "// top\n", rest = "// rest\n#include \"/b.glsl\"\n";
  const std::string body = "void main() { gl_FragColor = shade(1.0); }\n";
  const Files files{{"/a.glsl", "\nvec4 shade(float x) { return vec4(x); }\n"},
                    {"/b.glsl", "const float B = 1.0;\n"},
                    {"/composite.fsh", top + "\n" + rest + body},
                    {"/final.vsh", kVertexStage},
                    {"/final.fsh", top + "#include \"/a.glsl\"\n" + rest + body}};
  const Lines lines = compile(files);
  EXPECT_THAT(lines, Contains(HasSubstr("error: 'shade' : no matching overloaded function found | "
                                        "defined at /a.glsl:2, which is not included here")));
  EXPECT_THAT(
      lines,
      Contains("/composite.fsh:3: error: 'shade' is unknown at /composite.fsh:6: an #include "
               "seems to be missing here | #include \"/a.glsl\""));
}

TEST(CompileHints, a_missing_include_without_a_model_goes_into_the_gap) {
  const Files files{{"/a.glsl", "#define SHADE(x) vec4(x)\n"},
                    {"/b.glsl", "const float B = 1.0;\n"},
                    {"/c.glsl", "const float C = 1.0;\n"},
                    {"/composite.fsh", kVersion + "#include \"/b.glsl\"\n\n#include \"/c.glsl\"\n"
                                                  "void main() { gl_FragColor = SHADE(1.0); }\n"}};
  EXPECT_THAT(
      compile(files),
      Contains("/composite.fsh:3: error: 'SHADE' is unknown at /composite.fsh:5: an #include "
               "seems to be missing here | #include \"/a.glsl\""));
}

TEST(CompileHints, of_two_places_the_one_that_the_files_beside_it_have) {
  const std::string use = "void main() { gl_FragColor = shade(1.0) + tint(); }\n";
  Files files{{"/lib/all.glsl",
               "vec4 shade(float x) { return vec4(x); }\n"
               "vec4 tint() { return vec4(1.0); }\n"},
              {"/lib/one.glsl", "#include \"/lib/all.glsl\"\n"},
              {"/lib/two.glsl", "\nconst float TWO = 2.0;\n"},
              {"/composite.fsh", kVersion + "// 1\n\n\n#include \"/lib/two.glsl\"\n" + use}};
  for (const char* name : {"/composite1", "/composite2", "/composite3"}) {
    files[std::string(name) + ".vsh"] = kVertexStage;
    files[std::string(name) + ".fsh"] = kVersion + "#include \"/lib/all.glsl\"\n" + use;
  }
  const Lines lines = compile(files);
  EXPECT_THAT(lines, Contains(HasSubstr(
                         "/composite.fsh:4: error: 'shade' is unknown at /composite.fsh:6: an "
                         "#include seems to be missing here | #include \"/lib/all.glsl\"")));
  // One line makes both names known.
  EXPECT_THAT(lines, Not(Contains(HasSubstr("'tint' is unknown"))));
}

TEST(CompileHints, what_an_include_was_found_to_do_is_not_tried_again) {
  const ShaderPack pack = loadClean(
      {{"/a.glsl", "vec4 shade(float x) { return vec4(x); }\n"},
       {"/composite.vsh", kVertexStage},
       {"/composite.fsh", kVersion + "\nvoid main() { gl_FragColor = shade(1.0) + lost(); }\n"},
       {"/final.vsh", kVertexStage},
       {"/final.fsh", kVersion + "#include \"/a.glsl\"\nvoid main() { gl_FragColor = shade(1.0); }\n"}});
  TrialMemo trials;
  const auto check = [&] {
    Verdicts verdicts;
    Diagnostics diagnostics;
    checkWithGlslang(pack, 1, verdicts, diagnostics, nullptr, &trials);
    return linesOf(diagnostics);
  };
  const Lines first = check();
  const std::size_t made = trials.made();
  EXPECT_GT(made, 0u);
  EXPECT_EQ(check(), first);
  EXPECT_EQ(trials.made(), made);
}

TEST(CompileHints, of_two_gaps_the_one_where_the_program_compiles) {
  // /tint.glsl needs what /color.glsl defines, so it cannot stand in the gap above.
  const Lines lines = compile(
      {{"/first.glsl", "const float FIRST = 1.0;\n"},
       {"/color.glsl", "#define COLOR vec4(1.0)\n"},
       {"/tint.glsl", "vec4 tint() { return COLOR; }\n"},
       {"/composite.fsh", kVersion + "#include \"/first.glsl\"\n\n#include \"/color.glsl\"\n\n"
                                     "#include \"/first2.glsl\"\n"
                                     "void main() { gl_FragColor = tint(); }\n"},
       {"/first2.glsl", "const float SECOND = 1.0;\n"}});
  EXPECT_THAT(lines, Contains("/composite.fsh:5: error: 'tint' is unknown at /composite.fsh:7: an "
                              "#include seems to be missing here | #include \"/tint.glsl\""));
}

TEST(CompileHints, other_places_that_are_nearly_as_likely_are_reported_too) {
  const Lines lines = compile(
      {{"/first.glsl", "const float FIRST = 1.0;\n"},
       {"/second.glsl", "const float SECOND = 1.0;\n"},
       {"/tint.glsl", "vec4 tint() { return vec4(1.0); }\n"},
       {"/composite.fsh", kVersion + "#include \"/first.glsl\"\n\n#include \"/second.glsl\"\n"
                                     "\n#include \"/third.glsl\"\n\n// text\n"
                                     "void main() { gl_FragColor = tint(); }\n"},
       {"/third.glsl", "const float THIRD = 1.0;\n"}});
  EXPECT_THAT(lines, Contains(HasSubstr(
                         "/composite.fsh:3: error: 'tint' is unknown at /composite.fsh:9: an "
                         "#include seems to be missing here | #include \"/tint.glsl\"")));
  EXPECT_THAT(lines,
              Contains(HasSubstr("/composite.fsh:5: or #include \"/tint.glsl\" belongs here")));
  // The gap below all of them is the least likely, the line at the top is no gap.
  EXPECT_THAT(lines, Not(Contains(HasSubstr("/composite.fsh:1: or"))));
}

TEST(CompileHints, other_places_compile_too) {
  // As in the test above, and /tint.glsl needs /third.glsl.
  const Lines lines = compile(
      {{"/first.glsl", "const float FIRST = 1.0;\n"},
       {"/second.glsl", "const float SECOND = 1.0;\n"},
       {"/third.glsl", "#define COLOR vec4(1.0)\n"},
       {"/tint.glsl", "vec4 tint() { return COLOR; }\n"},
       {"/composite.fsh", kVersion + "#include \"/first.glsl\"\n\n#include \"/second.glsl\"\n"
                                     "\n#include \"/third.glsl\"\n\n// text\n"
                                     "void main() { gl_FragColor = tint(); }\n"}});
  EXPECT_THAT(lines, Contains(HasSubstr("/composite.fsh:7: error: 'tint' is unknown")));
  EXPECT_THAT(lines, Not(Contains(HasSubstr("belongs here"))));
}

TEST(CompileHints, a_contract_uniform_is_included_from_a_file_for_many) {
  const std::string body = "void main() { gl_FragColor = vec4(far); }\n";
  Files files{{"/one.glsl", "uniform float far;\n"},  // of one program only
              {"/shared.glsl", "uniform float far;\n"},
              {"/composite.fsh", kVersion + "// 2\n\n" + body}};
  for (const char* name : {"/composite1", "/composite2", "/composite3"}) {
    files[std::string(name) + ".vsh"] = kVertexStage;
    files[std::string(name) + ".fsh"] = kVersion + "// 2\n#include \"/shared.glsl\"\n" + body;
  }
  EXPECT_THAT(compile(files),
              Contains(HasSubstr(
                  "/composite.fsh:3: error: 'far' is unknown at /composite.fsh:4: an "
                  "#include seems to be missing here | #include \"/shared.glsl\"")));
}

TEST(CompileHints, a_program_of_a_mod_is_nothing_to_include) {
  const std::string define = "vec4 shade() { return vec4(1.0); }\n";
  const Lines lines =
      compile({{"/voxy_opaque.glsl", define + "void voxy_emitFragment() {}\n"},
               {"/x.glsl", define},
               {"/composite.fsh", kVersion + "\nvoid main() { gl_FragColor = shade(); }\n"}});
  EXPECT_THAT(lines, Contains("/composite.fsh:2: error: 'shade' is unknown at /composite.fsh:3: an "
                              "#include seems to be missing here | #include \"/x.glsl\""));
}

TEST(CompileHints, one_include_that_fixes_all_programs_is_reported_once) {
  const std::string head = kVersion + "#include \"/common.glsl\"\n";
  Files files{{"/common.glsl", "const float A = 1.0;\n\n#include \"/b.glsl\"\n"},
              {"/b.glsl", "const float B = 1.0;\n"},
              {"/util.glsl", "float one() { return A; }\nfloat two() { return A; }\n"},
              {"/x.glsl", "float x() { return one(); }\n"},
              {"/y.glsl", "float y() { return two(); }\n"}};
  const auto add = [&](const std::string& name, const std::string& function) {
    files[name + ".vsh"] = kVertexStage;
    files[name + ".fsh"] = head + "#include \"/" + function + ".glsl\"\n" +
                           "void main() { gl_FragColor = vec4(" + function + "()); }\n";
  };
  add("/composite", "x");
  add("/composite1", "y");
  const Lines lines = compile(files);
  EXPECT_THAT(lines, Contains("/common.glsl:2: error: 'one' is unknown at /x.glsl:1, and 1 program "
                              "more is like this: an #include seems to be missing here | "
                              "#include \"/util.glsl\""));
  EXPECT_EQ(std::ranges::count_if(lines,
                                  [](const std::string& line) {
                                    return line.find("an #include seems") != std::string::npos;
                                  }),
            1);
}

TEST(CompileHints, what_one_program_lacks_besides_stays_reported) {
  const std::string head = kVersion + "#include \"/common.glsl\"\n";
  const Lines lines =
      compile({{"/common.glsl", "const float A = 1.0;\n\n#include \"/b.glsl\"\n"},
               {"/b.glsl", "const float B = 1.0;\n"},
               {"/util.glsl", "const float ONE = 1.0;\nconst float TWO = 2.0;\n"},
               {"/own.glsl", "const float OWN = 1.0;\n"},
               {"/x.glsl", "float x() { return ONE; }\n"},
               {"/y.glsl", "float y() { return TWO; }\n"},
               {"/composite.vsh",
                head + "#include \"/x.glsl\"\nvoid main() { gl_Position = vec4(x()); }\n"},
               {"/composite.fsh", kVersion + "\nvoid main() { gl_FragColor = vec4(OWN); }\n"},
               {"/composite1.vsh",
                head + "#include \"/y.glsl\"\nvoid main() { gl_Position = vec4(y()); }\n"},
               {"/composite1.fsh", kVersion + "void main() { gl_FragColor = vec4(1.0); }\n"}});
  EXPECT_THAT(lines, Contains(HasSubstr("seems to be missing here | #include \"/own.glsl\"")));
  EXPECT_THAT(lines, Contains(HasSubstr("1 program more is like this: an #include seems to be "
                                        "missing here | #include \"/util.glsl\"")));
}

TEST(CompileHints, includes_that_no_line_of_a_common_file_replaces_are_reported_each) {
  Files files{{"/common.glsl", "const float A = 1.0;\n\n#include \"/b.glsl\"\n"},
              {"/b.glsl", "const float B = 1.0;\n"},
              {"/one.glsl", "float one() { return A; }\n"},
              {"/two.glsl", "float two() { return A; }\n"}};
  const auto add = [&](const std::string& name, const std::string& function) {
    files[name + ".vsh"] = kVertexStage;
    files[name + ".fsh"] = kVersion + "#include \"/common.glsl\"\n\n" +
                           "void main() { gl_FragColor = vec4(" + function + "()); }\n";
  };
  add("/composite", "one");
  add("/composite1", "two");
  const Lines lines = compile(files);
  EXPECT_THAT(lines, Contains(HasSubstr("an #include seems to be missing here | "
                                        "#include \"/one.glsl\"")));
  EXPECT_THAT(lines, Contains(HasSubstr("an #include seems to be missing here | "
                                        "#include \"/two.glsl\"")));
}

TEST(CompileHints, a_stage_without_main_lacks_what_those_of_its_name_include) {
  const std::string including = kVersion + "#define X\n#include \"/program/composite.glsl\"\n";
  const Lines lines =
      compile({{"/program/composite.glsl", "void main() { gl_FragColor = vec4(1.0); }\n"},
               {"/composite.fsh", kVersion + "#define X\n\n"},
               {"/world1/composite.fsh", including},
               {"/world1/composite.vsh", kVertexStage}});
  EXPECT_THAT(lines, Contains("/composite.fsh:3: error: the stage has no main(): an #include seems "
                              "to be missing here | #include \"/program/composite.glsl\""));
}

TEST(CompileHints, a_stage_is_not_offered_the_main_of_another_program) {
  const auto including = [](const std::string& name) {
    return kVersion + "#include \"/program/" + name + ".glsl\"\n";
  };
  const std::string main = "void main() { gl_FragColor = vec4(1.0); }\n";
  const auto lines = compile({{"/program/gbuffers_water.glsl", main},
                              {"/world1/gbuffers_water.fsh", including("gbuffers_water")},
                              {"/world1/gbuffers_water.vsh", kVertexStage},
                              {"/composite.fsh", kVersion + "#define X\n\n"}});
  EXPECT_THAT(lines, testing::Not(Contains(HasSubstr("#include \"/program"))));
}

TEST(CompileHints, a_stage_without_its_program_is_located) {
  EXPECT_THAT(compile({{"/composite.fsh", kVersion + "#define X\n\n"}}),
              Contains(HasSubstr("Missing entry point")));
}

TEST(FileNames, only_slips_are_warnings) {
  Files files = cleanPack();
  files["/gbuffers_watter.fsh"] = files["/composite100.fsh"] = kVersion;
  files["/compsite3.fsh"] = files["/setup_a.csh"] = kVersion;
  files["/gbuffers_terrain_old.fsh"] = files["/clrwl_gbuffers.fsh"] = kVersion;
  files["/gbuffers_hand.vsh"] = files["/World-1/composite.fsh"] = kVersion;
  files["/deferred1.fsh"] = files["/deferred 1.fsh"] = kVersion;  // a copy
  files["/world7/composite.fsh"] = kVersion;
  const ShaderPack pack = loadClean(files);
  Diagnostics diagnostics, warnings;
  checkFileNames(std::span(&pack, 1), diagnostics);
  for (const Diagnostic& d : diagnostics) {
    if (d.severity != Severity::Note) warnings.push_back(d);
  }
  EXPECT_THAT(
      linesOf(warnings),
      ElementsAre("/World-1/composite.fsh: warning: no dimension uses the programs of "
                  "/World-1 | did you mean /world-1? Other names need a line in "
                  "dimension.properties",
                  "/composite100.fsh: warning: no program is called composite100 | numbers "
                  "go from composite1 to composite99, the first is composite",
                  "/compsite3.fsh: warning: no program is called compsite3 | did you mean "
                  "composite3?",
                  "/gbuffers_hand.vsh: warning: without a gbuffers_hand.fsh no host "
                  "makes a program of it | add the fragment stage, or delete this file",
                  "/gbuffers_watter.fsh: warning: no program is called gbuffers_watter | did "
                  "you mean gbuffers_water?",
                  "/setup_a.csh: warning: Iris never runs setup_a: programs of setup have numbers, "
                  "no letters | name it setup1.csh to setup99.csh"));
}

}  // namespace
}  // namespace orris
