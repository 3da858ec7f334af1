#include <orris/core/files/replace_file.h>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "support/folder_test.h"

namespace orris {
namespace {

namespace fs = std::filesystem;

class ReplaceFile : public test::FolderTest {
 protected:
  void SetUp() override {
    write("a.txt", "old");
  }
  std::string text() const {
    std::ifstream file(path_);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  std::ptrdiff_t files() const {
    return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
  }
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

TEST_F(ReplaceFile, a_link_is_not_written_through) {
  const fs::path link = folder_ / "link";
  for (const char* target : {"a.txt", "nowhere", "/dev/null"}) {
    fs::create_symlink(target, link);
    EXPECT_EQ(replaceFile(link.string(), "new"), std::errc::not_supported);
    EXPECT_TRUE(fs::is_symlink(link));
    fs::remove(link);
  }
  EXPECT_EQ(text(), "old");
  EXPECT_EQ(files(), 1);
}

TEST_F(ReplaceFile, what_is_no_file_is_not_replaced) {
  const std::string pipe = (folder_ / "pipe").string();
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(replaceFile(pipe, "new"), std::errc::not_supported);
  EXPECT_EQ(outputProblem(pipe), "is a device or pipe, not a file");
  EXPECT_TRUE(fs::is_fifo(pipe));
}

TEST_F(ReplaceFile, the_name_of_the_file_beside_it_cannot_be_foreseen) {
  std::set<std::string> names;
  const auto write = [&](const std::string& partial) {
    names.insert(partial);
    EXPECT_EQ(fs::file_size(partial), 0U);
    EXPECT_EQ(fs::path(partial).parent_path(), folder_);
    return true;
  };
  for (int i = 0; i < 3; ++i) EXPECT_FALSE(replaceFile(path_, write));
  EXPECT_EQ(names.size(), 3U);
}

TEST_F(ReplaceFile, an_output_needs_a_folder_that_may_be_written) {
  EXPECT_EQ(outputProblem(path_), "");
  EXPECT_EQ(outputProblem((folder_ / "new").string()), "");
  EXPECT_EQ(outputProblem("new"), "");
  EXPECT_EQ(outputProblem(folder_.string()), "is a folder");
  EXPECT_EQ(outputProblem((folder_ / "none/new").string()),
            "cannot be written: there is no such folder");
  EXPECT_EQ(files(), 1);
}

}  // namespace
}  // namespace orris
