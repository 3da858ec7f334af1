#include <orris/chart/measure/setting_result.h>

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

namespace orris {
namespace {

SettingResult someResult() {
  SettingResult result;
  result.label = "A=1 B=\"2\"\n";
  result.key = "0123";
  result.chosen = "A=MAP";
  ErrorSummary error;
  error.frames = 16;
  error.signedBias = -0.1;
  error.bias = 0.25;
  error.biasInterval = {0.2, 0.3};
  error.noise = 0.5;
  error.accumulated = {{1, 0.56, {0.5, 0.6}}, {2, 0.43, {0.4, 0.5}}};
  error.relMse = 1.5;
  error.relMseMedian = 0.5;
  error.relMseTrimmed = 0.75;
  result.error = error;
  result.ssim = 0.875;
  result.pairs = {{2, 1}, {2.5, 1.25}};
  result.frames = {1, 2, 3};
  result.passes = {{"deferred", {0.5, 0.25}}, {"final", {0.125}}};
  return result;
}

TEST(SettingResult, ComesBackAsItWas) {
  EXPECT_EQ(parseResult(writeResult(someResult())), someResult());
  SettingResult unmeasured;
  unmeasured.label = "x";
  EXPECT_EQ(parseResult(writeResult(unmeasured)), unmeasured);
}

TEST(SettingResult, InfiniteErrorsComeBack) {
  SettingResult result = someResult();
  result.error->bias = result.error->relMse = std::numeric_limits<double>::infinity();
  EXPECT_EQ(parseResult(writeResult(result)), result);
}

TEST(SettingResult, OtherTextsAreNone) {
  for (const char* text : {"", "{}", "[1]", "null", "{\"setting\": 1}", "\xff\xfe",
                           "{\"setting\":\"a\",\"key\":\"b\",\"error\":[],\"ssim\":1}"})
    EXPECT_FALSE(parseResult(text)) << text;
  const std::string whole = writeResult(someResult());
  for (std::size_t length = 0; length + 2 < whole.size(); length += 7)
    EXPECT_FALSE(parseResult(whole.substr(0, length))) << length;
}

TEST(ErrorSummary, AfterTakesTheLongestRunThatIsNotLonger) {
  const ErrorSummary error = *someResult().error;
  EXPECT_EQ(error.after(1).frames, 1);
  EXPECT_EQ(error.after(2).frames, 2);
  EXPECT_EQ(error.after(1000).frames, 2);
}

}  // namespace
}  // namespace orris
