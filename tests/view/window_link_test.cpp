#include "app/view/apart/window_link.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace orris {
namespace {

bool isOpen(int file) { return fcntl(file, F_GETFD) >= 0; }

// The number of an end that is closed is the next file's, which the link must leave alone.
TEST(WindowLinkTest, an_end_is_closed_once) {
  int other = -1;
  {
    WindowLink link;
    ASSERT_TRUE(link.usable());
    const int end = link.windowEnd();
    link.closeWindowEnd();
    EXPECT_FALSE(isOpen(end));
    other = open("/dev/null", O_RDONLY | O_CLOEXEC);
    ASSERT_EQ(other, end);
    link.closeWindowEnd();
  }
  EXPECT_TRUE(isOpen(other));
  close(other);
}

TEST(WindowLinkTest, both_ends_end_with_it) {
  int window = -1, drawing = -1;
  {
    const WindowLink link;
    window = link.windowEnd(), drawing = link.drawingEnd();
    EXPECT_TRUE(isOpen(window) && isOpen(drawing));
  }
  EXPECT_FALSE(isOpen(window) || isOpen(drawing));
}

}  // namespace
}  // namespace orris
