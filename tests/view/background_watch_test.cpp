#include "app/view/files/background_watch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>

namespace orris {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;

class BackgroundWatchTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    root_ = fs::path(testing::TempDir()) /
            ("orris_background_" + std::to_string(getpid()) + "_" + test->name());
    fs::create_directories(root_ / "shaders" / "lib");
    write("shaders/lib/sky.glsl", "one");
  }
  void TearDown() override { fs::remove_all(root_); }

  void write(const std::string& name, const std::string& text) { std::ofstream(root_ / name) << text; }
  std::string path(const std::string& name) const { return (root_ / name).string(); }

  /// The first change that comes within 5 s; `seconds`: after how many.
  static std::vector<std::string> next(BackgroundWatch& watch, double* seconds = nullptr) {
    const auto began = std::chrono::steady_clock::now();
    const auto passed = [&] {
      return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    };
    std::vector<std::string> changed;
    while (changed.empty() && passed() < 5) {
      usleep(2000);
      changed = watch.take();
    }
    if (seconds != nullptr) *seconds = passed();
    return changed;
  }

  fs::path root_;
};

TEST_F(BackgroundWatchTest, an_edit_comes_soon_and_once) {
  BackgroundWatch watch({root_ / "shaders"}, BackgroundWatch::openEvents());
  double soonest = 5;
  for (const char* text : {"longer", "longer still", "the longest"}) {  // a busy machine delays some
    usleep(50'000);
    write("shaders/lib/sky.glsl", text);
    double seconds = 0;
    EXPECT_THAT(next(watch, &seconds), ElementsAre(path("shaders/lib/sky.glsl")));
    soonest = std::min(soonest, seconds);
    usleep(200'000);
    EXPECT_THAT(watch.take(), IsEmpty());
  }
  EXPECT_LT(soonest, 0.5);  // without events a quiet watch looks once a second
}

TEST_F(BackgroundWatchTest, files_in_new_folders_and_a_folder_that_comes_back_are_seen) {
  BackgroundWatch watch({root_ / "shaders"}, BackgroundWatch::openEvents());
  fs::create_directories(root_ / "shaders" / "new" / "deep");
  write("shaders/new/deep/a.glsl", "a");
  EXPECT_THAT(next(watch), ElementsAre(path("shaders/new/deep/a.glsl")));
  fs::rename(root_ / "shaders", root_ / "gone");
  EXPECT_THAT(next(watch), Contains(path("shaders/lib/sky.glsl")));
  fs::rename(root_ / "gone", root_ / "shaders");
  EXPECT_THAT(next(watch), Contains(path("shaders/lib/sky.glsl")));
}

TEST_F(BackgroundWatchTest, who_may_read_a_file_is_news) {
  BackgroundWatch watch({root_ / "shaders"}, BackgroundWatch::openEvents());
  ASSERT_EQ(chmod(path("shaders/lib/sky.glsl").c_str(), 0), 0);
  EXPECT_THAT(next(watch), ElementsAre(path("shaders/lib/sky.glsl")));
}

TEST_F(BackgroundWatchTest, what_is_accepted_is_no_news) {
  write("options.txt", "A=1\n");
  BackgroundWatch watch({path("options.txt")}, BackgroundWatch::openEvents());
  write("options.txt", "A=22\n");
  watch.accept(path("options.txt"));
  usleep(300'000);
  EXPECT_THAT(watch.take(), IsEmpty());
  write("options.txt", "A=333\n");
  EXPECT_THAT(next(watch), ElementsAre(path("options.txt")));
}

}  // namespace
}  // namespace orris
