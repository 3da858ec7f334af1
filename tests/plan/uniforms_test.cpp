#include <orris/plan/frame/uniforms.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

namespace orris {
namespace {

TEST(Uniforms, table_is_sorted_and_has_no_name_twice) {
  const auto table = uniformTable();
  for (size_t i = 1; i < table.size(); ++i) EXPECT_LT(table[i - 1].name, table[i].name);
}

TEST(Uniforms, values_have_the_type_their_row_states) {
  const FrameState state = nextFrameState({.width = 4, .height = 4}, {}, nullptr);
  for (const UniformRow& row : uniformTable()) {
    const Value value = row.value(state, DrawState());
    EXPECT_EQ(value.type, row.type) << row.name;
  }
}

TEST(Uniforms, the_time_of_the_year_follows_from_date_and_time) {
  FrameState state;
  const auto seconds = [&] {
    const Value value = findUniform("currentYearTime")->value(state, DrawState());
    return glm::ivec2(value.i[0], value.i[1]);
  };
  EXPECT_EQ(seconds(), glm::ivec2(43200, 366 * 86400 - 43200));
  state.environment.stated = {{"currentDate", {2023, 3, 1}}, {"currentTime", {1, 2, 3}}};
  EXPECT_EQ(seconds(), glm::ivec2(59 * 86400 + 3723, 306 * 86400 - 3723));
  state.environment.stated["currentDate"] = {2023, 2, 30};
  EXPECT_EQ(seconds().x, 3723) << "no such day";
}

TEST(Uniforms, newer_ones_have_values_of_the_game) {
  FrameState state;
  DrawState draw;
  draw.gtextureId = 7;
  const auto value = [&](const char* name) { return findUniform(name)->value(state, draw); };
  state.environment.dimension = "minecraft:overworld";
  EXPECT_EQ(value("seaLevel").i[0], 63);
  state.environment.dimension = "minecraft:the_nether";
  EXPECT_EQ(value("seaLevel").i[0], 32);
  state.environment.dimension = "minecraft:the_end";
  EXPECT_EQ(value("seaLevel").i[0], 0);
  EXPECT_EQ(value("gtextureId").i[0], 7);
  EXPECT_FLOAT_EQ(value("chunkFadeTimeInv").f[0], 1.0f / 750);
  state.endFlashIntensity = 0.5f;
  EXPECT_EQ(value("endFlashIntensity").f[0], 0.5f);
}

// First names of the contract rows: "a / b" and "a, b" name several.
std::set<std::string> contractNames(std::ifstream& file) {
  std::set<std::string> names;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    const bool quoted = line.starts_with('"');
    std::string field =
        quoted ? line.substr(1, line.find('"', 1) - 1) : line.substr(0, line.find(','));
    field = std::regex_replace(field, std::regex("\\([^)]*\\)|\\[[^\\]]*\\]|[,/]"), " ");
    std::istringstream words(field);
    for (std::string word; words >> word;) names.insert(word);
  }
  return names;
}

TEST(Uniforms, every_row_of_the_contract_that_a_host_can_give_is_provided) {
  std::ifstream file(ORRIS_SOURCE_DIR "/docs/contract/uniforms.csv");
  // Names that come from packs themselves, from OptiFine alone, or are fields of gl_Fog.
  static const std::set<std::string> kNotOurs = {
      "timeAngle",      "timeBrightness", "moonBrightness", "shadowFade",   "rainStrengthS",
      "blindFactor",    "isEyeInCave",    "velocity",       "starter",      "frameTimeSmooth",
      "eyeBrightnessM", "inSwamp",        "BiomeTemp",      "day",          "night",
      "dawnDusk",       "bossBattle",     "instanceId",     "spriteBounds", "modelOffset",
      "color",          "density",        "start",          "end",          "scale",
      "dhMaterialId"};
  for (const std::string& name : contractNames(file)) {
    const bool glState = name.starts_with("gl_") || name.find('.') != std::string::npos;
    const bool otherHost = name.starts_with("vx") || name.starts_with("vivecraft");
    if (glState || otherHost || kNotOurs.contains(name)) continue;
    EXPECT_NE(findUniform(name), nullptr) << name;
  }
}

}  // namespace
}  // namespace orris
