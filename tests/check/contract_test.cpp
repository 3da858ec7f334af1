// docs/contract.md against the tables of the code, in both directions.
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "check/contract_page.h"
#include <orris/plan/schedule/program_uses.h>
#include <orris/plan/frame/uniforms.h>
#include <orris/render/scene/vertex_layout.h>
#include <orris/image/texel_format.h>
#include <orris/pack/programs/directives.h>
#include <orris/pack/expressions/expression_functions.h>
#include <orris/pack/versions/features.h>
#include <orris/pack/programs/program_id.h>
#include <orris/pack/properties/property_keys.h>
#include <orris/pack/shader_pack.h>
#include <orris/pack/properties/texture_format.h>
#include "text_fixture.h"

namespace orris {
namespace {

namespace fs = std::filesystem;
using testing::IsEmpty;
using Names = std::vector<std::string>;

template <typename Range>
Names without(const Range& names, const std::set<std::string>& patterns) {
  Names missing;
  for (const auto& name : names) {
    if (!matchesAny(std::string(name), patterns)) missing.emplace_back(name);
  }
  return missing;
}

/// Plain names of the rows of a section whose code is `file`.
Names namesIn(const std::string& section, const std::string& file) {
  Names names;
  for (const ContractRow& row : rowsOf(section)) {
    if (row.code != file || row.state == "not") continue;
    for (const std::string& word : wordsOf(row.name)) {
      if (word.find('*') == std::string::npos) names.push_back(word);
    }
  }
  return names;
}

std::set<std::string> asSet(const auto& names) {
  std::set<std::string> set;
  for (const auto& name : names) set.emplace(name);
  return set;
}

TEST(ContractPage, has_a_row_for_each_of_the_contract) {
  const std::pair<const char*, const char*> kTables[] = {
      {"programs", "Programs"},
      {"uniforms", "Uniforms"},
      {"attributes", "Vertex attributes"},
      {"buffers", "Buffers, samplers and images"},
      {"formats", "Texture formats"},
      {"constants", "Directives in shader text"},
      {"macros", "Macros"},
      {"properties", "Keys of shaders.properties"},
      {"options", "Options, profiles, screens, includes and loading"},
      {"idmaps", "Id maps and dimensions"},
      {"expressions", "Custom uniforms"}};
  for (const auto& [table, section] : kTables) {
    Names rows;
    for (const ContractRow& row : rowsOf(section)) rows.push_back(row.name);
    const Names wanted = contractNames(table);
    EXPECT_FALSE(wanted.empty()) << table;
    for (const std::string& name : asSet(wanted)) {
      EXPECT_EQ(std::count(rows.begin(), rows.end(), name),
                std::count(wanted.begin(), wanted.end(), name))
          << table << ": " << name;
    }
  }
}

TEST(ContractPage, states_and_tiers_are_of_the_known_ones) {
  EXPECT_GT(readContractPage().size(), 600u);
  for (const ContractRow& row : readContractPage()) {
    EXPECT_TRUE(row.tier == "1" || row.tier == "2" || row.tier == "3") << row.name;
    EXPECT_TRUE(row.state == "works" || row.state == "constant" || row.state == "not") << row.name;
    EXPECT_TRUE(row.state != "not" || row.tier == "3") << row.name;
  }
}

TEST(ContractPage, files_and_tests_that_it_names_exist) {
  std::string tests;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(ORRIS_TEST_DIR)) {
    const fs::path& path = entry.path();
    if (path.extension() == ".cpp" || path.filename() == "cases.py") tests += textOf(path);
  }
  for (const ContractRow& row : readContractPage()) {
    if (row.code == "-") {
      EXPECT_EQ(row.state, "not") << row.name;
      continue;
    }
    EXPECT_TRUE(fs::is_regular_file(fs::path(ORRIS_SOURCE_DIR) / row.code)) << row.code;
    const size_t dot = row.test.find('.');
    const std::string wanted = dot == std::string::npos
                                   ? "Case(\"" + row.test + "\""
                                   : row.test.substr(0, dot) + ", " + row.test.substr(dot + 1);
    EXPECT_NE(tests.find(wanted), std::string::npos) << row.name << ": " << row.test;
  }
}

TEST(ContractPrograms, names_and_fallbacks_are_those_of_the_table) {
  std::set<std::string> words = wordsOfSection("Programs");
  Names known;
  for (const GeometryProgram& program : geometryPrograms()) known.emplace_back(program.name);
  EXPECT_THAT(without(known, words), IsEmpty());
  for (const std::string& word : words) {
    if (word.find('*') != std::string::npos || word == "..") continue;
    EXPECT_TRUE(parseProgramFile("/" + word + ".fsh") || parseProgramFile("/" + word + ".csh"))
        << word;
  }
}

TEST(ContractPrograms, fallbacks_are_those_of_the_contract) {
  const std::pair<std::string_view, std::string_view> kFallbacks[] = {
      {"shadow_block", "shadow"},
      {"shadow_lightning", "shadow_entities"},
      {"gbuffers_clouds", "gbuffers_textured"},
      {"gbuffers_block", "gbuffers_terrain"},
      {"gbuffers_entities", "gbuffers_textured_lit"},
      {"gbuffers_weather", "gbuffers_textured_lit"},
      {"gbuffers_hand_water", "gbuffers_hand"},
      {"gbuffers_particles_translucent", "gbuffers_particles"},
      {"dh_water", "dh_terrain"},
      {"clrwl_gbuffers_glint", "clrwl_gbuffers"}};
  for (const auto& [program, fallback] : kFallbacks) EXPECT_EQ(fallbackOf(program), fallback);
}

TEST(ContractUniforms, are_those_of_the_table) {
  std::set<std::string> words = wordsOfSection("Uniforms");
  words.merge(wordsOfSection("Custom uniforms"));
  Names known;
  for (const UniformRow& row : uniformTable()) known.emplace_back(row.name);
  EXPECT_THAT(without(known, words), IsEmpty());
  for (const std::string& name : namesIn("Uniforms", "loader/plan/frame/uniforms.cpp"))
    EXPECT_NE(findUniform(name), nullptr) << name;
}

TEST(ContractUniforms, an_empty_hand_depends_on_item_properties) {
  FrameState state;
  const auto heldItem = [&] { return findUniform("heldItemId")->value(state, {}).i[0]; };
  EXPECT_EQ(heldItem(), -1);
  state.heldItemId = 0;
  EXPECT_EQ(heldItem(), 0);
}

TEST(ContractUniforms, the_player_is_that_of_the_world) {
  FrameState state;
  state.environment.player = {.blindness = 0.25f, .heldLight2 = 7, .sneaking = true};
  EXPECT_EQ(findUniform("blindness")->value(state, {}).f[0], 0.25f);
  EXPECT_EQ(findUniform("heldBlockLightValue2")->value(state, {}).i[0], 7);
  EXPECT_EQ(findUniform("is_sneaking")->value(state, {}).i[0], 1);
  EXPECT_EQ(findUniform("is_hurt")->value(state, {}).i[0], 0);
  EXPECT_EQ(findUniform("is_on_ground")->value(state, {}).i[0], 1);
}

TEST(ContractUniforms, what_only_the_player_knows_is_as_the_world_states) {
  FrameState state;
  state.cameraPosition = {10, 20, 30};
  for (const StatedUniform& stated : kStatedUniforms) {
    const UniformRow* row = findUniform(stated.name);
    ASSERT_NE(row, nullptr) << stated.name;
    const auto first = [&] {
      const Value value = row->value(state, {});
      return row->type == ValueType::Float || row->type == ValueType::Vec3 ? value.f[0] : static_cast<float>(value.i[0]);
    };
    EXPECT_EQ(first(), stated.otherwise[0]) << stated.name;
    state.environment.stated[std::string(stated.name)] = {stated.high, stated.high, stated.high};
    EXPECT_EQ(first(), stated.high) << stated.name;
  }
  state.environment.stated = {{"relativeEyePosition", {1, 2, 3}}};
  const Value eye = findUniform("eyePosition")->value(state, {});
  EXPECT_EQ(eye.f[0], 9);
  EXPECT_EQ(eye.f[2], 27);
}

TEST(ContractPage, what_is_constant_belongs_to_other_mods) {
  const std::set<std::string> mods = {"dh*",        "clrwl_*",    "vivecraft*", "VIVECRAFT*",
                                      "IS_MONOCLE", "photonics*", "DISTANT_HORIZONS", "ALLOWS_UNKNOWN_SHADERS",
                                      "IRIS_HAS_CONNECTED_TEXTURES"};
  for (const ContractRow& row : readContractPage()) {
    if (row.state != "constant") continue;
    for (const std::string& word : wordsOf(row.name)) {
      const bool known = std::any_of(mods.begin(), mods.end(), [&](const std::string& mod) {
        return mod.ends_with('*') ? word.starts_with(mod.substr(0, mod.size() - 1)) : word == mod;
      });
      EXPECT_TRUE(known) << row.name;
    }
  }
}

TEST(ContractAttributes, are_those_of_the_layout) {
  EXPECT_THAT(without(attributeNames(), wordsOfSection("Vertex attributes")), IsEmpty());
  Names generic = namesIn("Vertex attributes", "loader/render/scene/vertex_layout.cpp");
  std::erase_if(generic, [](const std::string& name) { return name.starts_with("gl_"); });
  EXPECT_THAT(without(generic, asSet(attributeNames())), IsEmpty());
}

TEST(ContractBuffers, are_those_of_the_code) {
  const std::set<std::string> words = wordsOfSection("Buffers, samplers and images");
  Names known;
  for (const char* prefix :
       {"colortex", "colorimg", "depthtex", "shadowtex", "shadowcolor", "shadowcolorimg"}) {
    for (int i = 0; i < 40; ++i) {
      const std::string name = prefix + std::to_string(i);
      if (parseBufferName(name, false)) known.push_back(name);
    }
  }
  EXPECT_EQ(known.size(), 2u * kColorTargets + 3 + 2 + 8 + 8);
  EXPECT_THAT(without(known, words), IsEmpty());
  for (const std::string& name :
       namesIn("Buffers, samplers and images", "loader/render/draw/sampler_binder.cpp")) {
    const bool named = name == "gtexture" || name == "lightmap" || name == "normals" ||
                       name == "specular" || name.starts_with("dhDepthTex");
    EXPECT_TRUE(named || parseBufferName(name, false)) << name;
  }
}

TEST(ContractFormats, names_are_those_of_the_code) {
  const std::set<std::string> words = wordsOfSection("Texture formats");
  std::set<std::string> known = asSet(internalFormatNames());
  for (const auto* names : {&pixelFormatNames(), &pixelTypeNames(), &textureTypeNames()})
    known.merge(asSet(*names));
  EXPECT_THAT(without(known, words), IsEmpty());
  EXPECT_THAT(without(words, known), IsEmpty());
  for (const std::string& name : internalFormatNames()) EXPECT_TRUE(findFormat(name)) << name;
}

TEST(ContractDirectives, each_changes_the_settings) {
  const std::set<std::string> words = wordsOfSection("Directives in shader text");
  EXPECT_THAT(without(packDirectiveNames(), words), IsEmpty());
  for (const ContractRow& row : rowsOf("Directives in shader text")) {
    if (row.code != "loader/pack/programs/pack_directives.cpp" ||
        row.test.starts_with("ContractDirectives.forms"))
      continue;
    const std::set<std::string> known = asSet(packDirectiveNames());
    for (const std::string& word : wordsOf(row.name)) {
      const bool ofTarget = word.find('*') != std::string::npos;
      const bool legacy = row.name.starts_with("<legacy name>");
      EXPECT_TRUE(ofTarget || legacy || known.contains(word) || word == "and" || word == "names")
          << word;
    }
  }
}

PackDirectives directivesOf(const std::string& line) {
  Diagnostics diagnostics;
  const auto pack = loadShaderPack(
      memorySource({{"/final.fsh", "#version 330 compatibility\n" + line + "\nvoid main() {}\n"}}),
      {.environment = standardMacros({})}, diagnostics);
  EXPECT_TRUE(pack) << line;
  return pack ? pack->directives : PackDirectives();
}

TEST(ContractDirectives, values_reach_their_setting) {
  EXPECT_EQ(directivesOf("const int shadowMapResolution = 77;").shadowMapResolution, 77);
  EXPECT_EQ(directivesOf("const int noiseTextureResolution = 77;").noiseTextureResolution, 77);
  EXPECT_EQ(directivesOf("const float shadowDistance = 7.5;").shadowDistance, 7.5f);
  EXPECT_EQ(directivesOf("const float shadowNearPlane = 7.5;").shadowNearPlane, 7.5f);
  EXPECT_EQ(directivesOf("const float shadowFarPlane = 7.5;").shadowFarPlane, 7.5f);
  EXPECT_EQ(directivesOf("const float shadowMapFov = 90;").shadowMapFov, 90.0f);
  EXPECT_EQ(directivesOf("const float sunPathRotation = -40;").sunPathRotation, -40.0f);
  EXPECT_EQ(directivesOf("const float voxelDistance = 16;").voxelDistance, 16.0f);
  EXPECT_EQ(directivesOf("const float entityShadowDistanceMul = 0.5;").entityShadowDistanceMul,
            0.5f);
  EXPECT_EQ(directivesOf("const float shadowDistanceRenderMul = 1;").shadowDistanceRenderMul, 1);
  EXPECT_TRUE(directivesOf("const bool generateShadowColorMipmap = true;").shadowcolor[1].mipmap);
  EXPECT_TRUE(directivesOf("const bool shadowColor1Nearest = true;").shadowcolor[1].nearest);
}

TEST(ContractDirectives, forms_of_optifine_are_ignored) {
  const PackDirectives read = directivesOf(
      "/* SHADOWRES:512 */ /* SHADOWHPL:9.0 */ /* GAUX4FORMAT:RGBA32F */ /* WETNESSHL:1.0 */\n"
      "const int countInstances = 4;");
  const PackDirectives none;
  EXPECT_EQ(read.shadowMapResolution, none.shadowMapResolution);
  EXPECT_EQ(read.shadowDistance, none.shadowDistance);
  EXPECT_EQ(read.wetnessHalflife, none.wetnessHalflife);
  EXPECT_TRUE(read.colortex.empty());
}

TEST(ContractMacros, are_those_of_the_code) {
  HostDescription host;
  host.labPbr = true;
  std::set<std::string> known;
  for (const auto& [name, value] : standardMacros(host)) known.insert(name);
  std::set<std::string> words = wordsOfSection("Macros");
  words.erase("MC_*");  // the extensions of the driver
  EXPECT_THAT(without(known, words), IsEmpty());
  // Of these groups a host has one each, and the last ones are never defined here.
  const std::set<std::string> kElsewhere{
      "MC_OS_*",  "MC_GL_VENDOR_*",           "MC_GL_RENDERER_*", "MC_FXAA_LEVEL",
      "MC_OLD_*", "MC_ANISOTROPIC_FILTERING", "VIVECRAFT*",       "IRIS_HAS_CONNECTED_TEXTURES",
      "IS_MONOCLE", "ALLOWS_UNKNOWN_SHADERS"};
  for (const std::string& name : namesIn("Macros", "loader/pack/versions/macros.cpp")) {
    EXPECT_TRUE(known.contains(name) || matchesAny(name, kElsewhere)) << name;
  }
}

TEST(ContractMacros, features_are_those_offered) {
  std::set<std::string> words;
  for (const std::string& word : wordsOfSection("Macros")) {
    constexpr std::string_view kPrefix = "IRIS_FEATURE_";
    if (word.starts_with(kPrefix)) words.insert(word.substr(kPrefix.size()));
  }
  const Names offered = supportedFeatures();
  EXPECT_THAT(without(offered, words), IsEmpty());
  EXPECT_THAT(without(words, asSet(offered)), IsEmpty());
}

TEST(ContractMacros, colour_spaces_need_their_setting) {
  ShaderProperties properties;
  EXPECT_THAT(shaderFeatureMacros(properties), IsEmpty());
  properties.settings["supportsColorCorrection"] = "true";
  std::set<std::string> known;
  for (const auto& [name, value] : shaderFeatureMacros(properties)) known.insert(name);
  EXPECT_THAT(known, testing::ElementsAre("COLOR_SPACE_ADOBE_RGB", "COLOR_SPACE_DCI_P3",
                                          "COLOR_SPACE_DISPLAY_P3", "COLOR_SPACE_REC2020",
                                          "COLOR_SPACE_SRGB"));
}

ShaderProperties parsed(const std::string& text, Diagnostics& diagnostics) {
  return parseShaderProperties("/shaders.properties", text, {}, {}, diagnostics);
}

TEST(ContractProperties, each_key_is_read) {
  const std::set<std::string> words = wordsOfSection("Keys of shaders.properties");
  EXPECT_THAT(without(settingKeys(), words), IsEmpty());
  for (const std::string_view prefix : propertyPrefixes()) {
    EXPECT_TRUE(std::any_of(words.begin(), words.end(), [&](const std::string& word) {
      return word.starts_with(prefix);
    })) << prefix;
  }
  const std::set<std::string> settings = asSet(settingKeys());
  for (const ContractRow& row : rowsOf("Keys of shaders.properties")) {
    if (row.test != "ContractProperties.each_key_is_read") continue;
    for (const std::string& key : wordsOf(row.name)) {
      EXPECT_TRUE(settings.contains(key)) << key;
      Diagnostics diagnostics;
      const bool offers = key == "clouds" || key == "dhClouds";
      const std::string value = offers                         ? "fancy"
                                : key == "particles.ordering"  ? "mixed"
                                : key == "shadowvolume.method" ? "auto"
                                : key == "shadowvolume.lights" ? "4 1.5"
                               : key == "fallbackTex"         ? "31"
                               : key == "orris.minimum.iris"  ? "1.8"
                               : key == "orris.minimum.game"  ? "1.21.4"
                                                               : "true";
      const ShaderProperties properties = parsed(key + "=" + value + "\n", diagnostics);
      EXPECT_TRUE(diagnostics.empty()) << formatDiagnostic(diagnostics[0]);
      EXPECT_EQ(properties.settings.at(key), value);
    }
  }
}

TEST(ContractProperties, keys_of_other_hosts_are_ignored_silently) {
  Diagnostics diagnostics;
  parsed("photonics.rt.enabled = true\nversion.1.16.5 = G6\n", diagnostics);
  EXPECT_TRUE(diagnostics.empty()) << formatDiagnostic(diagnostics[0]);
}

TEST(ContractExpressions, functions_are_those_of_the_table) {
  std::set<std::string> words = wordsOfSection("Custom uniforms");
  words.insert({"/", "neg", "<", ">", "<=", ">="});
  Names known;
  for (const std::string_view name : expressionFunctionNames()) {
    if (!words.contains(std::string(name))) known.emplace_back(name);
  }
  EXPECT_THAT(known, IsEmpty());
  for (const ContractRow& row : rowsOf("Custom uniforms")) {
    if (row.test != "Expression.functions") continue;
    for (const std::string& word : wordsOf(row.name))
      EXPECT_TRUE(isExpressionFunction(word)) << word;
  }
}

TEST(ContractExpressions, functions_that_no_host_offers_are_refused) {
  for (const char* name : {"round", "lerp", "ifb", "print", "ivec2", "bvec3"})
    EXPECT_FALSE(isExpressionFunction(name)) << name;
}

TEST(ContractExpressions, constants_and_inputs) {
  Diagnostics diagnostics;
  const auto pack = loadShaderPack(
      memorySource(
          {{"/final.fsh", "#version 330 compatibility\n#define Q 3 // [1 2 3]\nvoid main() {}\n"},
           {"/shaders.properties",
            "uniform.float.a = if(true, pi, 0.0) + worldTime\n"
            "uniform.bool.b = in(biome, BIOME_PLAINS) && biome_category == CAT_PLAINS\n"
            "uniform.int.c = Q\nuniform.bool.d = biome_precipitation == PPT_RAIN\n"}}),
      {.environment = standardMacros({})}, diagnostics);
  ASSERT_TRUE(pack);
  EXPECT_TRUE(diagnostics.empty()) << formatDiagnostic(diagnostics[0]);
  EXPECT_EQ(pack->properties.customUniforms.size(), 4u);
}

}  // namespace
}  // namespace orris
