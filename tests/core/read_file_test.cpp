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

TEST_F(ReadFile, nothing_hidden_is_read) {
  write("in/.git/config", "token");
  fs::create_symlink(".git/config", folder_ / "in/link");
  fs::create_directory_symlink(".git", folder_ / "in/folder");
  for (const char* name : {".git/config", "side/../.git/config", "link", "folder/config"})
    EXPECT_EQ(below(name), describe(ReadFault::Hidden)) << name;
  EXPECT_EQ(readFileBelow((folder_ / "in/.git").string(), "config", 9, fault_), "token");
}

TEST_F(ReadFile, what_is_quoted_is_not_read_through_a_link_out_of_its_folder) {
  write("in/.hidden", "token");
  fs::create_symlink("../out.txt", folder_ / "in/outside");
  fs::create_symlink(".hidden", folder_ / "in/secret");
  fs::create_symlink("a.txt", folder_ / "in/inside");
  const auto quoted = [&](const char* name) {
    return readQuotedFile(path(std::string("in/") + name), 9, fault_).value_or(describe(fault_));
  };
  EXPECT_EQ(quoted("outside"), describe(ReadFault::Outside));
  EXPECT_EQ(quoted("secret"), describe(ReadFault::Hidden));
  EXPECT_EQ(quoted("inside"), "abc");
  EXPECT_EQ(quoted(".hidden"), "token");  // a person named it
  EXPECT_EQ(quoted("none"), describe(ReadFault::Missing));
  EXPECT_EQ(readQuotedFile("/dev/null", 9, fault_), "");
}

TEST_F(ReadFile, the_folder_itself_may_be_a_link) {
  fs::create_directory_symlink("in", folder_ / "link");
  EXPECT_EQ(readFileBelow((folder_ / "link").string(), "a.txt", 9, fault_), "abc");
}

TEST_F(ReadFile, a_folder_beside_it_whose_name_begins_alike_is_outside) {
  fs::create_directory(folder_ / "inner");
  EXPECT_FALSE(liesBelow((folder_ / "in").string(), (folder_ / "inner").string()));
  EXPECT_TRUE(liesBelow((folder_ / "in").string(), (folder_ / "in/side").string()));
  EXPECT_TRUE(liesBelow("/", (folder_ / "in").string()));
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
