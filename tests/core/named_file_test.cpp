#include "core/named_file.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace orris {
namespace {

class NamedFile : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (std::filesystem::temp_directory_path() / "orris-named-XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string folder_;
  Diagnostics diagnostics_;
};

TEST_F(NamedFile, whatIsWrittenIsRead) {
  EXPECT_TRUE(canWriteNamedFile(folder_ + "/a", diagnostics_));
  EXPECT_FALSE(std::filesystem::exists(folder_ + "/a"));
  EXPECT_TRUE(writeNamedFile(folder_ + "/a", "text", diagnostics_));
  EXPECT_EQ(readNamedFile(folder_ + "/a", diagnostics_), "text");
  EXPECT_EQ(readNamedFileBelow(folder_, "a", diagnostics_), "text");
  EXPECT_TRUE(diagnostics_.empty());
}

TEST_F(NamedFile, missingIsReportedAtItsPath) {
  EXPECT_FALSE(readNamedFile(folder_ + "/none", diagnostics_));
  ASSERT_EQ(diagnostics_.size(), 1u);
  EXPECT_EQ(diagnostics_[0].id, "file-unreadable");
  EXPECT_EQ(diagnostics_[0].at.file, folder_ + "/none");
}

TEST_F(NamedFile, noLinkLeadsOutOfTheFolder) {
  std::filesystem::create_symlink("/etc/passwd", folder_ + "/link");
  EXPECT_FALSE(readNamedFileBelow(folder_, "link", diagnostics_));
  EXPECT_EQ(diagnostics_.at(0).id, "file-unreadable");
}

TEST_F(NamedFile, aFolderThatIsNotThereCannotBeWrittenTo) {
  EXPECT_FALSE(canWriteNamedFile(folder_ + "/none/a", diagnostics_));
  EXPECT_FALSE(writeNamedFile(folder_ + "/none/a", "text", diagnostics_));
  ASSERT_EQ(diagnostics_.size(), 2u);
  EXPECT_EQ(diagnostics_[1].id, "file-unwritable");
  EXPECT_FALSE(diagnostics_[1].hint.empty());
}

}  // namespace
}  // namespace orris
