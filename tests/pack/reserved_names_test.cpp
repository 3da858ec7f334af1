#include <orris/pack/files/reserved_names.h>

#include <gmock/gmock.h>

namespace orris {
namespace {

using testing::ElementsAre;

std::vector<std::string> reserved(const std::string& text) {
  TokenStream stream;
  stream.sites.push_back({"/a.fsh"});
  stream.tokens = tokenize(text);
  for (Token& token : stream.tokens) token.origin.site = 0;
  Diagnostics diagnostics;
  checkReservedNames(stream, diagnostics);
  std::vector<std::string> found;
  for (const Diagnostic& d : diagnostics) {
    EXPECT_EQ(d.effect, Effect::RefusesProgram);
    found.push_back(std::to_string(d.at.line) + ":" + std::to_string(d.at.column) + " " +
                    d.message);
  }
  return found;
}

TEST(ReservedNames, are_those_that_begin_like_names_of_iris) {
  EXPECT_THAT(
      reserved("int a;\nvoid f() { float iris_fog; iris_fog = irisMainLight.moj_importX; }"),
      ElementsAre("2:18 iris_fog begins with iris_, as Iris's own names do; Iris refuses "
                  "the program",
                  "2:39 irisMainLight begins with irisMain, as Iris's own names do; Iris "
                  "refuses the program",
                  "2:53 moj_importX begins with moj_import, as Iris's own names do; Iris "
                  "refuses the program"));
}

TEST(ReservedNames, other_places_of_the_letters_are_free) {
  EXPECT_THAT(reserved("float my_iris_fog, iris, IRIS_X, Iris_y; // iris_comment"), ElementsAre());
}

}  // namespace
}  // namespace orris
