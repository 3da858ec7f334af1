#include <orris/validate/validate_pack.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include <orris/report/report_format.h>
#include "support/folder_test.h"

namespace orris {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

class ValidatePack : public test::FolderTest {
 protected:
  void SetUp() override {
    write("shaders/final.vsh", "#version 330 compatibility\nvoid main() { gl_Position = ftransform(); }\n");
    options_.pack.path = folder_.string();
    options_.jobs = 1;
  }
  void writeFinal(const std::string& value) const {
    write("shaders/final.fsh",
          "#version 330 compatibility\n#define A 1.0 //[1.0 2.0]\nvoid main() { gl_FragColor = " +
              value + "; }\n");
  }

  ValidateOptions options_;
};

std::vector<std::string> idsOf(const ValidateResult& result) {
  std::vector<std::string> ids;
  for (const Finding& finding : result.packs.at(0).findings)
    if (finding.diagnostic.severity == Severity::Error) ids.push_back(finding.diagnostic.id);
  return ids;
}

TEST_F(ValidatePack, aGoodPackIsClean) {
  writeFinal("vec4(A)");
  const ValidateResult result = validatePack(options_);
  EXPECT_EQ(result.status, kClean);
  EXPECT_THAT(idsOf(result), ElementsAre());
  EXPECT_THAT(result.packs[0].verdict.programs.all, ElementsAre("/final"));
}

TEST_F(ValidatePack, aMistakeIsAFindingInEveryFormat) {
  writeFinal("vec4(nothing)");
  const ValidateResult result = validatePack(options_);
  EXPECT_EQ(result.status, kProblems);
  ASSERT_THAT(idsOf(result), ElementsAre("glsl-compile"));
  EXPECT_EQ(result.packs[0].findings[0].diagnostic.at, (SourceLocation{"/final.fsh", 3, 35}));
  EXPECT_THAT(writeSarif(result), HasSubstr("'nothing'"));
}

// The brace of composite is repaired and all is checked again, final as it is.
TEST_F(ValidatePack, noIncludeIsTriedAgainForAMistakeElsewhere) {
  const std::string head = "#version 330 compatibility\n";
  write("shaders/a.glsl", "vec4 shade(float x) { return vec4(x); }\n");
  write("shaders/final.fsh", head + "\nvoid main() { gl_FragColor = shade(1.0) + lost(); }\n");
  write("shaders/composite.vsh", head + "void main() { gl_Position = ftransform(); }\n");
  const auto trialsWith = [&](const std::string& end) {
    write("shaders/composite.fsh", head + "#include \"/a.glsl\"\nvoid main() {\n  if (shade(1.0).x > "
                                          "0.0) {\n    gl_FragColor = shade(1.0);\n" + end + "}\n");
    Diagnostics diagnostics;
    ProblemList problems;
    auto checker = makeChecker(options_, 1, diagnostics);
    validateFiles("pack", openPack(options_.pack.path, diagnostics), options_, *checker, problems);
    const auto brace = [](const Diagnostic& d) { return d.id == "brace-unbalanced"; };
    EXPECT_EQ(std::ranges::any_of(problems.all(), brace), end.empty());
    return checker->trials->made();
  };
  const std::size_t made = trialsWith("  }\n");
  EXPECT_GT(made, 0u);
  EXPECT_EQ(trialsWith(""), made);
}

// A missing include, a broken function that nothing calls and an #endif too many are compiled elsewhere than programs.
TEST_F(ValidatePack, withoutWorkersTheFindingsAreTheSame) {
  const std::string head = "#version 330 compatibility\n";
  write("shaders/a.glsl", "float shade(float x) { return x; }\nvoid unused() { int i = vec3(1.0); }\n");
  write("shaders/composite.vsh", head + "void main() { gl_Position = ftransform(); }\n");
  write("shaders/composite.fsh", head + "void main() { gl_FragColor = vec4(shade(1.0)); }\n");
  write("shaders/final.fsh", head + "#include \"/a.glsl\"\n#ifdef A\n#endif\n#endif\n"
                                    "void main() { gl_FragColor = vec4(1.0); }\n");
  const std::string apart = writeJson(validatePack(options_));
  EXPECT_THAT(apart, AllOf(HasSubstr("include-probably-missing"), HasSubstr("unused-function-broken"),
                           HasSubstr("conditional-unbalanced")));
  options_.jobs = 0;
  EXPECT_EQ(writeJson(validatePack(options_)), apart);
}

TEST_F(ValidatePack, aFileThatIsIncludedTwiceIsOneMistake) {
  write("shaders/a.glsl", "float shade() { return 1.0; }\nconst float level = 1.0;\nfloat glow() { return level; }\n");
  write("shaders/b.glsl", "#include \"/a.glsl\"\n");
  write("shaders/final.fsh", "#version 330 compatibility\n#include \"/b.glsl\"\n\n#include \"/a.glsl\"\n"
                             "void main() { gl_FragColor = vec4(shade() * glow()); }\n");
  const ValidateResult result = validatePack(options_);
  ASSERT_THAT(idsOf(result), ElementsAre("glsl-compile"));
  const Diagnostic& d = result.packs[0].findings[0].diagnostic;
  EXPECT_EQ(d.at.file, "/a.glsl");
  EXPECT_THAT(d.hint, HasSubstr("reads this file twice"));
  ASSERT_EQ(d.related.size(), 1u);
  EXPECT_EQ(d.related[0].at, (SourceLocation{"/b.glsl", 1, 1}));
}

TEST_F(ValidatePack, theCauseOfAFailedLoadIsTheStatus) {
  writeFinal("vec4(A)");
  options_.pack.values["B"] = "1";
  ValidateResult result = validatePack(options_);
  EXPECT_EQ(result.status, kUsage);
  EXPECT_THAT(idsOf(result), ElementsAre("option-unknown"));
  options_.pack = {.path = folder_.string(), .profile = "NONE"};
  EXPECT_EQ(validatePack(options_).status, kUsage);
  options_.pack = {.path = path("nowhere")};
  result = validatePack(options_);
  EXPECT_EQ(result.status, kUsage);
  EXPECT_THAT(idsOf(result), ElementsAre("pack-unreadable"));
}

TEST_F(ValidatePack, aFileThatIsSavedMeanwhileStaysWhatItWas) {
  writeFinal("vec4(A)");
  const ValidateResult result = validatePack(options_);
  writeFinal("vec4(nothing)");
  EXPECT_THAT(result.packs[0].verdict.files->read("/final.fsh").value_or(""), HasSubstr("vec4(A)"));
}

TEST_F(ValidatePack, aProfileOfThePackThatIsMissingIsAProblemOfThePack) {
  writeFinal("vec4(A)");
  write("shaders/shaders.properties", "profile.LOW = profile.NONE A=2.0\n");
  const ValidateResult result = validatePack(options_);
  EXPECT_EQ(result.status, kProblems);
  EXPECT_THAT(idsOf(result), ElementsAre("profile-unknown"));
}

TEST_F(ValidatePack, aCacheRemembersTheFindings) {
  writeFinal("vec4(nothing)");
  options_.cache = path("cache");
  const ValidateResult first = validatePack(options_), second = validatePack(options_);
  EXPECT_FALSE(first.packs[0].verdict.cached);
  EXPECT_TRUE(second.packs[0].verdict.cached);
  EXPECT_EQ(writeSarif(first), writeSarif(second));
}

}  // namespace
}  // namespace orris
