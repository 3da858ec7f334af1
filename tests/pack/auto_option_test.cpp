// What a pack says of the cost of an option's values, and which of them is chosen.
#include <orris/pack/options/auto_option.h>

#include <gmock/gmock.h>

#include <orris/pack/options/auto_properties.h>
#include <orris/pack/shader_pack.h>

namespace orris {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

OptionSet shadowOptions() {
  OptionSet options;
  options.all()["SHADOWS"] = {
      .name = "SHADOWS", .defaultValue = "MAP", .values = {"NONE", "MAP", "VOLUME", "AUTO"}};
  options.all()["Q"] = {.name = "Q", .defaultValue = "2", .values = {"1", "2"}};
  return options;
}

std::vector<AutoCandidate> parseAuto(const std::string& text, Diagnostics& diagnostics) {
  return parseAutoOptions("/shaders.properties", text,
                          {{"SHADOWS", "AUTO"}, {"AUTO", "6"}, {"Q", "2"}}, shadowOptions(),
                          diagnostics);
}

std::vector<AutoCandidate> parseAuto(const std::string& text) {
  Diagnostics diagnostics;
  auto candidates = parseAuto(text, diagnostics);
  EXPECT_THAT(diagnostics, IsEmpty()) << formatDiagnostic(diagnostics.front());
  return candidates;
}

std::string messageOf(const std::string& text) {
  Diagnostics diagnostics;
  EXPECT_THAT(parseAuto(text, diagnostics), IsEmpty());
  return diagnostics.empty() ? "" : formatDiagnostic(diagnostics.front());
}

TEST(AutoOption, cost_is_a_sum_of_products_and_numbers_may_be_values_of_options) {
  const auto found = parseAuto("auto.shadows.map = 0.5 + 2e-3 Q pixels lamps + 1 faces\n");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].option, "SHADOWS");
  EXPECT_EQ(found[0].value, "MAP");
  // Written numbers are floats, as in all properties.
  EXPECT_FLOAT_EQ(found[0].cost({{"pixels", 100}, {"lamps", 3}, {"faces", 7}}), 0.5 + 1.2 + 7);
  EXPECT_FLOAT_EQ(found[0].cost({{"faces", 7}}), 7.5) << "what is not known is 0";
  EXPECT_THAT(found[0].quantities(), ElementsAre("pixels", "lamps", "faces"));
  EXPECT_EQ(found[0].formula(), "0.5 + 0.004 pixels lamps + 1 faces");
}

TEST(AutoOption, conditions_hold_all_or_the_value_is_not_chosen) {
  const auto found =
      parseAuto("auto.shadows.none = 0 if sun < 0.5 and lamps >= 2\nauto.shadows.map = 1\n");
  EXPECT_EQ(found[0].formula(), "0 if sun < 0.5 and lamps >= 2");
  const auto chosen = [&](double sun, double lamps) {
    return chooseAuto(found, "SHADOWS", {{"sun", sun}, {"lamps", lamps}}, "").value;
  };
  EXPECT_EQ(chosen(0.4, 2), "NONE");
  EXPECT_EQ(chosen(0.5, 2), "MAP");
  EXPECT_EQ(chosen(0.4, 1), "MAP");
}

TEST(AutoOption, branches_of_the_preprocessor_choose_the_lines) {
  const auto found =
      parseAuto("#if Q == 2\nauto.shadows.map = 1\n#else\nauto.shadows.volume = 1\n#endif\n");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].value, "MAP");
}

TEST(AutoOption, cheapest_is_chosen_and_all_are_reported) {
  const auto found =
      parseAuto("auto.shadows.map = 1 + 0.01 faces\nauto.shadows.volume = 0.02 faces\n");
  const AutoChoice few = chooseAuto(found, "SHADOWS", {{"faces", 10}}, "");
  EXPECT_EQ(few.value, "VOLUME");
  ASSERT_EQ(few.candidates.size(), 2u);
  EXPECT_FLOAT_EQ(few.candidates[0].milliseconds, 1.1);
  EXPECT_EQ(chooseAuto(found, "SHADOWS", {{"faces", 1000}}, "").value, "MAP");
  EXPECT_EQ(chooseAuto(found, "OTHER", {}, "").value, "");
}

TEST(AutoOption, what_is_there_stays_until_another_is_clearly_cheaper) {
  const auto found = parseAuto("auto.shadows.map = 10\nauto.shadows.volume = 0.1 faces\n");
  std::string present = "MAP";
  std::vector<std::string> seen;
  // 100 is where both cost the same.
  for (const double faces : {120., 95., 105., 90., 80., 95., 105., 110., 125.}) {
    present = chooseAuto(found, "SHADOWS", {{"faces", faces}}, present).value;
    seen.push_back(present);
  }
  EXPECT_THAT(
      seen, ElementsAre("MAP", "MAP", "MAP", "MAP", "VOLUME", "VOLUME", "VOLUME", "VOLUME", "MAP"));
}

TEST(AutoOption, present_value_that_is_not_allowed_gives_way) {
  const auto found = parseAuto("auto.shadows.none = 0 if sun < 0.1\nauto.shadows.map = 9\n");
  EXPECT_EQ(chooseAuto(found, "SHADOWS", {{"sun", 1}}, "NONE").value, "MAP");
}

TEST(AutoOption, mistakes_are_reported_at_their_place) {
  EXPECT_THAT(messageOf("sun = true\nauto.shadow.map = 1\n"),
              HasSubstr("/shaders.properties:2:1: warning: auto.shadow.map: no such option"));
  EXPECT_THAT(messageOf("auto.q.1 = 1\n"), HasSubstr("no such option has the value AUTO"));
  EXPECT_THAT(messageOf("auto.shadows.auto = 1\n"), HasSubstr("no other value"));
  EXPECT_THAT(messageOf("auto.shadows = 1\n"), HasSubstr("no other value"));
  EXPECT_THAT(messageOf("auto.shadows.map = 1 lampps\n"), HasSubstr("not \"lampps\""));
  EXPECT_THAT(messageOf("auto.shadows.map = pixels\n"), HasSubstr("expected a number"));
  EXPECT_THAT(messageOf("auto.shadows.map =\n"), HasSubstr("expected a number"));
  EXPECT_THAT(messageOf("auto.shadows.map = 1 +\n"), HasSubstr("expected a number"));
  EXPECT_THAT(messageOf("auto.shadows.map = 1 if sun > 2\n"), HasSubstr("expected < or >="));
  EXPECT_THAT(messageOf("auto.shadows.map = 1 if sun < 2 3\n"), HasSubstr("expected +, if or"));
  EXPECT_THAT(messageOf("auto.shadows.map = 1e999\n"), HasSubstr("expected a number"));
}

TEST(AutoOption, mistakes_count_only_with_the_feature_flag) {
  const auto reported = [](const char* flags) {
    Diagnostics diagnostics;
    loadShaderPack(
        memorySource({{"/final.fsh",
                       "#version 330\n#define SHADOWS MAP // [MAP AUTO]\n"
                       "#if SHADOWS == MAP\n#endif\nvoid main() {}\n"},
                      {"/shaders.properties", std::string(flags) + "auto.shadows.map = x\n"}}),
        {.environment = standardMacros({})}, diagnostics);
    return diagnostics.size();
  };
  EXPECT_EQ(reported(""), 0u);
  EXPECT_EQ(reported("orris.features.optional = AUTO_OPTIONS\n"), 1u);
}

}  // namespace
}  // namespace orris
