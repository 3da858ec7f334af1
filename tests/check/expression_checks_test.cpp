#include <orris/check/pack/expression_checks.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "frame_fixture.h"

namespace orris {
namespace {

std::vector<std::string> messagesFor(const std::string& properties) {
  Files files = cleanPack();
  files["/shaders.properties"] = properties;
  return messagesOf(checkCustomUniforms, files);
}

TEST(CustomUniforms, those_that_evaluate_are_no_problem) {
  EXPECT_THAT(messagesFor("variable.float.a = sin(frameTimeCounter)\n"
                          "uniform.vec2.b = vec2(a, 1.0 / viewWidth)\n"),
              testing::IsEmpty());
}

TEST(CustomUniforms, names_that_do_not_exist_and_syntax_are_reported_at_their_line) {
  EXPECT_THAT(messagesFor("\nuniform.float.a = sni(1.0)\n"),
              testing::ElementsAre(testing::StartsWith("uniform-dropped /shaders.properties:2:")));
  EXPECT_THAT(messagesFor("\nuniform.float.a = frameTimeConter\n"),
              testing::ElementsAre(testing::StartsWith("uniform-dropped /shaders.properties:2:")));
  EXPECT_THAT(messagesFor("\nuniform.float.a = sin(1.0\n"),
              testing::ElementsAre(testing::HasSubstr(" /shaders.properties:2:")));
}

}  // namespace
}  // namespace orris
