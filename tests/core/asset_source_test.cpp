#include <orris/core/files/asset_source.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zip.h>

#include <filesystem>

#include "support/folder_test.h"

namespace orris {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

class AssetSource : public test::FolderTest {
 protected:
  std::string zip(const std::map<std::string, std::string>& files) {
    const std::string path = (folder_ / "pack.zip").string();
    zip_t* archive = zip_open(path.c_str(), ZIP_CREATE | ZIP_TRUNCATE, nullptr);
    for (const auto& [name, text] : files)
      zip_file_add(archive, name.c_str(), zip_source_buffer(archive, text.data(), text.size(), 0),
                   ZIP_FL_OVERWRITE);
    zip_close(archive);
    return path;
  }

};

TEST_F(AssetSource, a_folder_holds_assets_or_is_named_so) {
  write("pack/assets/minecraft/a.json", "1");
  write("pack/other.txt", "2");
  Diagnostics diagnostics;
  for (const char* name : {"pack", "pack/assets", "pack/"}) {
    const auto source = openAssets((folder_ / name).string(), diagnostics);
    ASSERT_TRUE(source) << name;
    EXPECT_THAT(source->files(), ElementsAre("/minecraft/a.json"));
    EXPECT_EQ(source->read("/minecraft/a.json"), "1");
    EXPECT_FALSE(source->read("/../other.txt"));
  }
}

TEST_F(AssetSource, a_zip_is_read_where_its_assets_are) {
  Diagnostics diagnostics;
  const auto source = openAssets(zip({{"Pack-main/assets/minecraft/a.json", "1"},
                                      {"Pack-main/pack.mcmeta", "{}"},
                                      {"Pack-main/assets/../../b", "2"},
                                      {"../assets/c", "3"}}),
                                 diagnostics);
  ASSERT_TRUE(source);
  EXPECT_THAT(source->files(), ElementsAre("/minecraft/a.json"));
  EXPECT_EQ(source->read("/minecraft/a.json"), "1");
}

TEST_F(AssetSource, what_holds_no_assets_is_refused) {
  Diagnostics diagnostics;
  EXPECT_FALSE(openAssets((folder_ / "none").string(), diagnostics));
  EXPECT_FALSE(openAssets(folder_.string(), diagnostics));
  EXPECT_FALSE(openAssets(zip({{"shaders/a", "1"}}), diagnostics));
  EXPECT_FALSE(openAssets(write("cut.zip", "PK\3\4 and no more"), diagnostics));
  ASSERT_EQ(diagnostics.size(), 4u);
  EXPECT_EQ(diagnostics[0].message, "no such folder or file");
  EXPECT_THAT(diagnostics[1].message, HasSubstr("the folder has no folder named assets"));
  EXPECT_THAT(diagnostics[2].message, HasSubstr("the zip has no folder named assets"));
  EXPECT_EQ(diagnostics[3].id, "zip-unreadable");
}

TEST_F(AssetSource, a_link_out_of_the_pack_is_not_followed) {
  const std::string secret = write("secret/minecraft/a.json", "x");
  fs::create_directories(folder_ / "pack");
  fs::create_symlink(folder_ / "secret", folder_ / "pack/assets");
  Diagnostics diagnostics;
  EXPECT_FALSE(openAssets((folder_ / "pack").string(), diagnostics));
}

}  // namespace
}  // namespace orris
