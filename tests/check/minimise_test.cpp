#include <orris/check/matrix/minimise.h>

#include <gmock/gmock.h>

namespace orris {
namespace {

/// Options A to Z, switches that are off, and QUALITY with four values.
OptionSet someOptions() {
  OptionSet options;
  for (char name = 'A'; name <= 'Z'; ++name) {
    const std::string text(1, name);
    options.all()[text] = {
        .name = text, .isBoolean = true, .defaultValue = "false", .values = {"true", "false"}};
  }
  options.all()["QUALITY"] = {
      .name = "QUALITY", .defaultValue = "0", .values = {"0", "1", "2", "3"}};
  return options;
}

OptionValues allOn() {
  OptionValues values{{"QUALITY", "2"}};
  for (char name = 'A'; name <= 'Z'; ++name) values[std::string(1, name)] = "true";
  return values;
}

bool isOn(const OptionValues& values, const char* name) { return values.contains(name); }

int quality(const OptionValues& values) {
  const auto found = values.find("QUALITY");
  return found == values.end() ? 0 : std::stoi(found->second);
}

/// A failure that nothing else hides.
FailsWith when(std::function<bool(const OptionValues&)> condition) {
  return [condition = std::move(condition)](const OptionValues& values) {
    return condition(values) ? Trial::Fails : Trial::Good;
  };
}

std::string causeOf(const FailsWith& fails, const std::vector<std::string>& others,
                    OptionValues values = allOn()) {
  const OptionSet options = someOptions();
  int tries = 200;
  const OptionValues minimal = minimalValues(values, fails, tries);
  const Cause cause = findCause(options, minimal, others, fails, 200);
  EXPECT_TRUE(cause.complete);
  return describe(cause, options);
}

TEST(Minimise, finds_the_two_options_that_matter) {
  EXPECT_EQ(causeOf(when([](auto& v) { return isOn(v, "C") && isOn(v, "X"); }), {}),
            "C=true and X=true");
}

TEST(Minimise, default_of_another_option_is_a_condition_when_it_matters) {
  EXPECT_EQ(causeOf(when([](auto& v) { return isOn(v, "C") && !isOn(v, "B"); }), {"A", "B"},
                    {{"C", "true"}}),
            "C=true and B=false");
}

TEST(Minimise, all_values_that_fail_are_named) {
  EXPECT_EQ(causeOf(when([](auto& v) { return quality(v) >= 2; }), {}), "QUALITY is 2 or 3");
  EXPECT_EQ(causeOf(when([](auto& v) { return quality(v) >= 1; }), {}), "QUALITY is not 0");
  EXPECT_EQ(causeOf(when([](auto& v) { return quality(v) < 2 && isOn(v, "A"); }), {"QUALITY"},
                    {{"A", "true"}}),
            "A=true and QUALITY is 0 or 1");
}

TEST(Minimise, failure_without_any_value_has_no_conditions) {
  EXPECT_EQ(causeOf(when([](auto&) { return true; }), {"A"}), "");
}

TEST(Minimise, another_failure_is_no_condition) {
  const FailsWith fails = [](const OptionValues& v) {
    if (isOn(v, "B")) return Trial::FailsOtherwise;
    return isOn(v, "A") ? Trial::Fails : Trial::Good;
  };
  EXPECT_EQ(causeOf(fails, {"B"}, {{"A", "true"}}), "A=true");
}

TEST(Minimise, says_when_it_could_not_try_all) {
  const OptionSet options = someOptions();
  const Cause cause = findCause(options, {{"A", "true"}}, {"B", "C", "D"},
                                when([](auto& v) { return isOn(v, "A"); }), 3);
  EXPECT_FALSE(cause.complete);
  int tries = 2;
  minimalValues(
      allOn(), when([](auto& v) { return isOn(v, "A"); }), tries);
  EXPECT_EQ(tries, 0);
}

}  // namespace
}  // namespace orris
