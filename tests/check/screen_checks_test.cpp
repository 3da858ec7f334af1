#include <orris/check/options/screen_checks.h>

#include "pack_fixture.h"

namespace orris {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const std::string kScreenOptions = "#define SAMPLES 4 // [2 4]\n#define FOG\n#ifdef FOG\n#endif\n";

std::vector<std::string> checkedScreens(PackCheck check, const std::string& properties) {
  return found(check, {{"/settings.glsl", kScreenOptions}, {"/shaders.properties", properties}});
}

TEST(ScreenLinks, a_screen_that_nobody_links_to_is_a_note) {
  EXPECT_THAT(checkedScreens(checkScreenLinks, "screen = [A]\nscreen.A = FOG\nscreen.B = FOG\n"),
              ElementsAre("screen-unlinked /shaders.properties:3:1: note: no screen links to [B]"));
  EXPECT_THAT(checkedScreens(checkScreenLinks, "screen.B = FOG\n"), IsEmpty());
}

TEST(ScreenLinks, columns_of_no_screen_are_a_warning_when_one_is_spelt_like_it) {
  EXPECT_THAT(
      checkedScreens(checkScreenLinks,
                     "screen=[WATER]\nscreen.WATER=FOG\nscreen.WAETR.columns=3\n"),
      ElementsAre("screen-columns /shaders.properties:3:1: warning: there is no screen WAETR "
                  "| did you mean WATER?"));
  EXPECT_THAT(
      checkedScreens(checkScreenLinks, "screen=[WATER]\nscreen.WATER=FOG\nscreen.OLD.columns=3\n"),
      ElementsAre("screen-columns /shaders.properties:3:1: note: there is no screen OLD"));
}

TEST(Sliders, a_misspelt_option_is_placed_on_its_continued_line) {
  EXPECT_THAT(
      checkedScreens(checkSliders, "sliders = FOG \\\n   SAMPELS \\\n   GONE\n"),
      ElementsAre("slider-option /shaders.properties:2:4: warning: the pack has no option "
                  "SAMPELS | did you mean SAMPLES?",
                  "slider-option /shaders.properties:3:4: note: the pack has no option GONE"));
}

TEST(Profiles, unknown_programs_are_reported_at_the_word) {
  EXPECT_THAT(
      checkedScreens(checkProfiles, "profile.LOW = !FOG \\\n !program.final !program.finla\n"),
      ElementsAre("profile-program /shaders.properties:2:17: warning: the pack has no program "
                  "finla | did you mean final?"));
}

TEST(Profiles, equal_ones_and_hidden_ones_are_notes) {
  EXPECT_THAT(
      checkedScreens(checkProfiles,
                     "profile.LOW = !FOG\nprofile.HIGH = FOG:false\nscreen = <profile> FOG\n"),
      ElementsAre("profile-same /shaders.properties:2:1: note: profile HIGH sets the same as LOW | "
                  "whoever chooses it is shown LOW as the current one"));
  EXPECT_THAT(
      checkedScreens(checkProfiles, "screen = FOG\nprofile.LOW = !FOG\n"),
      ElementsAre("profile-hidden /shaders.properties:2:1: note: no screen holds <profile>, "
                  "so nobody can choose one"));
}

}  // namespace
}  // namespace orris
