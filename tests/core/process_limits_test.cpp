#include <gtest/gtest.h>
#include <orris/core/process_limits.h>
#include <unistd.h>

namespace orris {
namespace {

rlim_t mostFiles() {
  rlimit limit{};
  getrlimit(RLIMIT_NOFILE, &limit);
  return limit.rlim_cur == limit.rlim_max ? limit.rlim_max : 0;
}

// In a child, as no process gets back what it gave up.
TEST(process_limits, stay_as_low_as_they_were_set) {
  const auto lower = [] {
    limitTo(RLIMIT_NOFILE, 50);
    const bool lowered = mostFiles() == 50;
    limitTo(RLIMIT_NOFILE, 60);
    _exit(lowered && mostFiles() == 50 ? 0 : 1);
  };
  EXPECT_EXIT(lower(), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace orris
