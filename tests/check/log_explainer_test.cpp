#include <orris/check/logs/log_explainer.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace orris {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> sectionsOf(const std::string& log) {
  std::vector<std::string> result;
  for (const LogSection& section : parseGameLog(log)) {
    result.push_back(std::to_string(section.line) + " " + section.name + "|" + section.text);
  }
  return result;
}

TEST(GameLog, irisWarnsThenThrowsWhichIsOneMessage) {
  EXPECT_THAT(
      sectionsOf("[12:00:01] [Render thread/INFO]: Sound engine started\n"
                 "[12:00:02] [Render thread/WARN] (Iris) Shader compilation log for "
                 "composite.fsh: 0(12) : error C1503: undefined variable \"a\"\n"
                 "0(13) : error C1503: undefined variable \"b\"\n"
                 "\n"
                 "[12:00:02] [Render thread/ERROR] (Iris) Failed to create it\n"
                 "net.irisshaders.iris.gl.shader.ShaderCompileException: composite.fsh: "
                 "composite.fsh: 0(12) : error C1503: undefined variable \"a\"\n"
                 "0(13) : error C1503: undefined variable \"b\"\n"
                 "\tat net.irisshaders.iris.gl.shader.GlShader.createShader(GlShader.java:46)\n"),
      ElementsAre("2 composite.fsh|0(12) : error C1503: undefined variable \"a\"\n"
                  "0(13) : error C1503: undefined variable \"b\""));
}

TEST(GameLog, pastedByAPlayer) {
  EXPECT_THAT(
      sectionsOf("it says\ncomposite1.fsh: composite1.fsh: ERROR: 0:45: '' :  syntax error, "
                 "unexpected SAMPLE\nERROR: 1 compilation errors.  No code generated.\n"),
      ElementsAre("2 composite1.fsh|ERROR: 0:45: '' :  syntax error, unexpected SAMPLE\n"
                  "ERROR: 1 compilation errors.  No code generated."));
}

TEST(GameLog, linkingAndChunkShaders) {
  EXPECT_THAT(
      sectionsOf("[1:2:3] [Render thread/WARN]: Program link log for final: varying a mismatch\n"
                 "[1:2:3] [Render thread/WARN]: Shader compilation log for "
                 "iris:sodium-shader-terrain_solid: 0:4(2): error: `x' undeclared\n"),
      ElementsAre("1 final|varying a mismatch",
                  "2 iris:sodium-shader-terrain_solid|0:4(2): error: `x' undeclared"));
}

TEST(GameLog, bareDriverLog) {
  EXPECT_THAT(sectionsOf("0:4(2): error: `x' undeclared\n0:5(1): error: `y' undeclared\n"),
              ElementsAre("1 |0:4(2): error: `x' undeclared\n0:5(1): error: `y' undeclared"));
}

TEST(GameLog, otherLinesAreNone) {
  EXPECT_THAT(sectionsOf("[1:2:3] [main/INFO]: Loading Minecraft 1.21.1: fine\nhello: world\n::\n"),
              IsEmpty());
}

TEST(GameLog, namesOfIrisLeadToPrograms) {
  const auto name = [](std::string_view logged) {
    const LoggedShader shader = shaderOfLogName(logged);
    return shader.program + "." + shader.stage;
  };
  EXPECT_EQ(name("composite3.fsh"), "composite3.fsh");
  EXPECT_EQ(name("terrain_solid.vsh"), "gbuffers_terrain_solid.vsh");
  EXPECT_EQ(name("text_bg.fsh"), "gbuffers_entities_translucent.fsh");
  EXPECT_EQ(name("shadow_terrain_cutout.fsh"), "shadow_cutout.fsh");
  EXPECT_EQ(name("iris:sodium-shader-translucent"), "gbuffers_water.");
  EXPECT_EQ(name("dh_water.fsh"), "dh_water.fsh");
}

constexpr const char* kLibrary =
    "#define SCALE 2.0\n"
    "float halve(float value) { return value / SCALE; }\n"
    "// a comment that moves the lines\n"
    "float broken(float value) {\n"
    "  return halve(value) + missing;\n"
    "}\n";
constexpr const char* kFragment =
    "#version 330 compatibility\n"
    "#include \"/lib/a.glsl\"\n"
    "uniform float rainStrength;\n"
    "void main() {\n"
    "  float once = rainStrength;\n"
    "  gl_FragData[0] = vec4(broken(once));\n"
    "}\n";

ShaderPack packWith(const std::string& fragment) {
  Diagnostics ignored;
  const std::string vertex =
      "#version 330 compatibility\nvoid main() { gl_Position = ftransform(); }\n";
  auto pack = loadShaderPack(memorySource({{"/composite.vsh", vertex},
                                           {"/composite.fsh", fragment},
                                           {"/gbuffers_terrain.vsh", vertex},
                                           {"/gbuffers_terrain.fsh", fragment},
                                           {"/lib/a.glsl", kLibrary}}),
                             {.environment = standardMacros({})}, ignored);
  EXPECT_TRUE(pack.has_value());
  return std::move(*pack);
}

std::string explain(const std::string& log, std::vector<PatchedShader> patched = {},
                    const std::string& stage = "") {
  const ShaderPack pack = packWith(kFragment);
  std::string result;
  for (const Diagnostic& d : explainLog({.pack = pack,
                             .logName = "latest.log",
                             .sections = parseGameLog(log),
                             .patched = std::move(patched),
                             .stage = stage})) {
    result += formatDiagnostic(d) + "\n";
  }
  return result;
}

const std::string kPlaced =
    "  included from /composite.fsh:2\n"
    "    return halve(value) + missing;\n"
    "                          ^\n";

