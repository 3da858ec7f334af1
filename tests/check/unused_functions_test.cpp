#include <orris/check/compile/unused_functions.h>

#include <gmock/gmock.h>

#include <orris/check/compile/program_check.h>
#include "frame_fixture.h"

namespace orris {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

ShaderPack loadJudged(const Files& files, Diagnostics& diagnostics) {
  Loaded loaded = loadFiles(files, {.irisTexts = true});
  diagnostics = std::move(loaded.diagnostics);
  return std::move(loaded.pack).value();
}

Files packCalling(const std::string& library) {
  const std::string stage = "#version 330 compatibility\n#include \"/lib.glsl\"\n";
  return {{"/lib.glsl", library},
          {"/composite.vsh", stage + "void main() { gl_Position = ftransform(); }\n"},
          {"/composite.fsh", stage + "void main() { }\n"},
          {"/final.fsh", stage + "uniform sampler2D colortex0;\nvoid main() { called(); }\n"}};
}

/// "/file:line message" of all that is wrong with functions that nothing calls.
std::vector<std::string> unused(const std::string& library) {
  Diagnostics diagnostics;
  const ShaderPack pack = loadJudged(packCalling(library), diagnostics);
  checkUnusedFunctions(std::span(&pack, 1), 1, {}, diagnostics);
  std::vector<std::string> lines;
  for (const Diagnostic& d : diagnostics)
    lines.push_back(d.at.file + ":" + std::to_string(d.at.line) + " " + severityName(d.severity) +
                    " " + d.message);
  return lines;
}

constexpr const char* kCalled = "void called() { }\n";

TEST(UnusedFunctions, that_would_not_compile_are_warned_of_once) {
  EXPECT_THAT(
      unused(std::string(kCalled) + "float broken(float x) {\n  return x + missing;\n}\n"),
      ElementsAre("/lib.glsl:3 warning not called, so that Iris leaves the function out; it would "
                  "not compile: 'missing' : undeclared identifier"));
}

TEST(UnusedFunctions, that_compile_in_one_program_are_fine) {
  EXPECT_THAT(unused(std::string(kCalled) + "vec4 f() { return vec4(gl_FragCoord.x); }\n"),
              IsEmpty());
}

TEST(UnusedFunctions, that_another_program_calls_are_a_librarys) {
  EXPECT_THAT(unused("vec4 other() { return called(); }\nvoid called() { }\n"),
              ElementsAre(::testing::HasSubstr("/lib.glsl:1")));
  auto files = packCalling("float used() { return fromAnother; }\n" + std::string(kCalled));
  files["/composite1.fsh"] =
      "#version 330 compatibility\nuniform float fromAnother;\n#include \"/lib.glsl\"\n"
      "void main() { gl_FragColor = vec4(used()); }\n";
  Diagnostics diagnostics;
  const ShaderPack pack = loadJudged(files, diagnostics);
  checkUnusedFunctions(std::span(&pack, 1), 1, {}, diagnostics);
  EXPECT_THAT(diagnostics, IsEmpty());
}

TEST(UnusedFunctions, of_a_program_that_fails_wait_until_it_compiles) {
  const std::string text =
      "#version 330 compatibility\nfloat broken() { return missing; }\nvoid main() { lost(); }\n";
  Diagnostics diagnostics, found;
  const ShaderPack pack = loadJudged({{"/final.fsh", text}}, diagnostics);
  Verdicts verdicts;
  checkWithGlslang(pack, 1, verdicts, diagnostics);
  ASSERT_TRUE(hasErrors(diagnostics));
  checkUnusedFunctions(std::span(&pack, 1), 1, verdicts, found);
  EXPECT_THAT(found, IsEmpty());
}

TEST(UnusedFunctions, with_a_syntax_error_refuse_the_program) {
  Diagnostics diagnostics;
  const ShaderPack pack =
      loadJudged(packCalling(std::string(kCalled) + "void f() {\n  int a = ;\n}\n"), diagnostics);
  Verdicts verdicts;
  checkWithGlslang(pack, 1, verdicts, diagnostics);
  ASSERT_FALSE(diagnostics.empty());
  EXPECT_EQ(formatDiagnostic(diagnostics.front()).substr(0, 77),
            "/lib.glsl:3:11: error: syntax error: expected an expression before ';'\n  incl");
  for (const auto& [hash, good] : verdicts) EXPECT_FALSE(good);
}

}  // namespace
}  // namespace orris
