#include <orris/pack/options/live_options.h>

#include <gmock/gmock.h>

namespace orris {
namespace {

using testing::IsEmpty;

Option optionOf(std::vector<std::string> values) {
  Option option{.name = "X", .defaultValue = values.front(), .values = values};
  return option;
}

TEST(LiveOptions, numbers_of_one_kind_have_a_type) {
  EXPECT_EQ(liveType(optionOf({"1", "-2", "+30"})), LiveType::Int);
  EXPECT_EQ(liveType(optionOf({"1.0", ".5", "2.", "-1e3", "2.5E-1", "0.1f"})), LiveType::Float);
}

TEST(LiveOptions, what_glsl_reads_otherwise_has_none) {
  const std::vector<std::vector<std::string>> kOthers = {
      {"1", "1.0"},  // another type with each value
      {"010", "1"},  // octal
      {"0x1", "2"}, {"1u", "2u"}, {"LOW", "HIGH"}, {"1.0", "vec3"}, {"1.0", "."}, {"1.0", "1e"}, {"1.0", ""}, {"1.0"}};
  for (const auto& values : kOthers) EXPECT_EQ(liveType(optionOf(values)), std::nullopt) << values.back();
  Option boolean = optionOf({"1", "2"});
  boolean.isBoolean = true;
  EXPECT_EQ(liveType(boolean), std::nullopt);
}

TEST(LiveOptions, uniforms_are_declared_for_options_alone) {
  OptionSet options;
  options.all()["GAIN"] = optionOf({"1.0", "2.0"});
  options.all()["STEPS"] = optionOf({"1", "2"});
  options.all()["MODE"] = optionOf({"A", "B"});
  const auto uniforms = liveUniforms(options, {"GAIN", "STEPS", "MODE", "NONE"});
  ASSERT_EQ(uniforms.size(), 2u);
  EXPECT_EQ(uniforms[0].declaration, "uniform float orris_live_GAIN;");
  EXPECT_EQ(uniforms[1].name, "orris_live_STEPS");
  EXPECT_EQ(uniforms[1].declaration, "uniform int orris_live_STEPS;");
  EXPECT_THAT(liveUniforms(options, {}), IsEmpty());
}

}  // namespace
}  // namespace orris
