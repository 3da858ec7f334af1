#include <orris/chart/gallery/gallery_set.h>

#include <gmock/gmock.h>

namespace orris {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

const std::vector<std::string> kKnown = {"LOW", "HIGH"};

std::optional<GallerySet> parsedSet(const std::string& text, Diagnostics& found,
                                    const std::vector<std::string>& profiles = {}) {
  return parseGallerySet({text, "g.json"}, profiles, kKnown, found);
}

std::vector<std::string> shotNames(const GallerySet& set) {
  std::vector<std::string> names;
  for (const GalleryShot& shot : set.shots) names.push_back(shot.name);
  return names;
}

/// The only message, with its place.
std::string mistakeOf(const std::string& text) {
  Diagnostics found;
  EXPECT_FALSE(parsedSet(text, found)) << text;
  EXPECT_THAT(found, SizeIs(1)) << text;
  if (found.empty()) return "";
  EXPECT_EQ(found[0].id, "gallery-set");
  return formatLocation(found[0].at) + ": " + found[0].message;
}

TEST(GallerySet, aSceneIsDrawnInEveryCombination) {
  Diagnostics found;
  const auto set = parsedSet(R"({"scenes": [{"world": "w", "cameras": ["a", "b"], "times": [0, 6000],
    "weathers": ["rain"], "profiles": ["LOW", "HIGH"], "set": {"X": "2"}}]})", found);
  ASSERT_TRUE(set);
  EXPECT_THAT(found, IsEmpty());
  EXPECT_THAT(shotNames(*set),
              ElementsAre("w, a, 0, rain, LOW", "w, a, 0, rain, HIGH", "w, a, 6000, rain, LOW",
                          "w, a, 6000, rain, HIGH", "w, b, 0, rain, LOW", "w, b, 0, rain, HIGH",
                          "w, b, 6000, rain, LOW", "w, b, 6000, rain, HIGH"));
  const GalleryShot& last = set->shots.back();
  EXPECT_EQ(last.camera, "b");
  EXPECT_EQ(last.time, 6000);
  EXPECT_EQ(last.weather, "rain");
  EXPECT_EQ(last.profile, "HIGH");
  EXPECT_EQ(last.values, (OptionValues{{"X", "2"}}));
  EXPECT_EQ(formatLocation(last.at), "g.json:1:45");
}

TEST(GallerySet, whatASceneLeavesOutIsTheWorldsOwn) {
  Diagnostics found;
  const auto set = parsedSet(R"({"size": "64x36", "frames": 3, "scenes": [{"world": "w"}, {"world": "w", "name": "other"}]})", found);
  ASSERT_TRUE(set);
  EXPECT_THAT(shotNames(*set), ElementsAre("w", "other"));
  EXPECT_EQ(set->shots[0].time, std::nullopt);
  EXPECT_EQ(set->shots[0].weather + set->shots[0].profile + set->shots[0].camera, "");
  EXPECT_EQ(set->size, (ImageSize{64, 36}));
  EXPECT_EQ(set->frames, 3);
}

TEST(GallerySet, profilesOfTheCommandLineAreThoseOfScenesThatNameNone) {
  Diagnostics found;
  const std::string text = R"({"scenes": [{"world": "w"}, {"world": "v", "profiles": ["LOW"]}]})";
  EXPECT_THAT(shotNames(*parsedSet(text, found, {"all"})), ElementsAre("w, LOW", "w, HIGH", "v, LOW"));
  EXPECT_THAT(shotNames(*parsedSet(text, found, {"HIGH"})), ElementsAre("w, HIGH", "v, LOW"));
  const auto all = parsedSet(R"({"scenes": [{"world": "w", "profiles": "all"}]})", found);
  EXPECT_THAT(shotNames(*all), ElementsAre("w, LOW", "w, HIGH"));
}

TEST(GallerySet, theDefaultSetHasTenPictures) {
  Diagnostics found;
  const auto set = parsedSet(kDefaultGallerySet, found);
  ASSERT_TRUE(set);
  EXPECT_THAT(set->shots, SizeIs(10));
}

