#include <orris/chart/study/study_input.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace orris {
namespace {

using testing::ElementsAre;

/// A pack with the option SAMPLES: 4 of 4 and 8.
StudyRequest requestOf(std::vector<std::string> cameras = {"front"}) {
  StudyRequest request;
  request.files = memorySource(
      {{"/final.fsh",
        "#version 330 compatibility\n#define SAMPLES 4 //[4 8]\nvoid main() {}\n"}});
  for (const std::string& name : cameras) {
    request.world.cameras.push_back({.name = name});
    request.cameras.push_back({.name = name});
  }
  request.axes = {"SAMPLES"};
  request.references = {"SAMPLES=8"};
  return request;
}

std::vector<std::string> labelsOf(const StudyInput& input) {
  std::vector<std::string> labels;
  for (const Setting& setting : input.settings) labels.push_back(setting.label);
  return labels;
}

std::vector<std::string> idsOf(StudyRequest request) {
  Diagnostics diagnostics;
  EXPECT_FALSE(readStudyInput(std::move(request), diagnostics));
  std::vector<std::string> ids;
  for (const Diagnostic& diagnostic : diagnostics) ids.push_back(diagnostic.id);
  return ids;
}

TEST(StudyInput, axesBecomeSettingsAndAReferenceIsOneOfThem) {
  Diagnostics diagnostics;
  const auto input = readStudyInput(requestOf(), diagnostics);
  ASSERT_TRUE(input) << (diagnostics.empty() ? "" : formatDiagnostic(diagnostics[0]));
  EXPECT_THAT(labelsOf(*input), ElementsAre("SAMPLES=4", "SAMPLES=8"));
  ASSERT_TRUE(input->reference);
  EXPECT_EQ(input->reference->values.at("SAMPLES"), "8");
  EXPECT_EQ(requestFor(input->session, input->settings[1]).load.values.at("SAMPLES"), "8");
}

TEST(StudyInput, theBaselineComesFirst) {
  StudyRequest request = requestOf();
  request.baseline = "SAMPLES=8";
  Diagnostics diagnostics;
  const auto input = readStudyInput(request, diagnostics);
  ASSERT_TRUE(input);
  EXPECT_THAT(labelsOf(*input), ElementsAre("SAMPLES=8", "SAMPLES=4"));
  request.baseline = "SAMPLES=16";
  EXPECT_FALSE(readStudyInput(request, diagnostics));
}

TEST(StudyInput, aMarkMayHaveTheRatioThatWasPublished) {
  StudyRequest request = requestOf();
  request.marks = {"SAMPLES=8:1.25", "SAMPLES=4"};
  Diagnostics diagnostics;
  const auto input = readStudyInput(request, diagnostics);
  ASSERT_TRUE(input);
  EXPECT_EQ(input->marks.at(0).ratio, 1.25);
  EXPECT_FALSE(input->marks.at(1).ratio);
  request.marks = {"SAMPLES=8:fast"};
  EXPECT_THAT(idsOf(request), ElementsAre("mark-syntax"));
}

TEST(StudyInput, errorsNeedAReferenceOfEveryCamera) {
  StudyRequest request = requestOf();
  request.references.clear();
  EXPECT_THAT(idsOf(request), ElementsAre("reference-missing"));
  request = requestOf({"front", "back"});
  request.references = {"/nowhere/a.exr"};
  EXPECT_THAT(idsOf(request), ElementsAre("reference-camera"));
}

TEST(StudyInput, whatThePackLacksIsReported) {
  StudyRequest request = requestOf();
  request.axes = {"SAMPELS"};
  EXPECT_THAT(idsOf(request), ElementsAre("axis-unknown"));
  request = requestOf();
  request.load.values["NONE"] = "1";
  EXPECT_THAT(idsOf(request), ElementsAre("option-unknown"));
}

}  // namespace
}  // namespace orris
