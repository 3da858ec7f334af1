#include <gmock/gmock.h>

#include <orris/gl/functions.h>
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
  for (const char* name : {"first", "second"}) {
    clock.start();
    gl::Clear(GL_COLOR_BUFFER_BIT);
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
