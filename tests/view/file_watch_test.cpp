#include "app/view/file_watch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

namespace orris {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

class FileWatchTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    root_ = fs::path(testing::TempDir()) /
            ("orris_watch_" + std::to_string(getpid()) + "_" + test->name());
    fs::create_directories(root_ / "shaders" / "lib");
    write("shaders/final.fsh", "one");
    write("shaders/lib/sky.glsl", "two");
  }
  void TearDown() override { fs::remove_all(root_); }

  void write(const std::string& name, const std::string& text) {
    std::ofstream(root_ / name) << text;
  }
  std::string path(const std::string& name) const { return (root_ / name).string(); }

  fs::path root_;
};

TEST_F(FileWatchTest, quiet_files_tell_nothing) {
  FileWatch watch({root_});
  EXPECT_THAT(watch.poll(), IsEmpty());
  EXPECT_THAT(watch.poll(), IsEmpty());
}

TEST_F(FileWatchTest, an_edit_is_reported_once_after_it_has_settled) {
  FileWatch watch({root_});
  write("shaders/lib/sky.glsl", "longer");
  EXPECT_THAT(watch.poll(), IsEmpty());
  EXPECT_THAT(watch.poll(), ElementsAre(path("shaders/lib/sky.glsl")));
  EXPECT_THAT(watch.poll(), IsEmpty());
}

TEST_F(FileWatchTest, an_edit_of_equal_length_is_seen_by_its_time) {
  FileWatch watch({root_});
  const auto later = fs::last_write_time(root_ / "shaders/final.fsh") + std::chrono::seconds(1);
  write("shaders/final.fsh", "ONE");
  fs::last_write_time(root_ / "shaders/final.fsh", later);
  watch.poll();
  EXPECT_THAT(watch.poll(), ElementsAre(path("shaders/final.fsh")));
}

TEST_F(FileWatchTest, edits_in_progress_are_reported_together) {
  FileWatch watch({root_});
  write("shaders/final.fsh", "first of two");
  EXPECT_THAT(watch.poll(), IsEmpty());
  write("shaders/lib/sky.glsl", "second of two");
  EXPECT_THAT(watch.poll(), IsEmpty());
  EXPECT_THAT(watch.poll(), ElementsAre(path("shaders/final.fsh"), path("shaders/lib/sky.glsl")));
}

TEST_F(FileWatchTest, new_renamed_and_removed_files_count) {
  FileWatch watch({root_});
  write("shaders/composite.fsh", "new");
  watch.poll();
  EXPECT_THAT(watch.poll(), ElementsAre(path("shaders/composite.fsh")));
  fs::rename(root_ / "shaders/composite.fsh", root_ / "shaders/final.fsh");
  watch.poll();
  EXPECT_THAT(watch.poll(), ElementsAre(path("shaders/composite.fsh"), path("shaders/final.fsh")));
}

TEST_F(FileWatchTest, a_single_file_may_come_and_go) {
  FileWatch watch({root_ / "pack.txt"});
  EXPECT_THAT(watch.poll(), IsEmpty());
  write("pack.txt", "BLOOM=false");
  watch.poll();
  EXPECT_THAT(watch.poll(), ElementsAre(path("pack.txt")));
  fs::remove(root_ / "pack.txt");
  watch.poll();
  EXPECT_THAT(watch.poll(), ElementsAre(path("pack.txt")));
}

TEST_F(FileWatchTest, an_edit_undone_before_it_settles_tells_nothing) {
  FileWatch watch({root_});
  write("shaders/new.glsl", "x");
  watch.poll();
  fs::remove(root_ / "shaders/new.glsl");
  EXPECT_THAT(watch.poll(), IsEmpty());
  EXPECT_THAT(watch.poll(), IsEmpty());
}

}  // namespace
}  // namespace orris
