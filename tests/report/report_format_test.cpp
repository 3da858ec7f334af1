#include <orris/report/report_format.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace orris {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// A pack with an error that a warning follows from, and a warning.
ValidateResult judged(const JudgeOptions& options, std::optional<Baseline> baseline = {}) {
  const std::shared_ptr<const FileSource> files = memorySource({{"/a.fsh", "one\ntwo\n"}});
  PackVerdict verdict{.path = "Pack", .files = files};
  verdict.programs = {{"/a"}, {"/a"}};
  verdict.dimensions = {"/"};
  ProblemList problems;
  Diagnostics found{
      {.id = "glsl-compile", .at = {"/a.fsh", 2, 1}, .message = "wrong"},
      {.severity = Severity::Warning, .id = "varying-unread", .at = {"/a.fsh", 1, 1}, .message = "v"},
      {.severity = Severity::Warning, .id = "uniform-unknown", .at = {"/a.fsh", 1, 2}, .message = "u"}};
  problems.add(found);
  problems.setCause(1, 0);
  ValidateResult result{.baseline = std::move(baseline), .strict = options.strict};
  addPack(result, verdict, problems, options);
  return result;
}

TEST(Findings, whatFollowsStandsBelowItsCause) {
  const ValidateResult result = judged({});
  ASSERT_EQ(result.packs[0].findings.size(), 2u);
  const Finding& first = result.packs[0].findings[0];
  EXPECT_EQ(first.diagnostic.id, "glsl-compile");
  EXPECT_EQ(first.follows.at(0).diagnostic.id, "varying-unread");
  EXPECT_EQ(first.uri, "shaders/a.fsh");
  EXPECT_EQ(first.diagnostic.sourceLine, "two");
  EXPECT_EQ(result.status, kProblems);
}

TEST(Findings, onlyFilesOfProgramsAreNamedAsPrograms) {
  PackVerdict verdict{.path = "Pack", .files = memorySource({})};
  verdict.programs = {{"/world0/a", "/world0/b_c.csh"}, {}};
  verdict.modPrograms["Mod"] = {{"/world0/m"}, {}};
  ProblemList problems;
  Diagnostics found;
  for (const char* file : {"/world0/a.fsh", "/world0/b_c.csh", "/world0/m.vsh", "/program/a.fsh"})
    found.push_back({.id = "glsl-compile", .at = {file, 1, 1}, .message = "wrong"});
  problems.add(found);
  ValidateResult result;
  addPack(result, verdict, problems, {});
  std::map<std::string, std::set<std::string>> programs;
  for (const Finding& finding : result.packs[0].findings)
    programs[finding.diagnostic.at.file] = finding.programs;
  EXPECT_THAT(programs["/world0/a.fsh"], ElementsAre("/world0/a"));
  EXPECT_THAT(programs["/world0/b_c.csh"], ElementsAre("/world0/b_c"));
  EXPECT_THAT(programs["/world0/m.vsh"], ElementsAre("/world0/m"));
  EXPECT_THAT(programs["/program/a.fsh"], testing::IsEmpty());
}

TEST(Findings, severitiesOfTheUserDecideTheStatus) {
  JudgeOptions options{.severities = {{"glsl-compile", Severity::Warning}}};
  EXPECT_EQ(judged(options).status, kClean);
  options.strict = true;
  EXPECT_EQ(judged(options).status, kProblems);
  options.severities = {{"glsl-compile", {}}, {"varying-unread", {}}, {"uniform-unknown", {}}};
  EXPECT_EQ(judged(options).status, kClean);
}

TEST(Findings, aBaselineOfAResultSilencesAllOfIt) {
  Diagnostics diagnostics;
  const auto baseline = Baseline::parse("known", baselineOf(judged({})), diagnostics);
  ASSERT_TRUE(baseline);
  const ValidateResult result = judged({.strict = true}, baseline);
  EXPECT_EQ(result.status, kClean);
  EXPECT_EQ(result.baseline->left(), 0);
}

TEST(ReportFormat, eachFormatNamesTheFindings) {
  EXPECT_THAT(reportFormatNames(), ElementsAre("text", "json", "sarif", "junit", "github"));
  EXPECT_EQ(findReportFormat("xml"), nullptr);
  const ValidateResult result = judged({.sourceRoot = "src"});
  for (const std::string& name : reportFormatNames())
    EXPECT_THAT(findReportFormat(name)->write(result), HasSubstr("glsl-compile")) << name;
}

TEST(ReportFormat, sarifHasThePlaceInTheRepository) {
  const auto log = nlohmann::json::parse(writeSarif(judged({.sourceRoot = "my src"})));
  const auto& place = log.at("runs").at(0).at("results").at(0).at("locations").at(0).at(
      "physicalLocation");
  EXPECT_EQ(place.at("artifactLocation").at("uri"), "my%20src/a.fsh");
  EXPECT_EQ(place.at("region").at("startLine"), 2);
}

TEST(ReportFormat, onlyVerboseTextListsWhatFollows) {
  ValidateResult result = judged({});
  EXPECT_THAT(writeText(result), Not(HasSubstr("varying-unread")));
  EXPECT_THAT(writeText(result), HasSubstr("1 finding follows from this one"));
  result.verbose = true;
  EXPECT_THAT(writeText(result), HasSubstr("varying-unread"));
}

}  // namespace
}  // namespace orris
