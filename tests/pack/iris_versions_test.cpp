#include <orris/pack/versions/iris_versions.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>

#include <orris/pack/shader_pack.h>
#include <orris/pack/versions/features.h>

namespace orris {
namespace {

std::string chosen(const std::string& iris, const std::string& game,
                   SeriesEnd end = SeriesEnd::Last) {
  std::string error;
  const auto versions = chooseVersions(iris, game, end, error);
  return versions ? versionText(versions->iris) + " on " + versionText(versions->game) : error;
}

std::string macroOf(const MacroDefinitions& macros, const std::string& name) {
  const auto found = std::find_if(macros.begin(), macros.end(),
                                  [&](const auto& macro) { return macro.first == name; });
  return found == macros.end() ? "none" : found->second;
}

MacroDefinitions macrosOf(const Version& iris, const Version& game) {
  return standardMacros({.versions = {iris, game}});
}

TEST(IrisVersions, are_read_and_written) {
  EXPECT_EQ(parseVersion("1.10.5"), (Version{1, 10, 5}));
  EXPECT_EQ(parseVersion("26.1"), (Version{26, 1, 0}));
  for (const char* text : {"", "1", "1.", "1.2.3.4", "1.x", "1.100", "v1.8", "1.8.0-beta", "-1.2"})
    EXPECT_FALSE(parseVersion(text)) << text;
  EXPECT_EQ(versionText({1, 21, 11}), "1.21.11");
  EXPECT_EQ(versionText({26, 1, 0}), "26.1");
  EXPECT_LT((Version{1, 9, 7}), (Version{1, 10, 0}));
}

TEST(IrisVersions, numbers_have_two_digits_for_minor_and_patch) {
  EXPECT_EQ(versionNumber({1, 8, 0}), 10800);
  EXPECT_EQ(versionNumber({1, 10, 5}), 11005);
  EXPECT_EQ(versionNumber({1, 21, 11}), 12111);
  EXPECT_EQ(versionNumber({26, 1, 0}), 260100);
  EXPECT_EQ(versionNumber({26, 1, 2}), 260102);
}

TEST(IrisVersions, what_is_not_given_follows_what_is) {
  EXPECT_EQ(chosen("", ""), "1.11.2 on 26.2");
  EXPECT_EQ(chosen("1.11.2", "26.1"), "1.11.2 on 26.1");
  EXPECT_EQ(chosen("", "1.20.1"), "1.7.6 on 1.20.1");
  EXPECT_EQ(chosen("", "1.16.5"), "1.6.17 on 1.16.5");
  EXPECT_EQ(chosen("", "26.1.2"), "1.11.2 on 26.1.2");
  EXPECT_EQ(chosen("1.8", ""), "1.8.12 on 1.21.5");
  EXPECT_EQ(chosen("1.8", "", SeriesEnd::First), "1.8 on 1.21");
  EXPECT_EQ(chosen("1.8.3", "", SeriesEnd::First), "1.8.3 on 1.21");
}

TEST(IrisVersions, pairs_that_never_were_are_refused) {
  EXPECT_EQ(chosen("1.11.2", "1.20.1"), "Iris 1.11.2 is for Minecraft 26.1 to 26.2, not 1.20.1");
  EXPECT_EQ(chosen("2.0", ""), "Iris 2.0 is unknown; known are 1.6 to 1.11.2");
  EXPECT_EQ(chosen("", "1.12.2"),
            "no Iris is known for Minecraft 1.12.2; known are 1.16.5 to 26.2");
  EXPECT_EQ(chosen("new", ""), "\"new\" is no version of Iris, which look like 1.10.5");
  EXPECT_EQ(chosen("", "26"), "\"26\" is no version of Minecraft, which look like 1.21.11 or 26.1");
}

TEST(IrisVersions, macros_state_the_pair) {
  const MacroDefinitions newest = standardMacros({});
  EXPECT_EQ(macroOf(newest, "IRIS_VERSION"), "11102");
  EXPECT_EQ(macroOf(newest, "MC_VERSION"), "260200");
  EXPECT_EQ(macroOf(newest, "MAX_COLOR_BUFFERS"), "32");
  EXPECT_EQ(macroOf(newest, "IRIS_REQUIRES_SEPARATE_ENTITY_DRAWS"), "");
  const MacroDefinitions old = macrosOf({1, 8, 0}, {1, 21, 1});
  EXPECT_EQ(macroOf(old, "IRIS_VERSION"), "10800");
  EXPECT_EQ(macroOf(old, "MC_VERSION"), "12101");
  EXPECT_EQ(macroOf(old, "MC_MIPMAP_LEVEL"), "none");
  EXPECT_EQ(macroOf(old, "MAX_COLOR_BUFFERS"), "none");
  EXPECT_EQ(macroOf(old, "IRIS_REQUIRES_SEPARATE_ENTITY_DRAWS"), "none");
  EXPECT_EQ(macroOf(macrosOf({1, 7, 3}, {1, 20, 6}), "IRIS_VERSION"), "none");
  EXPECT_NE(macroOf(newest, "BIOME_PALE_GARDEN"), "none");
  EXPECT_EQ(macroOf(old, "BIOME_PALE_GARDEN"), "none");
  EXPECT_NE(macroOf(old, "BIOME_CHERRY_GROVE"), "none");
}

TEST(IrisVersions, are_read_back_from_the_macros) {
  for (const Version iris : {Version{1, 7, 4}, Version{1, 10, 5}, Version{1, 11, 2}})
    EXPECT_EQ(irisVersionOf(macrosOf(iris, {1, 21, 0})), iris);
  EXPECT_EQ(gameVersionOf(macrosOf({1, 11, 0}, {26, 1, 0})), (Version{26, 1, 0}));
  EXPECT_EQ(irisVersionOf(macrosOf({1, 7, 0}, {1, 20, 1})), (Version{1, 7, 3}));
  EXPECT_EQ(irisVersionOf(macrosOf({1, 6, 4}, {1, 20, 1})), (Version{1, 6, 17}));
  EXPECT_FALSE(irisVersionOf(standardMacros({.iris = false})));
}

TEST(IrisVersions, an_older_iris_has_less) {
  EXPECT_EQ(colorBuffersOf({1, 10, 4}), 16);
  EXPECT_EQ(colorBuffersOf({1, 10, 5}), 32);
  EXPECT_EQ(bufferObjectsOf({1, 10, 4}), 9);
  EXPECT_EQ(bufferObjectsOf({1, 10, 5}), 13);
  EXPECT_THAT(supportedFeatures(), testing::Contains("FADE_VARIABLE"));
  EXPECT_THAT(supportedFeatures({1, 10, 2}), testing::Not(testing::Contains("FADE_VARIABLE")));
  EXPECT_TRUE(offers({1, 9, 5}, Offer::Uniform, "seaLevel"));
  EXPECT_FALSE(offers({1, 9, 4}, Offer::Uniform, "seaLevel"));
  EXPECT_TRUE(offers({1, 6, 0}, Offer::Uniform, "cameraPosition"));
}

TEST(IrisVersions, no_row_is_there_twice) {
  for (const OfferRow& row : offerTable()) EXPECT_EQ(findOffer(row.kind, row.name), &row);
}

std::string rowOf(const OfferRow& row) {
  constexpr const char* kKinds[] = {"macro", "feature flag", "uniform",        "attribute",
                                    "key",   "pixel type",   "internal format"};
  const bool anyGame = row.game == Version{};
  return std::string("| ") + kKinds[static_cast<int>(row.kind)] + " | `" + std::string(row.name) +
         "` | " + versionText(row.iris) + " | " + (anyGame ? "" : versionText(row.game)) + " |";
}

TEST(IrisVersions, the_page_has_the_rows_of_the_tables) {
  std::ifstream file(ORRIS_SOURCE_DIR "/docs/versions.md");
  std::vector<std::string> offersOnPage, seriesOnPage;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("| 1.")) seriesOnPage.push_back(line);
    if (line.starts_with("| ") && line.find("| `") != std::string::npos)
      offersOnPage.push_back(line);
  }
  std::vector<std::string> rows, series;
  for (const OfferRow& row : offerTable()) rows.push_back(rowOf(row));
  for (const IrisSeries& s : irisSeries()) {
    series.push_back("| " + versionText(s.first) + " to " + versionText(s.last) + " | " +
                     versionText(s.firstGame) + " to " + versionText(s.lastGame) + " |");
  }
  EXPECT_EQ(offersOnPage, rows);
  EXPECT_EQ(seriesOnPage, series);
}

}  // namespace
}  // namespace orris
