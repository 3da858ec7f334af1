#include <orris/check/pack/version_checks.h>

#include <gmock/gmock.h>

#include <orris/core/files/file_source.h>

namespace orris {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

using Files = std::map<std::string, std::string>;

/// "file:line message" of each version-newer that the pack gives with these versions.
std::vector<std::string> foundBy(Files files, const Version& iris, const Version& game) {
  files["/final.vsh"] = "#version 330 compatibility\nvoid main() { gl_Position = ftransform(); }\n";
  Diagnostics diagnostics;
  const auto pack =
      loadShaderPack(memorySource(files),
                     {.environment = standardMacros({.versions = {iris, game}})}, diagnostics);
  if (!pack) return {"not loaded: " + formatDiagnostic(diagnostics.at(0))};
  const Schedule schedule = buildSchedule(*pack, 64, 64, {}, diagnostics);
  std::vector<std::string> messages;
  for (const Diagnostic& d : checkFolder({*pack, schedule, *findTarget("minimum")})) {
    if (d.id == "version-newer")
      messages.push_back(d.at.file + ":" + std::to_string(d.at.line) + " " + d.message);
  }
  return messages;
}

Files finalFile(const std::string& body) {
  return {{"/final.fsh", "#version 330 compatibility\n" + body}};
}

constexpr Version kOldGame{1, 21, 5}, kNewGame{26, 2, 0};

TEST(VersionChecks, a_used_uniform_names_the_version_that_has_it) {
  const Files files = finalFile(
      "uniform int seaLevel;\nuniform float endFlashIntensity;\nuniform bool isRiding;\n"
      "void main() { gl_FragData[0] = vec4(seaLevel, endFlashIntensity, 0.0, 1.0); }\n");
  EXPECT_THAT(foundBy(files, {1, 8, 0}, kOldGame),
              ElementsAre("/final.fsh:2 'seaLevel' is there since Iris 1.9.5; with Iris 1.8 and "
                          "Minecraft 1.21.5 it stays 0",
                          "/final.fsh:3 'endFlashIntensity' is there since Iris 1.9.2; with Iris "
                          "1.8 and Minecraft 1.21.5 it stays 0"));
  // Iris has it, the game has no such flash.
  EXPECT_THAT(foundBy(files, {1, 9, 7}, {1, 21, 8}),
              ElementsAre("/final.fsh:3 'endFlashIntensity' is there since Minecraft 1.21.9; with "
                          "Iris 1.9.7 and Minecraft 1.21.8 it stays 0"));
  EXPECT_THAT(foundBy(files, {1, 11, 2}, kNewGame), IsEmpty());
}

TEST(VersionChecks, what_a_guard_leaves_out_is_no_use) {
  const Files guarded = finalFile(
      "#if IRIS_VERSION >= 10905\nuniform int seaLevel;\n#else\nconst int seaLevel = 63;\n#endif\n"
      "#ifdef IRIS_FEATURE_FADE_VARIABLE\nuniform float chunkFadeTimeInv;\n#endif\n"
      "#if MAX_COLOR_BUFFERS >= 32\nuniform sampler2D colortex20;\n#endif\n"
      "void main() { gl_FragData[0] = vec4(seaLevel); }\n");
  for (const Version iris : {Version{1, 7, 0}, Version{1, 8, 0}, Version{1, 9, 4}})
    EXPECT_THAT(foundBy(guarded, iris, kOldGame), IsEmpty());
}

TEST(VersionChecks, a_custom_uniform_of_the_pack_takes_the_place) {
  Files files =
      finalFile("uniform int seaLevel;\nvoid main() { gl_FragData[0] = vec4(seaLevel); }\n");
  files["/shaders.properties"] = "uniform.int.seaLevel = 63\n";
  EXPECT_THAT(foundBy(files, {1, 8, 0}, kOldGame), IsEmpty());
}

TEST(VersionChecks, buffers_above_the_last_one) {
  const Files files = finalFile(
      "uniform sampler2D colortex16;\nuniform sampler2D colortex15;\nvoid main() {\n"
      "  gl_FragData[0] = texture2D(colortex16, vec2(0)) + texture2D(colortex15, vec2(0)); }\n");
  EXPECT_THAT(foundBy(files, {1, 10, 4}, {1, 21, 11}),
              ElementsAre("/final.fsh:2 'colortex16' is there since Iris 1.10.5; with Iris 1.10.4 "
                          "and Minecraft 1.21.11 the last one is colortex15"));
  EXPECT_THAT(foundBy(files, {1, 10, 5}, {1, 21, 11}), IsEmpty());
  Files draws = finalFile("void main() { gl_FragData[0] = vec4(1); }\n");
  draws["/composite.fsh"] =
      "#version 330 compatibility\n/* RENDERTARGETS: 0,17 */\nvoid main() {}\n";
  EXPECT_THAT(foundBy(draws, {1, 8, 0}, kOldGame),
              ElementsAre(HasSubstr("/composite.fsh:2 colortex17 is there since Iris 1.10.5")));
}

TEST(VersionChecks, an_attribute_that_the_host_declares_is_met_where_it_is_used) {
  Files files = finalFile("void main() { gl_FragData[0] = vec4(1); }\n");
  files["/gbuffers_terrain.vsh"] =
      "#version 330 compatibility\nout float fade;\nvoid main() {\n  gl_Position = ftransform();\n"
      "  fade = mc_chunkFade; }\n";
  files["/gbuffers_terrain.fsh"] =
      "#version 330 compatibility\nin float fade;\nvoid main() { gl_FragData[0] = vec4(fade); }\n";
  EXPECT_THAT(foundBy(files, {1, 8, 0}, kOldGame),
              ElementsAre("/gbuffers_terrain.vsh:5 'mc_chunkFade' is there since Iris 1.10.3; with "
                          "Iris 1.8 and Minecraft 1.21.5 the program is refused"));
  EXPECT_THAT(foundBy(files, {1, 11, 2}, kNewGame), IsEmpty());
}

TEST(VersionChecks, lines_of_shaders_properties) {
  Files files = finalFile("void main() { gl_FragData[0] = vec4(1); }\n");
  files["/shaders.properties"] =
      "iris.features.optional = SSBO CUSTOM_IMAGES\nbreaksAnisotropy = true\nbufferObject.8 = 4\n"
      "bufferObject.9 = 4\n#if IRIS_VERSION >= 11005\nbufferObject.10 = 4\n#endif\n";
  EXPECT_THAT(foundBy(files, {1, 8, 0}, kOldGame),
              ElementsAre(HasSubstr("properties:2 breaksAnisotropy is there since Iris 1.10.5"),
                          HasSubstr("properties:4 bufferObject.9 is there since Iris 1.10.5")));
  files["/shaders.properties"] =
      "iris.features.optional = CUSTOM_IMAGES\n"
      "image.a = none RGB RGB9_E5 UNSIGNED_INT_5_9_9_9_REV true false 8 8\n";
  EXPECT_THAT(foundBy(files, {1, 7, 6}, {1, 20, 1}),
              ElementsAre(HasSubstr("UNSIGNED_INT_5_9_9_9_REV is there since Iris 1.8")));
}

TEST(VersionChecks, a_required_feature_of_a_newer_version_refuses_the_pack) {
  Files files = finalFile("void main() { gl_FragData[0] = vec4(1); }\n");
  files["/shaders.properties"] = "iris.features.required = FADE_VARIABLE\n";
  EXPECT_THAT(foundBy(files, {1, 10, 2}, {1, 21, 11}),
              ElementsAre(HasSubstr("Iris 1.10.2 does not offer the feature FADE_VARIABLE")));
  EXPECT_THAT(foundBy(files, {1, 10, 3}, {1, 21, 11}), IsEmpty());
}

}  // namespace
}  // namespace orris
