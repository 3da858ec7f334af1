#include <orris/glsl/rewrite/ambiguous_calls.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "glsl/glsl_test.h"

namespace orris {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kLog =
    "0(5) : error C1101: ambiguous overloaded function reference \"clamp(int, float, float)\"\n"
    "    (0) : gp5 float64_t clamp(float64_t, float64_t, float64_t)\n"
    "    (0) : float clamp(float, float, float)\n";

StageText calling(const std::string& statements) {
  Diagnostics diagnostics;
  const std::string text = "#version 450\nlayout(location = 0) out vec4 color;\nlayout(location = 0) flat in ivec4 i;\n"
                           "layout(location = 1) in vec4 f;\nvoid main() {\n" + statements + "\n}\n";
  TokenStream stream = preprocess(test::flatten({{"/a.fsh", text}}, "/a.fsh"), {}, diagnostics);
  return {Stage::Fragment, print(stream)};
}

std::string errorsOf(const StageText& stage) {
  Diagnostics diagnostics;
  validateWithGlslang({&stage}, [](const std::string&, int) { return ""; }, diagnostics);
  return test::format(diagnostics);
}

TEST(ambiguous_calls, functions_that_the_log_names_become_the_hosts) {
  const auto settled = settleAmbiguousCalls(calling("color = vec4(clamp(i.x, 0.0, f.x), mod(i.y, 2.0), 0.0, 1.0);"), kLog);
  ASSERT_TRUE(settled);
  EXPECT_THAT(settled->text.text, AllOf(HasSubstr("vec4(orris_clamp(i.x, 0.0, f.x), mod(i.y, 2.0)"),
                                        HasSubstr("float orris_clamp(float x, float p1, float p2)")));
  EXPECT_EQ(errorsOf(*settled), "");
}

TEST(ambiguous_calls, every_call_that_was_valid_stays_so) {
  const std::string log = std::string(kLog) + "0(6) : error C1101: ambiguous overloaded function reference \"mod(int, float)\"\n";
  const auto settled = settleAmbiguousCalls(
      calling("float x = clamp(i.x, 0, f.x) + clamp(f.x, i.x, i.y) + mod(i.x, i.y) + mod(f.x, 2);\n"
              "vec3 y = clamp(f.xyz, 0.0, 1.0) + clamp(f.xyz, f.yzw, vec3(1)) + clamp(i.xyz, 0.0, 1.0) + mod(i.xyz, 2.0);\n"
              "ivec2 z = clamp(i.xy, 0, 4) + clamp(i.xy, i.yz, i.zw) + int(clamp(uint(i.x), 0u, 4u));\n"
              "color = vec4(x, y) + vec4(z, z);"),
      log);
  ASSERT_TRUE(settled);
  EXPECT_EQ(errorsOf(*settled), "");
  EXPECT_THAT(settled->text.text, AllOf(Not(HasSubstr(" clamp(f")), Not(HasSubstr(" mod(i"))));
}

TEST(ambiguous_calls, are_settled_once) {
  const auto settled = settleAmbiguousCalls(calling("color = vec4(clamp(i.x, 0.0, f.x));"), kLog);
  ASSERT_TRUE(settled);
  EXPECT_EQ(settleAmbiguousCalls(*settled, kLog), std::nullopt);
}

TEST(ambiguous_calls, of_other_failures_nothing_is_settled) {
  const StageText stage = calling("color = vec4(clamp(i.x, 0.0, f.x));");
  EXPECT_EQ(settleAmbiguousCalls(stage, "0(5) : error C1008: undefined variable \"clamp\""), std::nullopt);
  EXPECT_EQ(settleAmbiguousCalls(stage, "0(5) : error C1101: ambiguous overloaded function reference \"own(int)\""),
            std::nullopt);
}

}  // namespace
}  // namespace orris