TEST(GallerySet, mistakesAreLocated) {
  const auto scene = [](const std::string& members) {
    return "{\"scenes\": [\n  {\"world\": \"w\"" + members + "}]}";
  };
  EXPECT_THAT(mistakeOf("{"), HasSubstr("g.json:1:2: "));
  EXPECT_THAT(mistakeOf("[]"), HasSubstr("g.json:1:1: a gallery is a list of 0: expected an object"));
  EXPECT_THAT(mistakeOf("{}"), HasSubstr("g.json:1:1: a gallery has no \"scenes\""));
  EXPECT_THAT(mistakeOf(R"({"scenes": []})"), HasSubstr("g.json:1:12: "));
  EXPECT_THAT(mistakeOf(R"({"scene": [], "scenes": [{"world": "w"}]})"), HasSubstr("g.json:1:2: unknown key \"scene\""));
  EXPECT_THAT(mistakeOf(R"({"size": "9", "scenes": [{"world": "w"}]})"), HasSubstr("g.json:1:10: "));
  EXPECT_THAT(mistakeOf(R"({"frames": 0, "scenes": [{"world": "w"}]})"), HasSubstr("g.json:1:12: "));
  EXPECT_THAT(mistakeOf(R"({"scenes": [{}]})"), HasSubstr("g.json:1:13: a scene has no \"world\""));
  EXPECT_THAT(mistakeOf(scene(R"(, "time": 3)")), HasSubstr("g.json:2:18: unknown key \"time\""));
  EXPECT_THAT(mistakeOf(scene(R"(, "times": [1, 24000])")), HasSubstr("g.json:2:31: a time is 24000"));
  EXPECT_THAT(mistakeOf(scene(R"(, "times": 1)")), HasSubstr("g.json:2:27: "));
  EXPECT_THAT(mistakeOf(scene(R"(, "weathers": ["snow"])")), HasSubstr("g.json:2:31: \"weathers\" has no \"snow\""));
  EXPECT_THAT(mistakeOf(scene(R"(, "profiles": ["LO"])")), HasSubstr("g.json:2:31: \"profiles\" has no \"LO\""));
  EXPECT_THAT(mistakeOf(scene(R"(, "profiles": "LOW")")), HasSubstr("g.json:2:30: \"profiles\" is \"LOW\": expected a list"));
  EXPECT_THAT(mistakeOf(scene(R"(, "cameras": [])")), HasSubstr("g.json:2:29: "));
  EXPECT_THAT(mistakeOf(scene(R"(, "cameras": [7])")), HasSubstr("g.json:2:30: "));
  EXPECT_THAT(mistakeOf(scene(R"(, "set": {"X": 2})")), HasSubstr("g.json:2:31: \"X\" is 2: expected a string"));
  EXPECT_THAT(mistakeOf(scene(R"(, "set": ["X"])")), HasSubstr("g.json:2:25: "));
  EXPECT_THAT(mistakeOf(scene(R"(, "cameras": ["a", "a"])")), HasSubstr("g.json:2:35: two pictures are named \"w, a\""));
}

TEST(GallerySet, thereIsALargestNumberOfPictures) {
  const auto listed = [](int count) {
    std::string text = R"({"scenes": [{"world": "w", "times": [0)";
    for (int i = 1; i < count; ++i) text += "," + std::to_string(i);
    return text + "]}]}";
  };
  Diagnostics found;
  EXPECT_THAT(parsedSet(listed(256), found)->shots, SizeIs(256));
  EXPECT_THAT(mistakeOf(listed(257)), HasSubstr("more than 256 pictures"));
}

TEST(GallerySet, weatherChangesRainAndThunder) {
  Environment environment;
  EXPECT_TRUE(applyWeather("thunder", environment));
  EXPECT_EQ(environment.rain + environment.thunder, 2);
  EXPECT_TRUE(applyWeather("", environment));
  EXPECT_EQ(environment.rain, 1);
  EXPECT_TRUE(applyWeather("clear", environment));
  EXPECT_EQ(environment.rain + environment.thunder, 0);
  EXPECT_FALSE(applyWeather("snow", environment));
}

}  // namespace
}  // namespace orris
