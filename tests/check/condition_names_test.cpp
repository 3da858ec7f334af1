#include <orris/check/pack/condition_names.h>

#include "pack_fixture.h"

namespace orris {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> conditions(const std::string& lines) {
  return found(checkConditionNames,
               {{"/settings.glsl", "#define ANTI_ALIASING 2 // [0 1 2]\n//#define FOG\n" + lines}});
}

TEST(ConditionNames, a_slip_of_an_option_or_macro_is_a_warning) {
  EXPECT_THAT(conditions("#if ANTI_ALIASIG == 2\n#endif\n"),
              ElementsAre("condition-undefined /settings.glsl:3:5: warning: nothing defines "
                          "ANTI_ALIASIG, so that it counts as 0 here | did you mean "
                          "ANTI_ALIASING?"));
  EXPECT_THAT(conditions("#ifdef ANTI_ALIASIGN\n#endif\n"),
              ElementsAre("condition-undefined /settings.glsl:3:8: warning: nothing defines "
                          "ANTI_ALIASIGN, so that it counts as not defined here | did you mean "
                          "ANTI_ALIASING?"));
  EXPECT_THAT(conditions("#if MC_VERSON >= 11300\n#elif defined(FGO) && MC_VERSON > 1\n#endif\n"),
              testing::Contains(testing::HasSubstr("did you mean MC_VERSION?")));
}

TEST(ConditionNames, an_unknown_one_is_a_note) {
  EXPECT_THAT(conditions("#if NEVER_HEARD_OF == 2\n#endif\n"),
              ElementsAre("condition-undefined /settings.glsl:3:5: note: nothing defines "
                          "NEVER_HEARD_OF, so that it counts as 0 here"));
}

TEST(ConditionNames, names_that_may_be_away_are_left_alone) {
  EXPECT_THAT(conditions("#if ANTI_ALIASING > 1 && defined FOG && MC_VERSION > 1\n#endif\n"
                         "#ifdef SOME_MOD\n#endif\n#if defined(OTHER_MOD) && OTHER_MOD > 2\n#endif\n"
                         "#if MC_GL_VENDOR_OTHERS == 1 // not ANTI_ALIASIG\n#endif\n"
                         "/*\n#if ANTI_ALIASIG\n*/\n"),
              IsEmpty());
  // Asked so often, it was an option once.
  EXPECT_THAT(conditions("#ifdef FOGG\n#endif\n#ifdef FOGG\n#endif\n#ifdef FOGG\n#endif\n"),
              IsEmpty());
}

}  // namespace
}  // namespace orris
