// Profiles and screens: tables of cases. Contract: options.csv profile.*, screen.*.
#include <gmock/gmock.h>

#include <orris/pack/options/chosen_values.h>
#include <orris/pack/properties/shader_properties.h>

namespace orris {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

OptionSet profileOptions() {
  Diagnostics diagnostics;
  return discoverOptions({{"/a",
                           {"#define FOG", "#ifdef FOG", "//#define BLOOM", "#ifdef BLOOM",
                            "#define SAMPLES 4 // [2 4 8]", "#define MODE A // [A B=C]"}}},
                         diagnostics);
}

ShaderProperties readProfiles(const std::string& text, std::vector<std::string>* messages = nullptr) {
  Diagnostics diagnostics;
  const ShaderProperties properties =
      parseShaderProperties("/shaders.properties", text, {}, profileOptions(), diagnostics);
  for (const Diagnostic& d : diagnostics) {
    if (messages) {
      messages->push_back(d.id + " " + std::to_string(d.at.line) + ":" +
                          std::to_string(d.at.column) + " " + severityName(d.severity) + ": " +
                          d.message + (d.hint.empty() ? "" : " | " + d.hint));
    }
  }
  return properties;
}

std::vector<std::string> profileProblems(const std::string& text) {
  std::vector<std::string> messages;
  readProfiles(text, &messages);
  return messages;
}

struct ProfileCase {
  const char* text;
  OptionValues values;
};

TEST(ProfileTable, items) {  // Iris: ProfileSet.parse
  const ProfileCase kCases[] = {
      {"profile.P=FOG", {{"FOG", "true"}}},
      {"profile.P=!FOG", {{"FOG", "false"}}},
      {"profile.P=SAMPLES=8", {{"SAMPLES", "8"}}},
      {"profile.P=SAMPLES:8", {{"SAMPLES", "8"}}},
      {"profile.P = FOG   SAMPLES:2 \\\n  !BLOOM",
       {{"FOG", "true"}, {"SAMPLES", "2"}, {"BLOOM", "false"}}},
      {"profile.P=FOG !FOG FOG:true", {{"FOG", "true"}}},  // the last item counts
      {"profile.P=MODE:B=C", {}},                          // '=' is looked for first
      {"profile.A=FOG SAMPLES=8\nprofile.P=profile.A SAMPLES=2",
       {{"FOG", "true"}, {"SAMPLES", "2"}}},
      {"profile.A=SAMPLES=8\nprofile.P=SAMPLES=2 profile.A", {{"SAMPLES", "8"}}},
      {"profile.P=!program.composite4", {}},
      {"#if 0\nprofile.P=FOG\n#endif", {{"FOG", "true"}}},  // #if lines are comments here
      {"profile.P=FOG\nprofile.P=BLOOM", {{"BLOOM", "true"}}},
  };
  for (const ProfileCase& test : kCases) {
    EXPECT_EQ(readProfiles(test.text).profiles.back().values, test.values) << test.text;
  }
}

TEST(ProfileTable, problems_are_placed_on_the_word) {
  EXPECT_THAT(
      profileProblems("profile.P = !FOG \\\n    SAMPELS=2 \\\n\t!BLOM NOTHING_LIKE_IT"),
      ElementsAre("profile-option 2:5 warning: the pack has no option SAMPELS | did you mean "
                  "SAMPLES?",
                  "profile-option 3:2 warning: the pack has no option BLOM | did you mean "
                  "BLOOM?",
                  "profile-option 3:8 warning: the pack has no option NOTHING_LIKE_IT"));
  EXPECT_THAT(profileProblems("profile.P = :FOG FOG"),
              ElementsAre("profile-option 1:13 warning: \":FOG\" names no option | write NAME=VALUE, "
                          "NAME or !NAME"));
  EXPECT_THAT(profileProblems("profile.P = SAMPLES"),
              ElementsAre("profile-option 1:13 warning: SAMPLES has values, so it needs one here | "
                          "write SAMPLES=4"));
  EXPECT_THAT(
      profileProblems("profile.P = SAMPLES=4 SAMPLES=16 FOG:1"),
      ElementsAre("profile-value 1:23 warning: 16 is not in the list of SAMPLES | its values "
                  "are 2, 4, 8",
                  "profile-value 1:34 warning: 1 is not in the list of FOG | its values are "
                  "true, false"));
}

TEST(ProfileTable, an_option_that_is_none_is_one_finding_for_all_profiles) {
  EXPECT_THAT(profileProblems("profile.A = BLOM\nprofile.B = FOG !BLOM\nprofile.C = profile.A"),
              ElementsAre("profile-option 1:13 warning: the pack has no option BLOM | did you mean "
                          "BLOOM?"));
}

TEST(ProfileTable, a_number_that_is_no_value_is_placed_between_its_neighbours) {
  EXPECT_THAT(profileProblems("profile.P = SAMPLES=5"),
              ElementsAre("profile-value 1:13 warning: 5 is not in the list of SAMPLES | the values "
                          "beside it are 4 and 8"));
  EXPECT_THAT(profileProblems("profile.P = SAMPLES=4!FOG FOG!BLOOM"),
              testing::Contains(testing::HasSubstr("a blank is missing before !")));
}

TEST(ProfileTable, a_second_way_to_a_profile_is_a_circle_to_iris) {  // Iris: ProfileSet.parse
  EXPECT_THAT(profileProblems("profile.A=FOG\nprofile.B=profile.A\nprofile.C=profile.A profile.B"),
              ElementsAre("profile-repeated 2:11 warning: C reaches profile A a second time | Iris "
                          "takes that for a circle and refuses the pack"));
  EXPECT_THAT(profileProblems("profile.A=FOG\nprofile.B=profile.A\nprofile.C=profile.B"),
              IsEmpty());
}

struct CurrentCase {
  const char* text;
  OptionValues values;
  const char* current;
};

TEST(ProfileTable, the_current_one_is_detected) {  // Iris: ProfileSet.scan, Profile.matches
  const CurrentCase kCases[] = {
      {"profile.A=FOG\nprofile.B=!FOG", {}, "A"},
      {"profile.A=FOG\nprofile.B=!FOG", {{"FOG", "false"}}, "B"},
      {"profile.A=FOG SAMPLES=2", {{"SAMPLES", "8"}}, ""},
      {"profile.A=FOG\nprofile.B=FOG SAMPLES=4", {}, "B"},  // more options go first
      {"profile.A=FOG\nprofile.B=SAMPLES=4", {}, "A"},      // else the order of the file
      {"profile.A=FOG SAMPLES=4\nprofile.B=FOG GONE=1 LOST=2", {}, "B"},  // unknown ones count
      {"profile.A=", {}, "A"},
  };
  const OptionSet options = profileOptions();
  for (const CurrentCase& test : kCases) {
    const ShaderProperties properties = readProfiles(test.text);
    const Profile* found = detectProfile(properties.profiles, options, test.values);
    EXPECT_EQ(found ? found->name : "", test.current) << test.text;
  }
}

TEST(ScreenTable, words_are_options_keywords_or_links) {
  EXPECT_THAT(
      profileProblems("screen=<profile> <empty> FOG [S] *\nscreen.S=SAMPLES\nscreen.S.columns=1"),
      IsEmpty());
  EXPECT_THAT(
      profileProblems("screen=[WATER] \\\n  FGO <emtpy> [WATRE]\nscreen.WATER=[WATER]"),
      ElementsAre("screen-option 2:3 warning: the pack has no option FGO | did you mean FOG?",
                  "screen-option 2:7 warning: the pack has no option <emtpy> | did you mean "
                  "<empty>?",
                  "screen-option 2:15 warning: there is no screen [WATRE] | did you mean "
                  "WATER?"));
}

TEST(ScreenTable, a_link_that_resembles_no_screen_is_a_label) {
  EXPECT_THAT(profileProblems("screen=[READ_THIS_FIRST]"),
              ElementsAre("screen-option 1:8 note: there is no screen [READ_THIS_FIRST]"));
}

TEST(ScreenTable, a_word_is_not_found_inside_another) {
  EXPECT_THAT(profileProblems("screen = [FO] FOG FO\nscreen.FO=FOG"),
              ElementsAre("screen-option 1:19 warning: the pack has no option FO | did you "
                          "mean FOG?"));
}

struct KeyCase {
  const char *key, *meant;
};

TEST(PropertyKeys, misspelt_ones_are_reported_and_those_of_mods_are_not) {
  const KeyCase kCases[] = {
      {"shadow.enable", "shadow.enabled"},
      {"seperateAo", "separateAo"},
      {"texure.composite.colortex4", "texture.composite.colortex4"},
      {"uniforn.float.x", "uniform.float.x"},
      {"blned.gbuffers_water", "blend.gbuffers_water"},
      {"size.bufer.colortex1", "size.buffer.colortex1"},
      {"scren.WATER", "screen.WATER"},
      {"porfile.HIGH", "profile.HIGH"},
      {"slider", "sliders"},
      {"iris.feature.required", "iris.features.required"},
      {"moon.enabled", "moon"},
      {"photonics.enabled", ""},
      {"voxy.anything", ""},
      {"version.1.16.5", ""},
      {"myOwnKey", ""},
  };
  for (const KeyCase& test : kCases) {
    const auto messages = profileProblems(std::string(test.key) + " = 1");
    const std::string meant = test.meant;
    const std::string expected = "property-unknown 1:1 warning: unknown key " +
                                 std::string(test.key) + " | did you mean " + meant + "?";
    if (meant.empty()) {
      EXPECT_THAT(messages, IsEmpty()) << test.key;
    } else {
      EXPECT_THAT(messages, ElementsAre(expected));
    }
  }
}

}  // namespace
}  // namespace orris
