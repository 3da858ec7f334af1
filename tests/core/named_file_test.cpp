#include <orris/core/files/named_file.h>

#include <gtest/gtest.h>

#include <filesystem>

#include "support/folder_test.h"

namespace orris {
namespace {

class NamedFile : public test::FolderTest {
 protected:
  Diagnostics diagnostics_;
};

TEST_F(NamedFile, whatIsWrittenIsRead) {
  EXPECT_TRUE(canWriteNamedFile(path("a"), diagnostics_));
  EXPECT_FALSE(std::filesystem::exists(path("a")));
  EXPECT_TRUE(writeNamedFile(path("a"), "text", diagnostics_));
  EXPECT_EQ(readNamedFile(path("a"), diagnostics_), "text");
  EXPECT_EQ(readNamedFileBelow(folder_.string(), "a", diagnostics_), "text");
  EXPECT_TRUE(diagnostics_.empty());
}

TEST_F(NamedFile, missingIsReportedAtItsPath) {
  EXPECT_FALSE(readNamedFile(path("none"), diagnostics_));
  ASSERT_EQ(diagnostics_.size(), 1u);
  EXPECT_EQ(diagnostics_[0].id, "file-unreadable");
  EXPECT_EQ(diagnostics_[0].at.file, path("none"));
}

TEST_F(NamedFile, noLinkLeadsOutOfTheFolder) {
  std::filesystem::create_symlink("/etc/passwd", path("link"));
  EXPECT_FALSE(readNamedFileBelow(folder_.string(), "link", diagnostics_));
  EXPECT_EQ(diagnostics_.at(0).id, "file-unreadable");
}

TEST_F(NamedFile, aFolderThatIsNotThereCannotBeWrittenTo) {
  EXPECT_FALSE(canWriteNamedFile(path("none/a"), diagnostics_));
  EXPECT_FALSE(writeNamedFile(path("none/a"), "text", diagnostics_));
  ASSERT_EQ(diagnostics_.size(), 2u);
  EXPECT_EQ(diagnostics_[1].id, "file-unwritable");
  EXPECT_FALSE(diagnostics_[1].hint.empty());
}

}  // namespace
}  // namespace orris
