// shaders.properties repeats what the shaders compute: it can include nothing and knows no arithmetic.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <regex>

#include "load_pack.h"

namespace orris::test {
namespace {

using Size = std::array<float, 3>;

std::map<std::string, Size> imageSizes(const OptionValues& values) {
  const std::optional<ShaderPack> pack = loadReferencePack({.values = values});
  std::map<std::string, Size> sizes;
  for (const CustomImage& image : pack.value().properties.images) sizes[image.name] = image.size;
  return sizes;
}

FileLines linesOf(const std::string& file) {
  std::ifstream stream(ORRIS_SOURCE_DIR "/shaderpack/shaders/" + file);
  EXPECT_TRUE(stream) << file;
  FileLines lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// The lines `#define NAME ...` of the two files that the properties repeat, without their comments.
std::multimap<std::string, std::string> definitionsOf(const FileLines& lines) {
  static const std::regex pattern(R"(#define (\w+) (.*?) *(//.*)?)");
  std::multimap<std::string, std::string> found;
  std::smatch match;
  for (const std::string& line : lines)
    if (std::regex_match(line, match, pattern)) found.emplace(match[1], match[2]);
  return found;
}

std::vector<std::string> allOf(const std::multimap<std::string, std::string>& definitions,
                               const std::string& name) {
  std::vector<std::string> values;
  const auto [first, last] = definitions.equal_range(name);
  for (auto it = first; it != last; ++it) values.push_back(it->second);
  return values;
}

TEST(ReferencePackProperties, words_and_flags_are_those_of_the_shaders) {
  FileLines shaders = linesOf("include/derived/words.glsl");
  for (const char* file : {"include/derived/features.glsl", "include/derived/sizes.glsl"})
    for (const std::string& line : linesOf(file)) shaders.push_back(line);
  const auto here = definitionsOf(linesOf("shaders.properties")), there = definitionsOf(shaders);
  int repeated = 0;
  for (const auto& [name, value] : here) {
    if (!there.contains(name)) continue;
    EXPECT_EQ(allOf(here, name), allOf(there, name)) << name;
    ++repeated;
  }
  EXPECT_GT(repeated, 40);
}

/// Every number that a word stands for is of one word.
TEST(ReferencePackProperties, words_of_options_differ) {
  std::map<std::string, std::string> names;
  static const std::regex number("[0-9]+");
  for (const auto& [name, value] : definitionsOf(linesOf("include/derived/words.glsl"))) {
    if (!std::regex_match(value, number)) continue;
    EXPECT_TRUE(names.emplace(value, name).second) << name << " is " << names[value];
  }
  EXPECT_GT(names.size(), 30);
}

/// An option is compared with words of its own list, which stand for names that begin with the option's.
TEST(ReferencePackProperties, options_are_compared_with_their_own_words) {
  const ShaderPack pack = loadReferencePack({}).value();
  static const std::regex comparison(R"(\b([A-Z]\w+) (==|!=|>=|<=|<|>) ([A-Z]\w+))");
  std::map<std::string, FileLines> files = pack.files;
  files["/shaders.properties"] = linesOf("shaders.properties");
  int compared = 0;
  for (const auto& [path, lines] : files) {
    for (const std::string& line : lines) {
      for (std::sregex_iterator it(line.begin(), line.end(), comparison), end; it != end; ++it) {
        const Option* option = pack.options.find((*it)[1].str());
        if (!option) continue;
        const std::string word = (*it)[3], prefix = option->name + "_";
        const std::string own = word.starts_with(prefix) ? word.substr(prefix.size()) : word;
        EXPECT_THAT(option->values, testing::Contains(own)) << path << ": " << it->str();
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 50);
}

TEST(ReferencePackProperties, images_have_the_size_of_the_volume) {
  for (const int volume : {32, 48, 64, 96, 128}) {
    const float v = static_cast<float>(volume);
    const OptionValues values = {{"SHADOW_RESOLUTION", "2048"},
                                 {"VOXEL_SIZE", std::to_string(volume)}};
    const auto with = [&](const char* method) {
      OptionValues all = values;
      all["GI_METHOD"] = method;
      return imageSizes(all);
    };
    const auto faces = with("FACE_CACHE"), flood = with("FLOODFILL");
    EXPECT_EQ(faces.at("face_light"), (Size{9 * v, v, 2 * v}));
    EXPECT_EQ(faces.at("face_seen"), (Size{v, v, v + 1}));
    EXPECT_EQ(faces.at("voxel_bits"), (Size{2 * std::ceil(v / 32), v, v}));
    EXPECT_EQ(faces.at("voxel_distance"), (Size{v / 8, v, v}));
    EXPECT_EQ(flood.at("flood_light"), (Size{v + 8, v + 4, 2 * v}));
  }
}

TEST(ReferencePackProperties, largest_volume_is_not_for_the_face_cache) {
  const auto sizes = [](const char* method) {
    return imageSizes(
        {{"GI_METHOD", method}, {"VOXEL_SIZE", "256"}, {"SHADOW_RESOLUTION", "4096"}});
  };
  const auto flood = sizes("FLOODFILL"), faces = sizes("FACE_CACHE");
  EXPECT_EQ(flood.at("voxel_distance"), (Size{32, 128, 256}));
  EXPECT_EQ(flood.at("voxel_bits"), (Size{16, 128, 256}));
  EXPECT_EQ(flood.at("flood_light"), (Size{264, 132, 512}));
  EXPECT_EQ(faces.at("voxel_distance"), (Size{16, 128, 128}));
  EXPECT_EQ(faces.at("face_light"), (Size{1152, 128, 256}));
}

TEST(ReferencePackProperties, methods_without_images_have_none) {
  for (const char* method : {"NONE", "BOUNCE_1", "BOUNCE_4", "FLOODFILL"}) {
    EXPECT_FALSE(imageSizes({{"GI_METHOD", method}}).contains("face_light")) << method;
    EXPECT_TRUE(
        imageSizes({{"GI_METHOD", method}, {"RAY_WALK", "GRID"}, {"FLOODFILL_STORAGE", "ATLAS_2D"}})
            .empty())
        << method;
  }
}

TEST(ReferencePackProperties, floodfill_buffer_has_the_size_of_its_atlas) {
  const auto size = [](const char* volume, const char* resolution) {
    const OptionValues values = {{"VOXEL_SIZE", volume}, {"SHADOW_RESOLUTION", resolution}};
    return loadReferencePack({.values = values})->properties.bufferSize.at("colortex4").size;
  };
  using testing::ElementsAre;
  EXPECT_THAT(size("32", "1024"), ElementsAre(1024, 32));
  EXPECT_THAT(size("48", "1024"), ElementsAre(768, 144));
  EXPECT_THAT(size("64", "1024"), ElementsAre(1024, 256));
  EXPECT_THAT(size("96", "1024"), ElementsAre(1024, 256)) << "needs a larger shadow target";
  EXPECT_THAT(size("96", "2048"), ElementsAre(1920, 480));
  EXPECT_THAT(size("128", "2048"), ElementsAre(2048, 1024));
}

TEST(ReferencePackProperties, images_of_the_lamps_have_room_for_the_lists) {
  for (const int columns : {8, 16, 20, 32}) {
    const std::map<int, int> rows = {{8, 5}, {16, 9}, {20, 12}, {32, 18}};
    const auto sizes = imageSizes({{"GI_METHOD", "NONE"},
                                   {"LIGHT_METHOD", "CLUSTERED"},
                                   {"LIGHT_CAPACITY", "4096"},
                                   {"LIGHT_COLUMNS", std::to_string(columns)}});
    const float tiles = static_cast<float>(columns * rows.at(columns));
    EXPECT_EQ(sizes.at("light_bits"), (Size{4096 / 32 + 1, tiles, 24}));
    EXPECT_EQ(sizes.at("light_list"), (Size{512, tiles, 24}));
    EXPECT_EQ(sizes.at("light_table"), (Size{1024, 4096 / 512, 1}));
  }
  const auto near = imageSizes({{"LIGHT_METHOD", "DEFERRED"}, {"LIGHT_DISTANCE", "48"}});
  EXPECT_EQ(near.at("lamp_cells"), (Size{96, 96, 96}));
  EXPECT_EQ(near.at("lamp_tally"), (Size{96 + 2, 96, 1}));
}

}  // namespace
}  // namespace orris::test
