#include <orris/check/options/option_checks.h>

#include "pack_fixture.h"

namespace orris {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const std::string kUse = "float used = float(STEPS);\n";

TEST(OptionLists, a_value_given_twice_is_a_warning_but_for_a_slider) {
  const Files files{{"/settings.glsl", "\n  #define STEPS 4 // [2 4 8 4]\n"}};
  EXPECT_THAT(
      found(checkOptionLists, files),
      ElementsAre("option-value-twice /settings.glsl:2:11: warning: the list of STEPS has 4 "
                  "twice | the button that steps through the values never gets past the "
                  "second one"));
  Files slider = files;
  slider["/shaders.properties"] = "sliders = STEPS\n";
  EXPECT_THAT(found(checkOptionLists, slider),
              ElementsAre("option-value-twice /settings.glsl:2:11: note: the list of STEPS has 4 "
                          "twice"));
}

TEST(OptionLists, a_value_given_twice_to_an_option_on_no_screen_is_a_note) {
  EXPECT_THAT(found(checkOptionLists, {{"/settings.glsl", "#define STEPS 4 // [2 4 8 4]\n"},
                                       {"/shaders.properties", "screen = <empty>\n"}}),
              ElementsAre("option-value-twice /settings.glsl:1:9: note: the list of STEPS has 4 twice"));
}

TEST(OptionLists, a_value_given_twice_is_reported_in_whichever_file_it_stands) {
  EXPECT_THAT(found(checkOptionLists, {{"/final.vsh", "#version 120\n#define STEPS 4 // [2 4 8 4]\n"
                                                      "void main() {}\n"},
                                       {"/settings.glsl", "#define STEPS 4 // [2 4 8]\n"}}),
              ElementsAre(testing::StartsWith("option-value-twice /final.vsh:2:9: warning: ")));
}

TEST(OptionLists, a_default_outside_the_list_is_a_note) {
  EXPECT_THAT(found(checkOptionLists, {{"/settings.glsl", "#define STEPS 5 // [2 4 8]\n"}}),
              ElementsAre("option-default /settings.glsl:1:9: note: STEPS is 5, which its list "
                          "lacks; it is added at the end"));
}

TEST(OptionLists, commas_are_part_of_the_values) {
  EXPECT_THAT(found(checkOptionLists, {{"/settings.glsl", "#define A 0.05 // [0.00, 0.05]\n"}}),
              ElementsAre("option-list-commas /settings.glsl:1:9: warning: values of A end with a "
                          "comma, \"0.00,\": Iris separates them by blanks alone | write [1 2 3]"));
}

TEST(OptionLists, two_blanks_make_an_empty_value) {
  for (const char* list : {"[1  2]", "[ 1 2]"}) {
    EXPECT_THAT(
        found(checkOptionLists, {{"/settings.glsl", std::string("#define A 1 // ") + list + "\n"}}),
        ElementsAre(testing::StartsWith("option-value-empty /settings.glsl:1:9: warning: ")))
        << list;
  }
  EXPECT_THAT(found(checkOptionLists, {{"/settings.glsl", "#define A 1 // [1 2 ]\n"}}), IsEmpty());
}

TEST(OptionLists, lines_with_different_lists_are_reported_at_the_second) {
  EXPECT_THAT(
      found(checkOptionLists,
            {{"/settings.glsl", "#define STEPS 4 // [2 4 8]\n#define STEPS 4 // [4 16]\n"}}),
      ElementsAre("option-list-differs /settings.glsl:2:9: warning: the list of STEPS "
                  "differs from the one in /settings.glsl:1 | Iris shows the one of "
                  "/settings.glsl:2, whatever #if stands around it"));
  EXPECT_THAT(found(checkOptionLists, {{"/settings.glsl", "#define STEPS 4 // [2 4 8] so many\n"
                                                          "#define STEPS 4 // [4 16]\n"}}),
              ElementsAre(testing::EndsWith("Iris shows the one of /settings.glsl:1, whatever #if stands around it")));
  EXPECT_THAT(
      found(checkOptionLists,
            {{"/settings.glsl", "#define STEPS 4 // [2 4 8]\n#define STEPS 4 // [8 2 4]\n"}}),
      IsEmpty());
  const ShaderPack pack = loadPackWith(
      {{"/settings.glsl", "#define STEPS 4 // [2 4 8]\n#define STEPS 4 // [4 16]\n"}});
  Diagnostics diagnostics;
  checkOptionLists(std::span(&pack, 1), diagnostics);
  ASSERT_EQ(diagnostics.size(), 1u);
  EXPECT_THAT(diagnostics.front().related,
              ElementsAre(RelatedPlace{{"/settings.glsl", 1, 1}, "the other list"}));
}

TEST(OptionLists, of_lines_in_two_files_the_list_that_is_shown_is_named) {
  const std::string few = "#define STEPS 4 // [2 4 8]\n", many = "#define STEPS 4 // [2 4 8 16]\n";
  const auto shownIn = [&](const std::string& a, const std::string& b) {
    const ShaderPack pack = loadPackWith({{"/final.fsh", "#version 120\n" + a + "void main() {}\n"},
                                          {"/final.vsh", "#version 120\n" + b + "void main() {}\n"}});
    Diagnostics diagnostics;
    checkOptionLists(std::span(&pack, 1), diagnostics);
    const std::size_t values = pack.options.find("STEPS")->values.size();
    EXPECT_EQ(diagnostics.size(), 1u);
    return std::pair(diagnostics.empty() ? "" : diagnostics.front().hint, values);
  };
  // The order of Iris's table of files does not depend on what is in them.
  const auto [hint, values] = shownIn(few, many);
  const bool firstFile = values == 3;
  EXPECT_EQ(hint, firstFile ? "Iris shows the one of /final.fsh:2" : "Iris shows the one of /final.vsh:2");
  EXPECT_EQ(shownIn(many, few), std::pair(hint, std::size_t(firstFile ? 4 : 3)));
}

TEST(OptionUse, an_option_that_only_its_definition_names_changes_nothing) {
  EXPECT_THAT(found(checkOptionUse, {{"/settings.glsl", "#define STEPS 4 // [2 4 8] STEPS\n"}}),
              ElementsAre("option-unused /settings.glsl:1:9: warning: STEPS changes nothing: it is on a "
                          "screen, but no program and no condition of a properties file uses it | use it, or "
                          "take it off the screens"));
  EXPECT_THAT(found(checkOptionUse, {{"/settings.glsl", "#define STEPS 4 // [2 4 8] STEPS\n"},
                                     {"/shaders.properties", "screen = <empty>\n"}}),
              ElementsAre("option-unused /settings.glsl:1:9: note: STEPS changes nothing: no program and no "
                          "condition of a properties file uses it | use it, or remove it"));
}

TEST(OptionUse, many_numbers_without_texts_are_no_information) {
  EXPECT_THAT(found(checkOptionUse, {{"/settings.glsl", "#define STEPS 0 // [0 1 2 3 4 5]\n"},
                                     {"/lang/en_us.lang", "option.STEPS=Steps\n"}}),
              ElementsAre(testing::HasSubstr(": warning: ")));
}

TEST(OptionUse, any_mention_counts) {
  const std::string define = "#define STEPS 4 // [2 4 8]\n";
  const std::vector<Files> uses = {
      {{"/settings.glsl", define + "#if 0\n" + kUse + "#endif\n"}},
      {{"/settings.glsl", define}, {"/world1/composite.fsh", kUse}, {"/world1/composite.vsh", ""}},
      {{"/settings.glsl", define}, {"/shaders.properties", "#if STEPS > 2\n#endif\n"}},
      {{"/settings.glsl", define}, {"/shaders.properties", "uniform.int.n = STEPS\n"}},
      {{"/settings.glsl", define}, {"/block.properties", "#if STEPS > 2\nblock.1=dirt\n#endif\n"}},
      {{"/settings.glsl", define}, {"/ray0.rgen", kUse}},
      {{"/settings.glsl", define + "#define JOIN(a) a##EPS\n"}}};
  for (const Files& files : uses) {
    EXPECT_THAT(found(checkOptionUse, files), IsEmpty()) << files.rbegin()->second;
  }
}

TEST(OptionUse, what_only_shows_an_option_is_no_use) {
  const std::string properties = "screen = STEPS\nsliders = STEPS\nprofile.LOW = STEPS=2\n";
  EXPECT_THAT(found(checkOptionUse, {{"/settings.glsl", "#define STEPS 4 // [2 4 8]\n"},
                                     {"/shaders.properties", properties}}),
              testing::SizeIs(1));
}

TEST(OptionUse, what_may_be_meant_is_a_note) {
  const std::vector<Files> cases = {
      {{"/settings.glsl", "#define ABOUT 0 // [0]\n"}},
      {{"/settings.glsl", "#define PACK_INFO 7 // [7 9]\n"}},
      {{"/settings.glsl", "#define LEVEL 0 // [0 1 2]\n"}},
      {{"/settings.glsl", "#define THANKS T0 // [T0 T1 T2 T3 T4 T5]\n"},
       {"/lang/en_us.lang", "value.THANKS.T1=somebody\n"}},
      {{"/settings.glsl", "#define OCEAN_SUPPORT\n#ifdef OCEAN_SUPPORT\n#endif\n"}},
      {{"/settings.glsl", "#define STEPS 4 // [2 4 8]\n"},
       {"/shaders.properties", "screen = X\n"}}};
  for (const Files& files : cases) {
    EXPECT_THAT(found(checkOptionUse, files), ElementsAre(testing::HasSubstr(": note: ")))
        << files.begin()->second;
  }
}

TEST(OptionUse, directives_are_read_by_the_host) {
  EXPECT_THAT(found(checkOptionUse,
                    {{"/settings.glsl", "const float shadowDistance = 80.0; // [40.0 80.0]\n"}}),
              IsEmpty());
}

TEST(HiddenOptions, an_option_on_no_screen_is_a_note_unless_the_rest_is_shown) {
  Files files{{"/settings.glsl", "#define A 1 // [1 2]\n#define B 1 // [1 2]\n"},
                        {"/shaders.properties", "screen = [SUB]\nscreen.SUB = A\n"}};
  EXPECT_THAT(found(checkHiddenOptions, files),
              ElementsAre("option-hidden /settings.glsl:2:9: note: no screen shows B"));
  files["/shaders.properties"] = "screen = [SUB] *\nscreen.SUB = A\n";
  EXPECT_THAT(found(checkHiddenOptions, files), IsEmpty());
  files.erase("/shaders.properties");
  EXPECT_THAT(found(checkHiddenOptions, files), IsEmpty());
}

}  // namespace
}  // namespace orris
