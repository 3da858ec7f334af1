// The pack loads cleanly and its options are what the design says.
#include <gtest/gtest.h>

#include <algorithm>

#include "load_pack.h"

namespace orris::test {
namespace {

using testing::ElementsAre;

TEST(pack, every_profile_loads_and_is_recognised) {
  for (const char* profile : {"LOW", "MEDIUM", "HIGH", "REFERENCE"}) {
    const std::optional<ShaderPack> pack = loadReferencePack({.profile = profile});
    ASSERT_TRUE(pack);
    EXPECT_EQ(pack->currentProfile(), profile);
  }
}

TEST(pack, defaults_are_the_medium_profile) {
  EXPECT_EQ(loadReferencePack({})->currentProfile(), "MEDIUM");
}

TEST(pack, method_options_have_the_published_values) {
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

TEST(pack, guards_and_stage_names_are_not_options) {
  const std::optional<ShaderPack> pack = loadReferencePack({});
  ASSERT_TRUE(pack);
  for (const auto& [name, option] : pack->options.all())
    EXPECT_EQ(option.at.front().file, "/settings.glsl") << name;
}

TEST(pack, every_option_is_on_a_screen) {
  const std::optional<ShaderPack> pack = loadReferencePack({});
  ASSERT_TRUE(pack);
  std::set<std::string> placed;
  for (const Screen& screen : pack->properties.screens)
    placed.insert(screen.entries.begin(), screen.entries.end());
  for (const auto& [name, option] : pack->options.all()) EXPECT_TRUE(placed.contains(name)) << name;
  for (const std::string& slider : pack->properties.sliders)
    EXPECT_TRUE(pack->options.find(slider)) << slider;
}

TEST(pack, programs_follow_the_methods) {
  const auto has = [](const OptionValues& values, const char* program) {
    return loadReferencePack({.values = values})->find(program) != nullptr;
  };
  EXPECT_TRUE(has({{"GI_METHOD", "FLOODFILL"}, {"FLOODFILL_STORAGE", "ATLAS_2D"}}, "prepare"));
  EXPECT_FALSE(has({{"GI_METHOD", "FLOODFILL"}}, "prepare"));
  EXPECT_TRUE(has({{"GI_METHOD", "FLOODFILL"}}, "prepare2"));
  EXPECT_TRUE(has({{"GI_METHOD", "BOUNCE_1"}}, "shadowcomp6"));
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

TEST(pack, face_cache_has_images_of_the_size_of_its_volume) {
  const auto images = [](const OptionValues& values) {
    const std::optional<ShaderPack> pack = loadReferencePack({.values = values});
    std::map<std::string, std::vector<float>> sizes;
    for (const CustomImage& image : pack.value().properties.images)
      sizes[image.name] = {image.size[0], image.size[1], image.size[2]};
    return sizes;
  };
  for (const char* method : {"NONE", "BOUNCE_1", "BOUNCE_4", "FLOODFILL"}) {
    EXPECT_EQ(images({{"GI_METHOD", method}}).count("face_light"), 0) << method;
    EXPECT_TRUE(
        images({{"GI_METHOD", method}, {"RAY_WALK", "GRID"}, {"FLOODFILL_STORAGE", "ATLAS_2D"}})
            .empty())
        << method;
  }
  for (const float volume : {32, 48, 64, 96, 128}) {
    const auto sizes = images({{"GI_METHOD", "FACE_CACHE"},
                               {"SHADOW_RESOLUTION", "2048"},
                               {"VOXEL_SIZE", std::to_string(static_cast<int>(volume))}});
    EXPECT_THAT(sizes.at("face_light"), ElementsAre(9 * volume, volume, volume));
    EXPECT_THAT(sizes.at("face_seen"), ElementsAre(volume, volume, volume));
  }
}

TEST(pack, largest_volume_is_not_for_the_face_cache) {
  const auto sizeOf = [](const char* method, const char* image) {
    const auto pack = loadReferencePack(
        {.values = {{"GI_METHOD", method}, {"VOXEL_SIZE", "256"}, {"SHADOW_RESOLUTION", "4096"}}});
    for (const CustomImage& candidate : pack->properties.images)
      if (candidate.name == image) return candidate.size;
    return std::array<float, 3>{};
  };
  EXPECT_THAT(sizeOf("FLOODFILL", "voxel_distance"), ElementsAre(32, 128, 256));
  EXPECT_THAT(sizeOf("FACE_CACHE", "voxel_distance"), ElementsAre(16, 128, 128));
  EXPECT_THAT(sizeOf("FACE_CACHE", "face_light"), ElementsAre(1152, 128, 128));
}

TEST(pack, lamps_have_what_their_method_needs) {
  const auto images = [](const ShaderPack& pack) {
    std::set<std::string> names;
    for (const CustomImage& image : pack.properties.images) names.insert(image.name);
    return names;
  };
  const auto programs = [](const ShaderPack& pack) {
    std::string found;
    for (const char* program : {"shadowcomp2", "shadowcomp3", "shadowcomp4", "shadowcomp5"})
      found += pack.find(program) ? program[10] : '-';
    return found;
  };
  const std::set<std::string> table = {"lamp_cells", "lamp_tally", "light_state", "light_table"};
  std::set<std::string> grid = table;
  grid.insert({"light_bits", "light_list"});
  const std::tuple<const char*, std::set<std::string>, const char*> expected[] = {
      {"NONE", {}, "----"},    {"FORWARD", table, "2--5"},  {"DEFERRED", table, "2--5"},
      {"TILED", grid, "2345"}, {"CLUSTERED", grid, "2345"}, {"AUTO", grid, "2345"}};
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

TEST(pack, lamps_without_shadows_have_no_voxels) {
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
  for (const char* program : {"shadowcomp", "shadowcomp1", "shadowcomp6"}) {
    EXPECT_FALSE(without->find(program)) << program;
    EXPECT_TRUE(with->find(program)) << program;
  }
  EXPECT_FALSE(with->find("deferred")) << "no rays but those to lamps";
}

TEST(pack, automatic_shadows_are_a_map_where_the_host_chooses_nothing) {
  const auto pack =
      loadReferencePack({.values = {{"GI_METHOD", "NONE"}, {"SHADOW_METHOD", "AUTO"}}});
  EXPECT_TRUE(pack->find("shadow"));
  EXPECT_FALSE(pack->find("shadowvolume"));
}

TEST(pack, floodfill_buffer_has_the_size_of_its_atlas) {
  const auto size = [](const OptionValues& values) {
    return loadReferencePack({.values = values})->properties.bufferSize.at("colortex4").size;
  };
  EXPECT_THAT(size({{"VOXEL_SIZE", "32"}}), ElementsAre(1024, 32));
  EXPECT_THAT(size({{"VOXEL_SIZE", "48"}}), ElementsAre(768, 144));
  EXPECT_THAT(size({{"VOXEL_SIZE", "64"}}), ElementsAre(1024, 256));
  EXPECT_THAT(size({{"VOXEL_SIZE", "96"}}), ElementsAre(1024, 256))
      << "needs a larger shadow target";
  EXPECT_THAT(size({{"VOXEL_SIZE", "96"}, {"SHADOW_RESOLUTION", "2048"}}), ElementsAre(1920, 480));
}

}  // namespace
}  // namespace orris::test
