#include "core/replace_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

namespace orris {
namespace {

namespace fs = std::filesystem;

class ReplaceFile : public testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    std::ofstream(path_) << "old";
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::string text() const {
    std::ifstream file(path_);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  std::ptrdiff_t files() const {
    return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
  }
  // Each test has its own: they run side by side.
  const fs::path folder_ =
      fs::path(testing::TempDir()) /
      ("orris-replace-file-" +
       std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
  const std::string path_ = folder_ / "a.txt";
};

TEST_F(ReplaceFile, the_old_file_stays_until_the_new_one_is_whole) {
  const auto write = [&](const std::string& partial) {
    std::ofstream(partial) << "new";
    EXPECT_EQ(text(), "old");
    return true;
  };
  EXPECT_FALSE(replaceFile(path_, write));
  EXPECT_EQ(text(), "new");
  EXPECT_EQ(files(), 1);
}

TEST_F(ReplaceFile, nothing_is_left_of_what_could_not_be_written) {
  const auto write = [](const std::string& partial) {
    std::ofstream(partial) << "half";
    return false;
  };
  EXPECT_EQ(replaceFile(path_, write), std::errc::io_error);
  EXPECT_EQ(text(), "old");
  EXPECT_EQ(files(), 1);
}

TEST_F(ReplaceFile, a_folder_is_not_replaced) {
  const auto write = [](const std::string& partial) {
    return bool(std::ofstream(partial) << "new");
  };
  EXPECT_TRUE(replaceFile(folder_, write));
  EXPECT_TRUE(fs::is_directory(folder_));
  EXPECT_FALSE(fs::exists(folder_.string() + ".partial"));
}

}  // namespace
}  // namespace orris
