// The pack loads cleanly and its options are what the design says.
#include <gtest/gtest.h>

#include <algorithm>

#include "load_pack.h"

namespace orris::test {
namespace {

using testing::ElementsAre;

TEST(ReferencePack, every_profile_loads_and_is_recognised) {
  for (const char* profile : {"LOW", "MEDIUM", "HIGH", "REFERENCE"}) {
    const std::optional<ShaderPack> pack = loadReferencePack({.profile = profile});
    ASSERT_TRUE(pack);
    EXPECT_EQ(pack->currentProfile(), profile);
  }
}

TEST(ReferencePack, defaults_are_the_medium_profile) {
  EXPECT_EQ(loadReferencePack({})->currentProfile(), "MEDIUM");
}

TEST(ReferencePack, method_options_have_the_published_values) {
  const std::optional<ShaderPack> pack = loadReferencePack({});
  ASSERT_TRUE(pack);
  const auto values = [&](const char* name) { return pack->options.find(name)->values; };
  EXPECT_THAT(values("DIRECT_LIGHT"),
              ElementsAre("NONE", "PHONG", "PHONG_PUBLISHED", "LAMBERT_GGX"));
  EXPECT_THAT(values("SHADOW_METHOD"), ElementsAre("NONE", "MAP", "MAP_PCF", "VOLUME_ZPASS",
                                                   "VOLUME_ZFAIL", "VOLUME_AUTO", "AUTO"));
  EXPECT_THAT(values("GI_METHOD"),
              ElementsAre("NONE", "BOUNCE_1", "BOUNCE_2", "BOUNCE_4", "FLOODFILL", "FACE_CACHE"));
  EXPECT_THAT(values("LIGHT_METHOD"),
              ElementsAre("NONE", "FORWARD", "DEFERRED", "TILED", "CLUSTERED", "AUTO"));
  EXPECT_EQ(pack->options.find("LIGHT_METHOD")->defaultValue, "NONE");
  EXPECT_EQ(pack->options.find("FLOODFILL_ALPHA")->defaultValue, "2.43902");
  EXPECT_EQ(pack->options.find("FLOODFILL_GAMMA")->defaultValue, "2.2");
  EXPECT_EQ(pack->options.find("FLOODFILL_INTERVAL")->defaultValue, "3");
}

TEST(ReferencePack, guards_and_stage_names_are_not_options) {
  const std::optional<ShaderPack> pack = loadReferencePack({});
  ASSERT_TRUE(pack);
  for (const auto& [name, option] : pack->options.all())
    EXPECT_EQ(option.at.front().file, "/settings.glsl") << name;
}

TEST(ReferencePack, every_option_is_on_a_screen) {
  const std::optional<ShaderPack> pack = loadReferencePack({});
  ASSERT_TRUE(pack);
  std::set<std::string> placed;
  for (const Screen& screen : pack->properties.screens)
    placed.insert(screen.entries.begin(), screen.entries.end());
  for (const auto& [name, option] : pack->options.all()) EXPECT_TRUE(placed.contains(name)) << name;
  for (const std::string& slider : pack->properties.sliders)
    EXPECT_TRUE(pack->options.find(slider)) << slider;
}

TEST(ReferencePack, programs_follow_the_methods) {
  const auto has = [](const OptionValues& values, const char* program) {
    return loadReferencePack({.values = values})->find(program) != nullptr;
  };
  EXPECT_TRUE(has({{"GI_METHOD", "FLOODFILL"}, {"FLOODFILL_STORAGE", "ATLAS_2D"}}, "prepare"));
  EXPECT_FALSE(has({{"GI_METHOD", "FLOODFILL"}}, "prepare"));
  EXPECT_TRUE(has({{"GI_METHOD", "FLOODFILL"}}, "prepare2"));
  EXPECT_TRUE(has({{"GI_METHOD", "BOUNCE_1"}}, "shadowcomp2"));
  EXPECT_FALSE(has({{"GI_METHOD", "BOUNCE_1"}, {"RAY_WALK", "GRID"}}, "shadowcomp"));
  EXPECT_FALSE(has({{"GI_METHOD", "BOUNCE_4"}}, "prepare"));
  for (const char* program : {"shadowcomp7", "shadowcomp8"}) {
    EXPECT_TRUE(has({{"GI_METHOD", "FACE_CACHE"}}, program)) << program;
    EXPECT_FALSE(has({{"GI_METHOD", "FLOODFILL"}}, program)) << program;
  }
  EXPECT_TRUE(has({{"GI_METHOD", "BOUNCE_4"}}, "deferred"));
  EXPECT_FALSE(has({{"GI_METHOD", "NONE"}}, "deferred"));
  EXPECT_TRUE(has({{"GI_METHOD", "NONE"}}, "shadow"));
  EXPECT_TRUE(has({{"SHADOW_METHOD", "NONE"}}, "shadow"));
  EXPECT_FALSE(has({{"GI_METHOD", "NONE"}, {"SHADOW_METHOD", "NONE"}}, "shadow"));
  EXPECT_TRUE(
      has({{"GI_METHOD", "NONE"}, {"SHADOW_METHOD", "NONE"}, {"LIGHT_METHOD", "TILED"}}, "shadow"));
}

TEST(ReferencePack, lamps_have_what_their_method_needs) {
  const auto images = [](const ShaderPack& pack) {
    std::set<std::string> names;
    for (const CustomImage& image : pack.properties.images) names.insert(image.name);
    return names;
  };
  const auto programs = [](const ShaderPack& pack) {
    std::string found;
    for (const char* program : {"shadowcomp3", "shadowcomp4", "shadowcomp5", "shadowcomp6"})
      found += pack.find(program) ? program[10] : '-';
    return found;
  };
  const std::set<std::string> table = {"lamp_cells", "lamp_tally", "light_state", "light_table"};
  std::set<std::string> grid = table;
  grid.insert({"light_bits", "light_list"});
  const std::tuple<const char*, std::set<std::string>, const char*> expected[] = {
      {"NONE", {}, "----"},    {"FORWARD", table, "3--6"},  {"DEFERRED", table, "3--6"},
      {"TILED", grid, "3456"}, {"CLUSTERED", grid, "3456"}, {"AUTO", grid, "3456"}};
  for (const auto& [method, names, found] : expected) {
    const auto pack =
        loadReferencePack({.values = {{"GI_METHOD", "NONE"}, {"LIGHT_METHOD", method}}});
    EXPECT_EQ(images(pack.value()), names) << method;
    EXPECT_EQ(programs(*pack), found) << method;
  }
  // Sixteen images are possible: more would be a warning.
  EXPECT_TRUE(
      loadReferencePack({.values = {{"GI_METHOD", "FACE_CACHE"}, {"LIGHT_METHOD", "CLUSTERED"}}}));
}

TEST(ReferencePack, lamps_without_shadows_have_no_voxels) {
  const auto loaded = [](const char* shadows) {
    return loadReferencePack(
        {.values = {
             {"GI_METHOD", "NONE"}, {"LIGHT_METHOD", "CLUSTERED"}, {"LIGHT_SHADOWS", shadows}}});
  };
  const auto without = loaded("0"), with = loaded("2");
  const auto images = [](const ShaderPack& pack) {
    return std::count_if(pack.properties.images.begin(), pack.properties.images.end(),
                         [](const CustomImage& image) { return image.name.starts_with("voxel"); });
  };
  EXPECT_EQ(images(*without), 0);
  EXPECT_GT(images(*with), 0);
  for (const char* program : {"shadowcomp", "shadowcomp1", "shadowcomp2"}) {
    EXPECT_FALSE(without->find(program)) << program;
    EXPECT_TRUE(with->find(program)) << program;
  }
  EXPECT_FALSE(with->find("deferred")) << "no rays but those to lamps";
}

TEST(ReferencePack, automatic_shadows_are_a_map_where_the_host_chooses_nothing) {
  const auto pack =
      loadReferencePack({.values = {{"GI_METHOD", "NONE"}, {"SHADOW_METHOD", "AUTO"}}});
  EXPECT_TRUE(pack->find("shadow"));
  EXPECT_FALSE(pack->find("shadowvolume"));
}

}  // namespace
}  // namespace orris::test