TEST(ExplainLog, everyDriverNamesTheSamePlace) {
  const std::pair<const char*, const char*> kLogs[] = {
      {"0(412) : error C1503: undefined variable \"missing\"", "undefined variable \"missing\""},
      {"0:412(25): error: `missing' undeclared", "`missing' undeclared"},
      {"ERROR: 0:412: error(#143) Undeclared identifier: missing",
       "Undeclared identifier: missing"},
      {"ERROR: 0:412: 'missing' : undeclared identifier", "'missing' : undeclared identifier"},
      {"ERROR: 0:412: Use of undeclared identifier 'missing'",
       "Use of undeclared identifier 'missing'"}};
  for (const auto& [log, message] : kLogs) {
    EXPECT_EQ(explain(std::string("Shader compilation log for composite.fsh: ") + log),
              std::string("/lib/a.glsl:5:25: error: ") + message + "\n" + kPlaced +
                  "  note: place is exact: this host finds the same here\n"
                  "  note: latest.log:1: composite.fsh, line 412 of the compiled text\n");
  }
}

TEST(ExplainLog, aNameThatStandsOnceIsThePlace) {
  EXPECT_THAT(explain("Shader compilation log for composite.fsh: 0(9) : warning C7050: \"once\" "
                      "might be used before being initialized"),
              AllOf(HasSubstr("/composite.fsh:5:9: warning: \"once\" might be used"),
                    HasSubstr("note: place is a guess: once stands in 2 lines of this program, "
                              "/composite.fsh:5, /composite.fsh:6\n"),
                    HasSubstr("hint: for exact places turn on Iris's debug mode")));
  EXPECT_THAT(
      explain("Shader compilation log for composite.fsh: 0(9) : warning C7050: \"main\" odd"),
      HasSubstr("note: place is by name: the only line of this program with main\n"));
}

// As Iris prints it: comments and macros gone, other line breaks, declarations and names of its own.
const PatchedShader kPatched = {"007_composite.fsh",
                                "#version 330 core\n"
                                "uniform mat4 iris_ModelViewMat;\n"
                                "layout (location = 0) out vec4 iris_FragData0;\n"
                                "float halve(float value) {\n"
                                "  return value / 2.0;\n"
                                "}\n"
                                "float broken(float value) {\n"
                                "  return halve(value) + missing;\n"
                                "}\n"
                                "uniform float rainStrength;\n"
                                "void irisMain() {\n"
                                "  float once = rainStrength;\n"
                                "  iris_FragData0 = vec4(broken(once));\n"
                                "}\n"};

TEST(ExplainLog, patchedSourcesGiveTheExactLine) {
  const auto placed = [&](const std::string& entry) {
    return explain("composite.fsh: composite.fsh: " + entry, {kPatched});
  };
  EXPECT_EQ(placed("0(8) : error C1503: undefined variable \"missing\""),
            "/lib/a.glsl:5:25: error: undefined variable \"missing\"\n" + kPlaced +
                "  note: place is exact: by line 8 of 007_composite.fsh\n"
                "  note: latest.log:1: composite.fsh, line 8 of the compiled text\n");
  EXPECT_THAT(placed("0:12(9): error: something else"), HasSubstr("/composite.fsh:5:9: error: "));
  EXPECT_THAT(placed("0(5) : error C0000: syntax error"),
              AllOf(HasSubstr("/lib/a.glsl:2:"), HasSubstr("by line 5 of 007_composite.fsh")));
}

TEST(ExplainLog, aLineThatIrisAddedIsSaidToBe) {
  EXPECT_THAT(explain("composite.fsh: composite.fsh: 0(3) : error C0000: odd", {kPatched}),
              HasSubstr("line 3 of 007_composite.fsh is text that Iris added"));
}

TEST(ExplainLog, theLastPatchedFileOfAShaderCounts) {
  PatchedShader older = kPatched;
  older.file = "001_composite.fsh";
  EXPECT_THAT(explain("composite.fsh: composite.fsh: 0(8) : error: missing", {older, kPatched}),
              HasSubstr("007_composite.fsh"));
}

TEST(ExplainLog, geometryShadersFallBackAsTheGameDoes) {
  EXPECT_THAT(
      explain("terrain_solid.fsh: terrain_solid.fsh: 0(8) : error C1503: undefined variable "
              "\"missing\""),
      AllOf(HasSubstr("/lib/a.glsl:5:25: error: "),
            HasSubstr("latest.log:1: terrain_solid.fsh, line 8 of the compiled text; it is "
                      "made of gbuffers_terrain\n")));
}

TEST(ExplainLog, bareLogsNeedAStage) {
  const std::string log = "0(8) : error C1503: undefined variable \"missing\"";
  EXPECT_EQ(explain(log),
            "latest.log:1: warning: the log does not say which shader this is about\n  " + log +
                "\n  hint: name it: --stage composite.fsh\n");
  EXPECT_THAT(explain(log, {}, "composite.fsh"), HasSubstr("/lib/a.glsl:5:25: error: "));
}

TEST(ExplainLog, shadersOfAnotherPackAreRefused) {
  EXPECT_THAT(
      explain("deferred7.fsh: deferred7.fsh: 0(8) : error: x"),
      HasSubstr("latest.log:1: warning: the pack has no program for the shader deferred7.fsh"));
}

TEST(ExplainLog, aLogWithoutMessagesIsNoted) {
  EXPECT_EQ(explain("[1:2:3] [main/INFO]: all is well\n"),
            "latest.log: note: the log holds no message of a shader compiler\n");
}

}  // namespace
}  // namespace orris
