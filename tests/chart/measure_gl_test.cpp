#include <gmock/gmock.h>

#include <cmath>

#include <orris/chart/measure/measure.h>
#include <orris/chart/study/study_key.h>
#include <orris/core/files/file_source.h>

namespace orris {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

/// colortex0 is LEVEL with a noise of +-NOISE from frame to frame, at the price of WORK.
constexpr const char* kComposite = R"(#version 330 compatibility
/*
const int colortex0Format = RGBA32F;
*/
#define LEVEL 1.0 // [1.0 1.5 2.0]
#define NOISE 0.0 // [0.0 0.5]
#define WORK 1 // [1 6000 2]
uniform int frameCounter;
in vec2 uv;
void main() {
  float sum = 0.0;
  for (int i = 0; i < WORK; ++i) sum += sin(uv.x * float(i));
#if WORK == 2
  broken
#endif
  float noise = frameCounter % 2 == 0 ? NOISE : -NOISE;
  gl_FragData[0] = vec4(vec3(LEVEL + noise + clamp(sum, 0.0, 1e-9)), 1.0);
}
)";
constexpr const char* kVertex =
    "#version 330 compatibility\nout vec2 uv;\nvoid main() {\n"
    "  gl_Position = ftransform();\n  uv = gl_MultiTexCoord0.xy;\n}\n";

class MeasureTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    Diagnostics diagnostics;
    context_ = gl::createContext({}, diagnostics).release();
    ASSERT_NE(context_, nullptr);
  }
  static void TearDownTestSuite() { delete std::exchange(context_, nullptr); }
  void SetUp() override {
    files_ = memorySource({{"/composite.vsh", kVertex}, {"/composite.fsh", kComposite}});
    world_.blocks = BlockWorld({0, 0, 0}, {2, 2, 2});
    world_.cameras = defaultCameras(world_.blocks);
    plan_ = {.warmUp = 2, .frames = 8, .rounds = 3, .visit = 2, .buffer = "colortex0"};
    reference_.mean = ImageF(24, 16, 3);
    for (float& value : reference_.mean.pixels) value = 1;
    reference_.first = reference_.second = reference_.mean;
  }

  SessionRequest request(OptionValues values) {
    SessionRequest request;
    request.openPack = [this](Diagnostics&) { return files_; };
    request.load.values = std::move(values);
    request.renderer = {.width = 24, .height = 16};
    request.camera = world_.cameras.front();
    return request;
  }
  SettingJob job(const std::string& label, OptionValues values) {
    SettingJob job;
    job.request = request(std::move(values));
    job.reference = &reference_;
    job.result.label = label;
    return job;
  }
  MeasureHooks hooks() {
    return {[this](int frames) { drawn_ += frames; },
            [this](const SettingJob& job) { changed_.push_back(job.result.label); },
            [this](const SettingJob&, const ImageF& frame, const ImageF& mean) {
              frame_ = frame;
              mean_ = mean;
            }};
  }
  void run(const std::vector<SettingJob*>& jobs,
           std::optional<Measuring::Clock::time_point> end = {}) {
    const MeasureHooks callbacks = hooks();
    Measuring(*context_, world_, plan_, callbacks, end).run(jobs, diagnostics_);
    EXPECT_THAT(context_->takeErrors(), SizeIs(0));
  }

  static inline gl::Context* context_ = nullptr;
  std::shared_ptr<const FileSource> files_;
  World world_;
  MeasurePlan plan_;
  ReferencePicture reference_;
  Diagnostics diagnostics_;
  int drawn_ = 0;
  std::vector<std::string> changed_;
  ImageF frame_, mean_;
};

constexpr double kPictureScale = 1 / 1.02;

TEST_F(MeasureTest, BiasAndNoiseAreThoseOfThePicture) {
  plan_.frames = 16;  // two a batch, whose noise cancels
  SettingJob baseline = job("exact", {}), wrong = job("wrong", {{"LEVEL", "1.5"}}),
             noisy = job("noisy", {{"LEVEL", "2.0"}, {"NOISE", "0.5"}});
  run({&baseline, &wrong, &noisy});
  EXPECT_THAT(diagnostics_, SizeIs(0));
  EXPECT_EQ(baseline.result.error->bias, 0);
  EXPECT_EQ(baseline.result.ssim, 1);
  EXPECT_NEAR(wrong.result.error->bias, 0.5 * kPictureScale, 1e-6);
  EXPECT_EQ(wrong.result.error->noise, 0);
  EXPECT_NEAR(noisy.result.error->bias, 1 * kPictureScale, 1e-6);
  EXPECT_NEAR(noisy.result.error->noise, 0.5 * std::sqrt(16.0 / 15) * kPictureScale, 1e-6);
  EXPECT_NEAR(noisy.result.error->after(1).error, std::sqrt(1.25) * kPictureScale, 1e-6);
  EXPECT_NEAR(noisy.result.error->after(2).error, 1 * kPictureScale, 1e-6);
  EXPECT_NEAR(mean_.pixels[0], 2, 1e-6);
  EXPECT_NEAR(std::abs(frame_.pixels[0] - 2), 0.5, 1e-6);
}

