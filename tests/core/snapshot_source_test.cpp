#include <orris/core/files/snapshot_source.h>

#include <gmock/gmock.h>

#include <orris/core/limits.h>

#include "support/folder_test.h"

namespace orris {
namespace {

/// Counts how often a file is read.
class CountingSource : public FileSource {
 public:
  explicit CountingSource(std::map<std::string, std::string> files) : files_(memorySource(std::move(files))) {}
  std::optional<std::string> read(std::string_view path) const override {
    ++reads;
    return files_->read(path);
  }
  const std::vector<std::string>& files() const override { return files_->files(); }

  mutable int reads = 0;

 private:
  std::unique_ptr<FileSource> files_;
};

class SnapshotSourceTest : public test::FolderTest {};

TEST_F(SnapshotSourceTest, keeps_what_a_file_held_when_it_was_first_read) {
  write("shaders/a.glsl", "old");
  write("shaders/b.glsl", "old");
  write("image.png", "old");
  Diagnostics diagnostics;
  const auto source = snapshotOf(openPack(folder_.string(), diagnostics));
  EXPECT_EQ(source->read("/a.glsl"), "old");
  EXPECT_EQ(source->readResource("/../image.png"), "old");
  for (const char* file : {"shaders/a.glsl", "shaders/b.glsl", "image.png"}) write(file, "new");
  EXPECT_EQ(source->read("/a.glsl"), "old");
  EXPECT_EQ(source->readResource("/a.glsl"), "old");
  EXPECT_EQ(source->read("/b.glsl"), "new") << "not read before";
  EXPECT_EQ(source->readResource("/../image.png"), "new") << "beside shaders";
  EXPECT_EQ(source->read("/none.glsl"), std::nullopt);
  EXPECT_THAT(source->files(), testing::ElementsAre("/a.glsl", "/b.glsl"));
}

TEST_F(SnapshotSourceTest, reads_a_file_once_until_it_holds_too_much) {
  const std::string most(limits::kSnapshotBytes - 1, 'a');
  const auto counted = std::make_shared<CountingSource>(
      std::map<std::string, std::string>{{"/a", most}, {"/b", "bc"}, {"/c", "c"}});
  const auto source = snapshotOf(counted);
  EXPECT_EQ(source->read("/a"), most);
  EXPECT_EQ(source->read("/a"), most);
  EXPECT_EQ(counted->reads, 1);
  EXPECT_EQ(source->read("/b"), "bc");
  EXPECT_EQ(source->read("/b"), "bc");
  EXPECT_EQ(counted->reads, 3) << "does not fit";
  EXPECT_EQ(source->read("/c"), "c");
  EXPECT_EQ(source->read("/c"), "c");
  EXPECT_EQ(counted->reads, 4) << "fits";
}

}  // namespace
}  // namespace orris
