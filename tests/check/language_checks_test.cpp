#include <orris/check/options/language_checks.h>

#include "pack_fixture.h"

namespace orris {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kLanguageOptions =
    "#define SHADOW_STEPS 4 // [2 4]\n#define MODE FAST // [FAST FANCY]\n#define WATER_FOG\n"
    "#ifdef WATER_FOG\n#endif\n";
const std::string kScreens =
    "screen = <profile> SHADOW_STEPS \\\n  [WATER]\nscreen.WATER = MODE\n"
    "profile.HIGH = WATER_FOG\n";

std::vector<std::string> checkedLanguage(PackCheck check, const std::string& lang,
                                         const std::string& file = "/lang/en_us.lang") {
  return found(
      check,
      {{"/settings.glsl", kLanguageOptions}, {"/shaders.properties", kScreens}, {file, lang}});
}

TEST(LanguageKeys, known_keys_and_those_of_other_hosts_are_quiet) {
  EXPECT_THAT(
      checkedLanguage(checkLanguageKeys,
                      "# comment\noption.MODE=Mode\noption.MODE.comment=x\nvalue.MODE.FAST=Fast\n"
                      "prefix.SHADOW_STEPS=~\nsuffix.SHADOW_STEPS=x\nscreen.WATER=Water\n"
                      "screen.WATER.comment=x\nprofile.HIGH=High\nprofile.HIGH.comment=x\n"
                      "profile.comment=x\npack.title=x\n"),
      IsEmpty());
}

TEST(LanguageKeys, a_link_shows_its_text_without_a_screen) {
  EXPECT_THAT(found(checkLanguageKeys, {{"/settings.glsl", kLanguageOptions},
                                        {"/shaders.properties", "screen = MODE [LABEL]\n"},
                                        {"/lang/en_us.lang", "screen.LABEL=read this\n"}}),
              IsEmpty());
}

TEST(LanguageKeys, a_misspelt_key_is_a_warning_at_its_line) {
  const std::string unused = " is used for nothing: there is no ";
  EXPECT_THAT(
      checkedLanguage(
          checkLanguageKeys,
          "option.SHADOW_STPES=a\n\n  value.MODE.FNACY=b\nscreen.WATRE=c\nprofile.HIHG=d\n"
          "opton.MODE=e\n"),
      ElementsAre("language-key /lang/en_us.lang:1:1: warning: the text of option.SHADOW_STPES" +
                      unused + "option SHADOW_STPES | did you mean SHADOW_STEPS?",
                  "language-key /lang/en_us.lang:3:3: warning: the text of value.MODE.FNACY" +
                      unused + "value FNACY | did you mean FANCY?",
                  "language-key /lang/en_us.lang:4:1: warning: the text of screen.WATRE" + unused +
                      "screen WATRE | did you mean WATER?",
                  "language-key /lang/en_us.lang:5:1: warning: the text of profile.HIHG" + unused +
                      "profile HIHG | did you mean HIGH?",
                  "language-key /lang/en_us.lang:6:1: warning: the text of opton.MODE" + unused +
                      "kind of text opton | did you mean option?"));
}

TEST(LanguageKeys, the_one_value_with_a_misspelt_option_is_a_warning) {
  EXPECT_THAT(
      checkedLanguage(
          checkLanguageKeys,
          "value.SHADOW_STEPS.2=two\nvalue.SHAODW_STEPS.4=four\nvalue.MODE.FAST=Fast\n"),
      ElementsAre("language-key /lang/en_us.lang:2:1: warning: the text of "
                  "value.SHAODW_STEPS.4 is used for nothing: there is no option SHAODW_STEPS | did "
                  "you mean SHADOW_STEPS?"));
  // Not when that value has its text, or when the old name occurs throughout.
  for (const char* lang :
       {"value.SHADOW_STEPS.2=a\nvalue.SHADOW_STEPS.4=b\nvalue.SHAODW_STEPS.4=c\n",
        "value.SHADOW_STEPS.2=a\nvalue.SHAODW_STEPS.4=b\nvalue.SHAODW_STEPS.8=c\n",
        "value.SHADOW_STEPS.2=a\nvalue.SHAODW_STEPS.9=b\n"}) {
    EXPECT_THAT(checkedLanguage(checkLanguageKeys, lang), Each(HasSubstr("language-stale ")))
        << lang;
  }
}

TEST(LanguageKeys, what_is_left_over_is_one_finding) {
  EXPECT_THAT(checkedLanguage(checkLanguageKeys,
                              "option.BLOOM=a\noption.SHADOW_STEP=b\noption.SHADOW_STEPS=c\n"
                              "value.MODE.SLOW=d\noption.SHADOW_STEPS_OLD=e\n"),
              ElementsAre("language-stale /lang/en_us.lang:1:1: warning: the pack has no option "
                          "BLOOM, and 3 more lines are for nothing | take lines away whose options "
                          "are gone"));
  EXPECT_THAT(checkedLanguage(checkLanguageKeys, "option.BLOOM=a\nvalue.MODE.SLOW=d\n"),
              ElementsAre(HasSubstr("the pack has no option BLOOM, and one more line is for nothing")));
  EXPECT_THAT(checkedLanguage(checkLanguageKeys, "value.MODE.SLOW=d\n"),
              ElementsAre("language-stale /lang/en_us.lang:1:1: warning: MODE has no value SLOW | "
                          "take lines away whose options are gone"));
}

TEST(LanguageKeys, each_line_that_is_left_over_is_a_place_of_the_finding) {
  const ShaderPack pack =
      loadPackWith({{"/lang/en_us.lang", "option.BLOOM=a\noption.OTHER_ONE=b\nvalue.GONE.1=c\n"}});
  Diagnostics diagnostics;
  checkLanguageKeys(std::span(&pack, 1), diagnostics);
  ASSERT_EQ(diagnostics.size(), 1u);
  EXPECT_THAT(diagnostics.front().related,
              ElementsAre(testing::Field(&RelatedPlace::message, "the pack has no option OTHER_ONE"),
                          testing::Field(&RelatedPlace::message, "the pack has no option GONE")));
  EXPECT_EQ(diagnostics.front().related.back().at.line, 3);
}

TEST(LanguageKeys, a_second_text_is_a_warning_where_it_differs) {
  EXPECT_THAT(checkedLanguage(checkLanguageKeys, "option.MODE=a\noption.MODE = a\noption.MODE=b\n"),
              ElementsAre("language-twice /lang/en_us.lang:3:1: warning: option.MODE has another "
                          "text in line 1, which is lost"));
}

TEST(LanguageKeys, many_second_texts_are_one_finding) {
  std::string text;
  for (const char* value : {"a", "b"}) {
    for (const char* name : {"MODE", "A", "B", "C"}) {
      text += std::string("option.") + name + '=' + value + '\n';
    }
  }
  EXPECT_THAT(checkedLanguage(checkLanguageKeys, text),
              testing::Contains("language-twice /lang/en_us.lang:5:1: warning: option.MODE and 3 "
                                "later lines of this file give keys another text, so that the "
                                "earlier one is lost"));
}

TEST(LanguageKeys, a_line_after_two_slashes_was_meant_as_a_comment) {
  EXPECT_THAT(checkedLanguage(checkLanguageKeys, "// a\n// b\n//value.MODE.FAST=c\n"), IsEmpty());
}

TEST(LanguageKeys, files_are_named_after_languages) {
  EXPECT_THAT(
      checkedLanguage(checkLanguageKeys, "", "/lang/english.lang"),
      ElementsAre("language-file /lang/english.lang:0:0: warning: the file is named after no "
                  "language, so nobody sees its texts | names are like en_us.lang, de_de.lang, "
                  "zh_cn.lang"));
  for (const char* name : {"/lang/en_US.lang", "/lang/lzh.lang", "/lang/sr_cs.lang"}) {
    EXPECT_THAT(checkedLanguage(checkLanguageKeys, "", name), IsEmpty()) << name;
  }
}

TEST(LanguageCover, what_the_screens_show_without_a_text_is_one_finding) {
  EXPECT_THAT(
      checkedLanguage(checkLanguageCover, "option.SHADOW_STEPS=a\n"),
      ElementsAre("language-missing /shaders.properties:2:3: warning: en_us.lang has no text for "
                  "screen.WATER and 2 more that players see"));
  EXPECT_THAT(checkedLanguage(checkLanguageCover, "", "/lang/de_de.lang"), IsEmpty());
}

TEST(LanguageCover, profiles_that_no_screen_offers_need_no_text) {
  EXPECT_THAT(found(checkLanguageCover, {{"/settings.glsl", kLanguageOptions},
                                         {"/shaders.properties", "profile.HIGH = WATER_FOG\n"},
                                         {"/lang/en_us.lang", "option.MODE=a\n"}}),
              IsEmpty());
}

}  // namespace
}  // namespace orris