TEST_F(MeasureTest, CostsAreTimedInTurnsAndByPass) {
  if (!gl::isSoftwareRenderer(context_->driver().renderer)) GTEST_SKIP() << "a GPU does this work in no time";
  SettingJob baseline = job("cheap", {}), dear = job("dear", {{"WORK", "6000"}}), again;
  again.request = baseline.request;
  run({&baseline, &dear, &again});
  for (const SettingJob* measured : {&baseline, &dear, &again}) {
    EXPECT_THAT(measured->result.pairs, SizeIs(3));
    EXPECT_THAT(measured->result.frames, SizeIs(12));
    EXPECT_THAT(measured->result.frames, Each(testing::Gt(0)));
    ASSERT_FALSE(measured->result.passes.empty());
  }
  for (const TimePair& pair : baseline.result.pairs) EXPECT_EQ(pair.own, pair.baseline);
  const auto composite = [](const SettingJob& measured) {
    for (const PassTimes& pass : measured.result.passes)
      if (pass.name == "composite") return median(pass.times);
    return 0.0;
  };
  EXPECT_GT(composite(dear), 2 * composite(baseline));
  EXPECT_GT(pairedCost(dear.result.pairs).ratio, 1);
  EXPECT_GT(composite(baseline), 0);
  EXPECT_FALSE(again.result.error);
}

TEST_F(MeasureTest, OneSettingThatCannotBeDrawnEndsOnlyItself) {
  SettingJob baseline = job("good", {}), broken = job("broken", {{"WORK", "2"}}),
             other = job("other", {{"LEVEL", "2.0"}});
  run({&baseline, &broken, &other});
  EXPECT_TRUE(hasErrors(diagnostics_));
  EXPECT_FALSE(broken.done(plan_));
  EXPECT_TRUE(baseline.done(plan_));
  EXPECT_TRUE(other.done(plan_));
}

TEST_F(MeasureTest, WhatIsKnownIsNotMeasuredAgain) {
  SettingJob baseline = job("a", {}), other = job("b", {{"LEVEL", "2.0"}});
  run({&baseline, &other});
  EXPECT_EQ(drawn_, 2 * (2 + 8 + 3 * 2 * 3));
  drawn_ = 0;
  run({&baseline, &other});
  EXPECT_EQ(drawn_, 0);
  EXPECT_EQ(framesLeft({&baseline, &other}, plan_), 0);

  other.result.pairs.resize(1);
  EXPECT_EQ(framesLeft({&baseline, &other}, plan_), 2 + 2 * 2 * 3);
  run({&baseline, &other});
  EXPECT_EQ(drawn_, 2 * 2 + 2 * 2 * 2 * 3);  // the baseline again beside it
  EXPECT_THAT(other.result.pairs, SizeIs(3));
  EXPECT_THAT(baseline.result.pairs, SizeIs(5));
}

TEST_F(MeasureTest, FewerAliveAtATimeGiveTheSameResults) {
  plan_.alive = 1;
  SettingJob baseline = job("a", {}), b = job("b", {{"LEVEL", "1.5"}}),
             c = job("c", {{"LEVEL", "2.0"}});
  run({&baseline, &b, &c});
  EXPECT_NEAR(b.result.error->bias, 0.5 * kPictureScale, 1e-6);
  EXPECT_NEAR(c.result.error->bias, 1 * kPictureScale, 1e-6);
  EXPECT_TRUE(b.done(plan_) && c.done(plan_));
}

TEST_F(MeasureTest, TheBudgetLeavesTheRestForLater) {
  SettingJob baseline = job("a", {}), other = job("b", {{"LEVEL", "2.0"}});
  run({&baseline, &other}, Measuring::Clock::now());
  EXPECT_EQ(drawn_, 0);
  EXPECT_FALSE(baseline.errorDone());
  run({&baseline, &other}, Measuring::Clock::now() + std::chrono::minutes(5));
  EXPECT_TRUE(baseline.done(plan_) && other.done(plan_));
}

