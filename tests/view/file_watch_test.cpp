#include "app/view/files/file_watch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "support/folder_test.h"

namespace orris {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

class FileWatchTest : public test::FolderTest {
 protected:
  void SetUp() override {
    write("shaders/final.fsh", "one");
    write("shaders/lib/sky.glsl", "two");
  }
};

TEST_F(FileWatchTest, quiet_files_tell_nothing) {
  FileWatch watch({folder_});
  EXPECT_THAT(watch.poll(), IsEmpty());
  EXPECT_THAT(watch.poll(), IsEmpty());
}

TEST_F(FileWatchTest, an_edit_is_reported_once_after_it_has_settled) {
  FileWatch watch({folder_});
  write("shaders/lib/sky.glsl", "longer");
  EXPECT_THAT(watch.poll(), IsEmpty());
  EXPECT_THAT(watch.poll(), ElementsAre(path("shaders/lib/sky.glsl")));
  EXPECT_THAT(watch.poll(), IsEmpty());
}

TEST_F(FileWatchTest, an_edit_of_equal_length_is_seen_by_its_time) {
  FileWatch watch({folder_});
  const auto later = fs::last_write_time(folder_ / "shaders/final.fsh") + std::chrono::seconds(1);
  write("shaders/final.fsh", "ONE");
  fs::last_write_time(folder_ / "shaders/final.fsh", later);
  watch.poll();
  EXPECT_THAT(watch.poll(), ElementsAre(path("shaders/final.fsh")));
}

TEST_F(FileWatchTest, edits_in_progress_are_reported_together) {
  FileWatch watch({folder_});
  write("shaders/final.fsh", "first of two");
  EXPECT_THAT(watch.poll(), IsEmpty());
  write("shaders/lib/sky.glsl", "second of two");
  EXPECT_THAT(watch.poll(), IsEmpty());
  EXPECT_THAT(watch.poll(), ElementsAre(path("shaders/final.fsh"), path("shaders/lib/sky.glsl")));
}

// An edit that replaces a file whole has such a file beside it for a moment, and long enough on a busy machine.
TEST_F(FileWatchTest, files_being_filled_to_replace_others_do_not_count) {
  FileWatch watch({folder_});
  write("shaders/lib/.orris-0123456789abcdef.partial", "three");
  write("shaders/lib/.orris-notes.txt", "four");
  watch.poll();
  EXPECT_THAT(watch.poll(), ElementsAre(path("shaders/lib/.orris-notes.txt")));
}

TEST_F(FileWatchTest, new_renamed_and_removed_files_count) {
  FileWatch watch({folder_});
  write("shaders/composite.fsh", "new");
  watch.poll();
  EXPECT_THAT(watch.poll(), ElementsAre(path("shaders/composite.fsh")));
  fs::rename(folder_ / "shaders/composite.fsh", folder_ / "shaders/final.fsh");
  watch.poll();
  EXPECT_THAT(watch.poll(), ElementsAre(path("shaders/composite.fsh"), path("shaders/final.fsh")));
}

TEST_F(FileWatchTest, a_single_file_may_come_and_go) {
  FileWatch watch({folder_ / "pack.txt"});
  EXPECT_THAT(watch.poll(), IsEmpty());
  write("pack.txt", "BLOOM=false");
  watch.poll();
  EXPECT_THAT(watch.poll(), ElementsAre(path("pack.txt")));
  fs::remove(folder_ / "pack.txt");
  watch.poll();
  EXPECT_THAT(watch.poll(), ElementsAre(path("pack.txt")));
}

TEST_F(FileWatchTest, an_edit_undone_before_it_settles_tells_nothing) {
  FileWatch watch({folder_});
  write("shaders/new.glsl", "x");
  watch.poll();
  fs::remove(folder_ / "shaders/new.glsl");
  EXPECT_THAT(watch.poll(), IsEmpty());
  EXPECT_THAT(watch.poll(), IsEmpty());
}

}  // namespace
}  // namespace orris
