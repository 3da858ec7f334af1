#include <gmock/gmock.h>

#include <orris/gl/functions.h>
#include <orris/gl/texture.h>
#include <orris/image/texel_format.h>
#include <orris/render/inspect/step_clock.h>
#include "gl/gl_test_context.h"

namespace orris {
namespace {

using testing::AllOf;
using testing::Ge;
using testing::Le;
using testing::Optional;

using StepClockGL = gl::GlTest;

// Time stamps of a software rasteriser are no measure, but they are asked for and read as a card's are.
TEST_F(StepClockGL, stamps_of_a_card_lie_within_the_time_that_passed) {
  StepClock clock(true);
  const gl::Texture target = gl::createTexture(2, *findFormat("RGBA8"), 16, 16, 1, 1, "target");
  for (const char* name : {"first", "second"}) {
    clock.start();
    gl::ClearTexImage(target.id(), 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    const StepTime time = clock.stop(name);
    EXPECT_EQ(time.name, name);
    EXPECT_GT(time.processorSeconds, 0);
    EXPECT_THAT(time.cardSeconds, Optional(AllOf(Ge(0), Le(time.seconds))));
  }
}

TEST_F(StepClockGL, without_a_card_there_are_no_stamps) {
  StepClock clock(false);
  clock.start();
  const StepTime time = clock.stop("step");
  EXPECT_GT(time.seconds, 0);
  EXPECT_EQ(time.cardSeconds, std::nullopt);
}

}  // namespace
}  // namespace orris
