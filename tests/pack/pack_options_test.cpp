#include <orris/pack/options/pack_options.h>

#include <gtest/gtest.h>

namespace orris {
namespace {

std::optional<LoadRequest> requested(const PackOptions& options, Diagnostics& diagnostics) {
  const std::shared_ptr<const FileSource> files = memorySource(
      {{"/final.fsh", "#version 120\nvoid main() {}\n"}, {"/world7/final.fsh", ""}});
  return makeLoadRequest(files, options, {}, diagnostics);
}

TEST(PackOptions, becomeARequest) {
  Diagnostics diagnostics;
  const auto request =
      requested({.profile = "LOW", .values = {{"A", "1"}}, .dimension = "world7"}, diagnostics);
  ASSERT_TRUE(request);
  EXPECT_EQ(request->profile, "LOW");
  EXPECT_EQ(request->values.at("A"), "1");
  EXPECT_EQ(request->dimension, "world7");
}

TEST(PackOptions, aDimensionIsOneOfTheGameAModOrThePack) {
  Diagnostics diagnostics;
  for (const char* name : {"", "the_nether", "world-1", "minecraft:the_end", "mod:moon", "world7"})
    EXPECT_TRUE(requested({.dimension = name}, diagnostics)) << name;
  EXPECT_TRUE(diagnostics.empty());
  EXPECT_FALSE(requested({.dimension = "the_neter"}, diagnostics));
  ASSERT_EQ(diagnostics.size(), 1u);
  EXPECT_EQ(diagnostics[0].id, "dimension-unknown");
  EXPECT_NE(diagnostics[0].hint.find("the_nether"), std::string::npos) << diagnostics[0].hint;
}

TEST(PackOptions, aSettingsFileThatIsMissingIsReported) {
  Diagnostics diagnostics;
  EXPECT_FALSE(requested({.settingsFile = "/nowhere/options.txt"}, diagnostics));
  EXPECT_EQ(diagnostics.at(0).id, "file-unreadable");
}

TEST(PackOptions, shortNamesOfDimensionsHaveAFullOne) {
  EXPECT_EQ(fullDimensionName("world-1"), "minecraft:the_nether");
  EXPECT_EQ(fullDimensionName("overworld"), "minecraft:overworld");
  EXPECT_EQ(fullDimensionName("world7"), "world7");
}

}  // namespace
}  // namespace orris
