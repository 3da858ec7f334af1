#include <orris/core/files/file_source.h>

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include <orris/core/files/read_places.h>
#include "support/folder_test.h"

namespace orris {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::UnorderedElementsAre;

const fs::path kData = fs::path(ORRIS_TEST_DIR) / "core" / "data";

class FileSourceTest : public test::FolderTest {
 protected:
  std::unique_ptr<FileSource> open(const std::string& path, const PackLimits& limits = {}) {
    diagnostics_.clear();
    return openPack(path, diagnostics_, limits);
  }
  std::string message() const {
    return diagnostics_.empty() ? "" : formatDiagnostic(diagnostics_.front());
  }

  Diagnostics diagnostics_;
};

TEST_F(FileSourceTest, folder_is_read_from_its_shaders_folder) {
  write("shaders/composite.fsh", "void main() {}");
  write("shaders/lib/a.glsl", "a");
  write("readme.txt", "outside");
  for (const fs::path& path : {folder_, folder_ / "shaders", folder_ / "shaders/"}) {
    const auto source = open(path.string());
    ASSERT_TRUE(source) << message();
    EXPECT_THAT(source->files(), ElementsAre("/composite.fsh", "/lib/a.glsl"));
    EXPECT_EQ(source->read("/lib/a.glsl"), "a");
    EXPECT_EQ(source->read("/../readme.txt"), std::nullopt);
    EXPECT_FALSE(source->contains("/LIB/a.glsl"));
  }
}

TEST_F(FileSourceTest, textures_of_the_pack_may_lie_beside_its_shaders_folder) {
  write("pack/shaders/composite.fsh", "void main() {}");
  write("pack/shaders/lib/a.bin", "a");
  write("pack/assets/noise.png", "noise");
  write("secret.txt", "secret");
  fs::create_symlink(folder_ / "secret.txt", folder_ / "pack/assets/link.png");
  fs::create_symlink("noise.png", folder_ / "pack/assets/inside.png");
  const auto source = open((folder_ / "pack").string());
  ASSERT_TRUE(source) << message();
  EXPECT_EQ(source->readResource("/../assets/noise.png"), "noise");
  EXPECT_EQ(source->readResource("/../assets/inside.png"), "noise");
  EXPECT_EQ(source->readResource("/lib/a.bin"), "a");
  EXPECT_EQ(source->read("/../assets/noise.png"), std::nullopt);
  EXPECT_THAT(source->files(), ElementsAre("/composite.fsh", "/lib/a.bin"));
  for (const char* outside : {"/../assets/link.png", "/../../secret.txt", "/../assets",
                              "/../assets/../../secret.txt", "/../missing.png"}) {
    EXPECT_EQ(source->readResource(outside), std::nullopt) << outside;
  }
  write("pack/long.bin", std::string(15, 'x'));
  EXPECT_EQ(open((folder_ / "pack").string(), {.fileBytes = 14})->readResource("/../long.bin"),
            std::nullopt);
  // Nobody said that what holds the folder is a pack.
  EXPECT_EQ(open((folder_ / "pack/shaders").string())->readResource("/../assets/noise.png"),
            std::nullopt);
}

TEST_F(FileSourceTest, textures_in_a_zip_may_lie_beside_its_shaders_folder) {
  for (const char* name : {"pack.zip", "nested.zip"}) {
    const auto source = open((kData / name).string());
    ASSERT_TRUE(source) << message();
    EXPECT_EQ(source->readResource("/../readme.txt").value_or("").size(), 8u) << name;
    EXPECT_EQ(source->read("/../readme.txt"), std::nullopt);
    EXPECT_EQ(source->readResource("/../shaders"), std::nullopt);
    EXPECT_EQ(source->readResource("/../../readme.txt"), std::nullopt);
  }
}

TEST_F(FileSourceTest, folder_without_shaders_is_refused) {
  EXPECT_FALSE(open(folder_.string()));
  EXPECT_EQ(message(), folder_.string() +
                           ": error: no shader pack: the folder has no folder named shaders\n"
                           "  hint: give the folder that holds shaders/");
}

TEST_F(FileSourceTest, missing_pack_is_reported_by_its_path) {
  EXPECT_FALSE(open("/no/such/pack"));
  EXPECT_EQ(message(),
            "/no/such/pack: error: no such shader pack\n  hint: give a folder or a .zip");
}

TEST_F(FileSourceTest, symbolic_links_stay_inside) {
  write("shaders/lib/a.glsl", "a");
  write("secret.txt", "secret");
  fs::create_symlink(folder_ / "secret.txt", folder_ / "shaders/out.glsl");
  fs::create_symlink("lib/a.glsl", folder_ / "shaders/in.glsl");
  const auto source = open(folder_.string());
  ASSERT_TRUE(source);
  EXPECT_THAT(source->files(), ElementsAre("/in.glsl", "/lib/a.glsl"));
  EXPECT_EQ(source->read("/in.glsl"), "a");
  EXPECT_EQ(
      message(),
      "/out.glsl: warning: this symbolic link leads nowhere, out of the pack or to what is hidden; it is ignored\n"
      "  hint: put the file itself into the pack");
}

// A checkout may itself be the root: the repository may have the name "shaders".
TEST_F(FileSourceTest, nothing_hidden_is_of_the_pack) {
  write("shaders/final.fsh", "a");
  write("shaders/.git/config", "token");
  write(".git/config", "token");
  write("assets/noise.png", "noise");
  fs::create_symlink(".git/config", folder_ / "shaders/link.glsl");
  fs::create_symlink("../.git/config", folder_ / "assets/link.png");
  const auto source = open(folder_.string());
  ASSERT_TRUE(source) << message();
  EXPECT_THAT(source->files(), ElementsAre("/final.fsh"));
  EXPECT_EQ(diagnostics_.front().at.file, "/link.glsl");
  for (const char* hidden : {"/.git/config", "/link.glsl", "/../.git/config", "/../assets/link.png"})
    EXPECT_EQ(source->readResource(hidden), std::nullopt) << hidden;
  EXPECT_EQ(source->readResource("/../assets/noise.png"), "noise");
  fs::rename(folder_ / "shaders", folder_ / "other");
  fs::create_directory_symlink(".git", folder_ / "shaders");
  EXPECT_FALSE(open(folder_.string()));
  EXPECT_EQ(diagnostics_.front().id, "pack-unreadable");
}

TEST_F(FileSourceTest, workers_may_read_the_pack_and_nothing_hidden) {
  write("pack/shaders/final.fsh", "a");
  write("pack/assets/noise.png", "noise");
  write("pack/.git/config", "token");
  write("secret/file", "secret");
  fs::create_directory_symlink("../secret", folder_ / "pack/link");
  ASSERT_TRUE(open(path("pack")));
  std::vector<std::string> allowed;
  for (const std::string& place : readPlaces()) {
    const fs::path below = fs::path(place).lexically_relative(folder_ / "pack");
    if (!below.native().starts_with("..")) allowed.push_back(below.string());
  }
  EXPECT_THAT(allowed, UnorderedElementsAre("shaders", "assets"));
}

TEST_F(FileSourceTest, endless_links_end_at_the_depth_limit) {
  write("shaders/a.glsl", "a");
  fs::create_directory_symlink(".", folder_ / "shaders/loop");
  EXPECT_FALSE(open(folder_.string()));
  EXPECT_EQ(diagnostics_.front().id, "pack-too-large");
}

TEST_F(FileSourceTest, limits_hold_for_folders_and_zips) {
  write("shaders/a.glsl", "0123456789");
  write("shaders/b.glsl", "0123456789");
  const std::string zip = (kData / "pack.zip").string();
  EXPECT_FALSE(open(folder_.string(), {.fileBytes = 9}));
  EXPECT_FALSE(open(folder_.string(), {.totalBytes = 19}));
  EXPECT_FALSE(open(folder_.string(), {.files = 1}));
  EXPECT_TRUE(open(folder_.string(), {.fileBytes = 10, .totalBytes = 20, .files = 2}));
  EXPECT_FALSE(open(zip, {.fileBytes = 3}));
  EXPECT_FALSE(open(zip, {.totalBytes = 3}));
  EXPECT_FALSE(open(zip, {.files = 2}));  // a text beside shaders counts, too
  EXPECT_THAT(message(), testing::HasSubstr("the zip has more than 2 files"));
  EXPECT_FALSE(open(zip, {.zipBytes = fs::file_size(zip) - 1}));
  EXPECT_THAT(message(), testing::HasSubstr("the zip is larger than "));
  EXPECT_TRUE(open(zip, {.zipBytes = fs::file_size(zip)}));
}

TEST_F(FileSourceTest, a_zip_that_is_written_again_leaves_the_open_one_as_it_was) {
  const fs::path zip = folder_ / "pack.zip";
  fs::copy_file(kData / "pack.zip", zip);
  const auto source = open(zip.string());
  ASSERT_TRUE(source) << message();
  std::ofstream(zip, std::ios::binary) << "PK";
  EXPECT_EQ(source->read("/lib/a.glsl"), "const float a = 1.0;\n");
  EXPECT_EQ(source->readResource("/../readme.txt").value_or("").size(), 8u);
}

TEST_F(FileSourceTest, sizes_that_a_zip_states_are_not_believed) {
  std::ifstream file(kData / "pack.zip", std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(file), {}};
  for (size_t i = 0; i + 46 < bytes.size(); ++i) {
    if (bytes.compare(i, 4, "PK\3\4") == 0) bytes.replace(i + 22, 4, std::string("\1\0\0\0", 4));
    if (bytes.compare(i, 4, "PK\1\2") == 0) bytes.replace(i + 24, 4, std::string("\1\0\0\0", 4));
  }
  write("lies.zip", bytes);
  EXPECT_FALSE(open((folder_ / "lies.zip").string(), {.totalBytes = 8}));
  EXPECT_EQ(diagnostics_.front().id, "pack-too-large");
}

TEST_F(FileSourceTest, zip_with_shaders_at_the_top) {
  const auto source = open((kData / "pack.zip").string());
  ASSERT_TRUE(source) << message();
  EXPECT_THAT(source->files(), ElementsAre("/composite.fsh", "/lib/a.glsl"));
  EXPECT_EQ(source->read("/lib/a.glsl"), "const float a = 1.0;\n");
}

TEST_F(FileSourceTest, zip_with_the_pack_in_a_folder) {
  const auto source = open((kData / "nested.zip").string());
  ASSERT_TRUE(source) << message();
  EXPECT_THAT(source->files(), ElementsAre("/composite.fsh", "/lib/a.glsl"));
}

TEST_F(FileSourceTest, links_that_double_are_not_walked_without_end) {
  write("pack/shaders/composite.fsh", "");
  for (int i = 0; i < 27; ++i) {
    const fs::path folder = folder_ / "pack/shaders" / ("f" + std::to_string(i));
    fs::create_directories(folder);
    if (i == 0) continue;
    for (const char* link : {"a", "b"})
      fs::create_symlink("../f" + std::to_string(i - 1), folder / link);
  }
  EXPECT_FALSE(open((folder_ / "pack").string()));
  ASSERT_EQ(diagnostics_.size(), 1u);
  EXPECT_EQ(diagnostics_.front().message, "the pack has more than 4096 folders, counting links");
}

TEST_F(FileSourceTest, truncated_zip_is_one_clear_message) {
  std::ifstream file(kData / "pack.zip", std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  for (const size_t size : {bytes.size() / 2, bytes.size() - 1, size_t{0}}) {
    write("cut.zip", bytes.substr(0, size));
    EXPECT_FALSE(open((folder_ / "cut.zip").string()));
    ASSERT_EQ(diagnostics_.size(), 1u);
    EXPECT_EQ(diagnostics_.front().id, "zip-unreadable");
    EXPECT_EQ(diagnostics_.front().hint,
              "the archive is damaged or cut off; fetch or zip it again");
  }
}

TEST_F(FileSourceTest, what_a_zip_cannot_be_is_named) {
  std::ifstream file(kData / "pack.zip", std::ios::binary);
  const std::string good{std::istreambuf_iterator<char>(file), {}};
  // Writes a byte of the heads of all entries, before each and in the list at the end.
  const auto refused = [&](size_t local, size_t central, char value) {
    std::string bytes = good;
    for (size_t i = 0; i + 46 < bytes.size(); ++i) {
      if (bytes.compare(i, 4, "PK\3\4") == 0) bytes[i + local] = value;
      if (bytes.compare(i, 4, "PK\1\2") == 0) bytes[i + central] = value;
    }
    write("odd.zip", bytes);
    EXPECT_FALSE(open((folder_ / "odd.zip").string()));
    return diagnostics_.front().message + ": " + diagnostics_.front().hint;
  };
  EXPECT_THAT(refused(6, 8, 1), testing::EndsWith("in the zip is encrypted: zip it without a "
                                                  "password"));
  EXPECT_THAT(refused(8, 10, 14),
              testing::EndsWith("in the zip is compressed by method 14: zip it with deflate, which "
                                "the game reads, too"));
  EXPECT_FALSE(open((kData / "pack.zip").string(), {.fileBytes = 3}));
  EXPECT_THAT(message(), testing::HasSubstr("in the zip is larger than 3 bytes"));
}

TEST_F(FileSourceTest, zip_with_damaged_bytes_is_refused) {
  std::ifstream file(kData / "pack.zip", std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(file), {}};
  bytes[60] = static_cast<char>(bytes[60] ^ 0x55);
  write("bad.zip", bytes);
  EXPECT_FALSE(open((folder_ / "bad.zip").string()));
  EXPECT_EQ(diagnostics_.front().id, "zip-unreadable");
}

TEST(MemorySource, leaves_out_paths_that_escape) {
  const auto source = memorySource({{"/a", "1"}, {"../b", "2"}, {"/lib/../c", "3"}});
  EXPECT_THAT(source->files(), ElementsAre("/a", "/c"));
}

}  // namespace
}  // namespace orris
