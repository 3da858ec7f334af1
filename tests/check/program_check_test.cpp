#include <orris/check/compile/program_check.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "frame_fixture.h"

namespace orris {
namespace {

using ::testing::ElementsAre;

TEST(RuleNotes, one_place_is_one_note_however_many_programs_share_it) {
  Files files;
  const std::string shared = "#version 330 compatibility\n#include \"/lib.glsl\"\n";
  files["/lib.glsl"] =
      "uniform sampler2D colortex0;\nvec4 old(vec2 p) { return texture2D(colortex0, p); }\n";
  for (const std::string name : {"composite", "composite1", "composite2"})
    addProgram(files, name, shared + "void main() { gl_FragColor = old(vec2(0.5)); }\n");
  addProgram(files, "final",
             "#version 330 compatibility\nuniform sampler2D colortex0;\n"
             "void main() { gl_FragColor = texture2D(colortex0, vec2(0.5)); }\n");
  std::vector<std::string> lines;
  for (const Diagnostic& note : ruleNotes(loadClean(files)))
    if (note.message.find("texture-functions") != std::string::npos)
      lines.push_back(note.at.file + ":" + std::to_string(note.at.line) + " " + note.message);
  EXPECT_THAT(
      lines,
      ElementsAre("/final.fsh:3 rule texture-functions applied 1 time in /final",
                  "/lib.glsl:2 rule texture-functions applied 3 times in /composite and 2 more "
                  "programs"));
}

TEST(ProgramCheck, what_reads_a_file_by_other_capitals_is_checked_and_fails) {
  const auto failed = [](const std::string& body) {
    Files files;
    files["/Lib.glsl"] = "float one() { return 1.0; }\n";
    addProgram(files, "final", "#version 330 compatibility\n#include \"/lib.glsl\"\nvoid main() { " + body + " }\n");
    Diagnostics diagnostics;
    const auto pack = loadShaderPack(memorySource(files), {.environment = standardMacros({}), .keepGoing = true}, diagnostics);
    Verdicts verdicts;
    checkWithGlslang(*pack, 1, verdicts, diagnostics);
    std::vector<std::string> ids;
    for (const Diagnostic& d : diagnostics) ids.push_back(d.id);
    for (const auto& [hash, passed] : verdicts) ids.push_back(passed ? "passed" : "failed");
    return ids;
  };
  EXPECT_THAT(failed("gl_FragColor = vec4(one());"), ElementsAre("include-capitals", "failed"));
  EXPECT_THAT(failed("gl_FragColor = vec4(two());"),
              ElementsAre("include-capitals", "glsl-compile", "failed"));
}

}  // namespace
}  // namespace orris
