#include <orris/core/files/read_file.h>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>

#include "support/folder_test.h"

namespace orris {
namespace {

namespace fs = std::filesystem;

class ReadFile : public test::FolderTest {
 protected:
  void SetUp() override {
    fs::create_directories(folder_ / "in/side");
    write("out.txt", "out");
    write("in/a.txt", "abc");
  }

  std::string below(const std::string& name, std::size_t limit = 100) {
    const auto text = readFileBelow((folder_ / "in").string(), name, limit, fault_);
    return text.value_or(describe(fault_));
  }

  ReadFault fault_{};
};

TEST_F(ReadFile, a_file_is_read_up_to_its_limit) {
  EXPECT_EQ(below("a.txt", 3), "abc");
  EXPECT_EQ(below("a.txt", 2), describe(ReadFault::TooLarge));
  EXPECT_EQ(below("b.txt"), describe(ReadFault::Missing));
  EXPECT_EQ(below("a.txt/b"), describe(ReadFault::Missing));
}

TEST_F(ReadFile, a_link_is_followed_inside_its_folder_only) {
  fs::create_symlink("../a.txt", folder_ / "in/side/inside");
  fs::create_symlink("../out.txt", folder_ / "in/outside");
  fs::create_symlink("..", folder_ / "in/up");
  fs::create_symlink("nowhere", folder_ / "in/dangling");
  fs::create_symlink("/proc/self/environ", folder_ / "in/environment");
  EXPECT_EQ(below("side/inside"), "abc");
  for (const char* name : {"outside", "up/out.txt", "../out.txt", "dangling", "environment"})
    EXPECT_EQ(below(name), describe(ReadFault::Outside)) << name;
}

TEST_F(ReadFile, the_folder_itself_may_be_a_link) {
  fs::create_directory_symlink("in", folder_ / "link");
  EXPECT_EQ(readFileBelow((folder_ / "link").string(), "a.txt", 9, fault_), "abc");
}

TEST_F(ReadFile, a_folder_beside_it_whose_name_begins_alike_is_outside) {
  fs::create_directory(folder_ / "inner");
  EXPECT_FALSE(liesBelow((folder_ / "in").string(), (folder_ / "inner").string()));
  EXPECT_TRUE(liesBelow((folder_ / "in").string(), (folder_ / "in/side").string()));
}

TEST_F(ReadFile, what_is_no_file_is_neither_read_nor_waited_for) {
  ASSERT_EQ(mkfifo((folder_ / "in/pipe").c_str(), 0600), 0);
  EXPECT_EQ(below("pipe"), describe(ReadFault::NoFile));
  EXPECT_EQ(below("side"), describe(ReadFault::NoFile));
  EXPECT_EQ(readFile((folder_ / "in/pipe").string(), 9, fault_), std::nullopt);
  EXPECT_EQ(fault_, ReadFault::NoFile);
}

TEST_F(ReadFile, a_device_that_the_user_names_ends_at_the_limit) {
  EXPECT_EQ(readFile("/dev/null", 9, fault_), "");
  EXPECT_EQ(readFile("/dev/zero", 100000, fault_), std::nullopt);
  EXPECT_EQ(fault_, ReadFault::TooLarge);
}

}  // namespace
}  // namespace orris