TEST_F(MeasureTest, AnUnknownBufferIsReportedWithThoseThatExist) {
  plan_.buffer = "colortex7";
  SettingJob baseline = job("a", {});
  run({&baseline});
  ASSERT_THAT(diagnostics_, SizeIs(1));
  EXPECT_EQ(diagnostics_[0].message, "a has no buffer colortex7 as large as the screen");
  EXPECT_THAT(diagnostics_[0].hint, HasSubstr("colortex0"));
  EXPECT_FALSE(baseline.errorDone());
}

TEST_F(MeasureTest, AReferenceIsTheMeanOfTwoHalves) {
  const MeasureHooks callbacks = hooks();
  Measuring measuring(*context_, world_, plan_, callbacks, {});
  const auto drawn = measuring.drawReference(request({{"NOISE", "0.5"}}), 6, diagnostics_);
  ASSERT_TRUE(drawn);
  EXPECT_EQ(drawn_, 2 + 8 + 6);
  // Three frames each: one has two of the bright, the other two of the dark.
  EXPECT_NEAR(std::abs(drawn->first.pixels[0] - 1), 0.5 / 3, 1e-6);
  EXPECT_NEAR(drawn->first.pixels[0] + drawn->second.pixels[0], 2, 1e-6);
  EXPECT_NEAR(drawn->mean.pixels[0], 1, 1e-6);
}

// Clouds that drift between the frames of a setting and those of its reference would be taken for its
// error.
TEST_F(MeasureTest, WhatMovesWithTimeStandsStill) {
  files_ = memorySource({{"/final.vsh", kVertex},
                         {"/final.fsh",
                          "#version 330 compatibility\nuniform float frameTimeCounter;\n"
                          "uniform float frameTime;\nvoid main() { gl_FragColor = "
                          "vec4(vec3(frameTimeCounter * 0.5 + 0.0 / frameTime), 1.0); }\n"}});
  plan_ = {.warmUp = 30, .frames = 16, .rounds = 1, .visit = 1};
  const MeasureHooks callbacks = hooks();
  Measuring measuring(*context_, world_, plan_, callbacks, {});
  const auto drawn = measuring.drawReference(request({}), 16, diagnostics_);
  ASSERT_TRUE(drawn);
  EXPECT_LT(noiseFloor(*drawn), 1e-4);
  reference_ = *drawn;
  SettingJob same = job("same", {});
  run({&same});
  EXPECT_LT(same.result.error->after(1).error, 1e-3);
  EXPECT_GT(mean_.pixels[0], 0.01);
}

TEST_F(MeasureTest, TheScreenIsDecoded) {
  files_ = memorySource({{"/final.vsh", kVertex},
                         {"/final.fsh",
                          "#version 330 compatibility\nvoid main() { gl_FragColor = "
                          "vec4(0.5, 0.5, 0.5, 1.0); }\n"}});
  plan_.buffer = "";
  SettingJob baseline = job("a", {});
  run({&baseline});
  EXPECT_NEAR(mean_.pixels[0], 0.2140, 1e-3);
}

TEST_F(MeasureTest, TheKeyTellsWhatTheNumbersDependOn) {
  const auto keyOf = [&](const SettingJob& measured) {
    return settingKey(studyDigest(*files_, world_, context_->driver()), measured, plan_);
  };
  const std::uint32_t stone = world_.blocks.paletteIndex(*parseBlockState("minecraft:stone"));
  SettingJob plain = job("a", {});
  const std::string key = keyOf(plain);
  plain.result.label = "other name";
  plan_.rounds = 99;  // more pairs are only added
  EXPECT_EQ(keyOf(plain), key);
  std::vector<std::string> others = {keyOf(job("a", {{"LEVEL", "2.0"}}))};
  SettingJob larger = plain;
  larger.request.renderer.width = 25;
  others.push_back(keyOf(larger));
  reference_.mean.pixels[7] = 3;
  others.push_back(keyOf(plain));
  reference_.mean.pixels[7] = 1;
  world_.blocks.set({1, 1, 1}, stone);
  others.push_back(keyOf(plain));
  plan_.frames = 9;
  others.push_back(keyOf(plain));
  files_ = memorySource({{"/composite.fsh", "void main() {}"}});
  others.push_back(keyOf(plain));
  others.push_back(key);
  std::sort(others.begin(), others.end());
  EXPECT_EQ(std::adjacent_find(others.begin(), others.end()), others.end());
}

TEST(Turns, GoThereAndBack) {
  EXPECT_THAT(turns(3), ElementsAre(0, 1, 2, 2, 1, 0));
  EXPECT_THAT(turns(0), SizeIs(0));
}

}  // namespace
}  // namespace orris
