#include <orris/pack/shader_pack.h>

#include <gmock/gmock.h>

#include "loaded_pack.h"

namespace orris {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> names(const ShaderPack& pack) {
  std::vector<std::string> result;
  for (const ProgramSource& program : pack.programs) result.push_back(program.name);
  return result;
}

const Files kOptions{
    {"/composite.fsh",
     "#version 330 compatibility\n#define BLOOM\n#define Q 2 // [1 2 3]\n#ifdef BLOOM\n#endif\n"
     "float q = Q;\nvoid main() {}\n"},
    {"/final.fsh", kFragment},
    {"/shaders.properties",
     "profile.LOW = !BLOOM Q=1\nprofile.HIGH = BLOOM Q=3\n"
     "program.final.enabled = BLOOM\n"}};

TEST(ShaderPack, programs_come_in_frame_order) {
  const Loaded loaded = loadFiles({{"/final.fsh", kFragment},
                                   {"/composite10.fsh", kFragment},
                                   {"/composite2.fsh", kFragment},
                                   {"/gbuffers_water.fsh", kFragment},
                                   {"/gbuffers_basic.fsh", kFragment},
                                   {"/shadow.fsh", kFragment},
                                   {"/deferred.fsh", kFragment},
                                   {"/setup.csh", kFragment},
                                   {"/begin.fsh", kFragment},
                                   {"/dh_terrain.fsh", kFragment},
                                   {"/prepare.vsh", kVertex}});
  ASSERT_TRUE(loaded.pack) << loaded.first();
  EXPECT_THAT(names(*loaded.pack),
              ElementsAre("setup", "begin", "shadow", "gbuffers_basic", "gbuffers_water",
                          "deferred", "composite2", "composite10", "final"));
}

TEST(ShaderPack, a_lone_fragment_shader_gets_a_vertex_shader) {
  const Loaded loaded = loadFiles({{"/composite.fsh", kFragment}});
  ASSERT_TRUE(loaded.pack);
  const ProgramSource& program = loaded.pack->programs.at(0);
  ASSERT_EQ(program.stages.size(), 2u);
  EXPECT_EQ(program.stages[0].stage, Stage::Vertex);
  EXPECT_THAT(program.stages[0].text.text, HasSubstr("ftransform"));
}

TEST(ShaderPack, geometry_is_taken_and_tessellation_needs_its_flag) {
  Files files{{"/shadow.fsh", kFragment},
              {"/shadow.vsh", kVertex},
              {"/shadow.gsh", kFragment},
              {"/shadow.tcs", kFragment},
              {"/shadow.tes", kFragment}};
  EXPECT_EQ(loadFiles(files).pack->programs.at(0).stages.size(), 3u);
  files["/shaders.properties"] = "iris.features.optional = TESSELLATION_SHADERS\n";
  EXPECT_EQ(loadFiles(files).pack->programs.at(0).stages.size(), 5u);
}

TEST(ShaderPack, compute_suffixes_end_at_the_first_gap) {
  const char* compute =
      "#version 430\nlayout(local_size_x = 8, local_size_y = 4) in;\n"
      "const ivec3 workGroups = ivec3(2, 2, 1);\nvoid main() {}\n";
  const Loaded loaded = loadFiles(
      {{"/composite.csh", compute}, {"/composite_a.csh", compute}, {"/composite_c.csh", compute}});
  ASSERT_TRUE(loaded.pack) << loaded.first();
  const ProgramSource& program = loaded.pack->programs.at(0);
  EXPECT_TRUE(program.stages.empty());
  ASSERT_EQ(program.computes.size(), 2u);
  EXPECT_EQ(program.computes[1].name, "composite_a");
  EXPECT_EQ(program.computes[0].localSize, (std::array{8, 4, 1}));
  EXPECT_EQ(program.computes[0].directives.workGroups, (std::array{2, 2, 1}));
  EXPECT_EQ(loaded.pack->resolve("composite"), nullptr);
}

TEST(ShaderPack, resolve_follows_the_fallback_tree) {
  const Loaded loaded =
      loadFiles({{"/gbuffers_terrain.fsh", kFragment}, {"/composite.fsh", kFragment}});
  EXPECT_EQ(loaded.pack->find("gbuffers_water"), nullptr);
  EXPECT_EQ(loaded.pack->resolve("gbuffers_water")->name, "gbuffers_terrain");
  EXPECT_EQ(loaded.pack->resolve("gbuffers_skybasic"), nullptr);
}

TEST(ShaderPack, draw_buffers_default_by_group_and_follow_directives) {
  const Loaded loaded =
      loadFiles({{"/composite.fsh", "#version 330\n/* RENDERTARGETS: 3,1 */\nvoid main() {}\n"},
                 {"/composite1.fsh", kFragment},
                 {"/shadow.fsh", kFragment}});
  EXPECT_THAT(loaded.pack->find("composite")->drawBuffers, ElementsAre(3, 1));
  EXPECT_THAT(loaded.pack->find("composite1")->drawBuffers, ElementsAre(0));
  EXPECT_THAT(loaded.pack->find("shadow")->drawBuffers, ElementsAre(0, 1));
}

TEST(ShaderPack, directives_of_later_groups_win) {
  const Loaded loaded = loadFiles(
      {{"/shadowcomp.fsh", "#version 330\nconst float shadowDistance = 1.0;\nvoid main() {}\n"},
       {"/deferred.fsh", "#version 330\nconst float shadowDistance = 2.0;\nvoid main() {}\n"},
       {"/final.fsh", "#version 330\nconst float shadowDistance = 3.0;\nvoid main() {}\n"}});
  EXPECT_FLOAT_EQ(loaded.pack->directives.shadowDistance, 2);
}

TEST(ShaderPack, values_reach_the_source_and_disable_programs) {
  const Loaded loaded = loadFiles(kOptions, {.values = {{"BLOOM", "false"}, {"Q", "3"}}});
  ASSERT_TRUE(loaded.pack) << loaded.first();
  EXPECT_THAT(names(*loaded.pack), ElementsAre("composite"));
  EXPECT_THAT(loaded.pack->disabledPrograms, ElementsAre("final"));
  EXPECT_THAT(loaded.pack->programs[0].stages[1].text.text, HasSubstr("float q = 3"));
  EXPECT_THAT(loaded.pack->programs[0].options, ElementsAre("BLOOM", "Q"));
  EXPECT_EQ(loaded.pack->values, (OptionValues{{"BLOOM", "false"}, {"Q", "3"}}));
  EXPECT_EQ(loaded.pack->sourceLine("/composite.fsh", 2), "//#define BLOOM");
}

TEST(ShaderPack, profile_is_applied_before_values_and_detected) {
  const Loaded low = loadFiles(kOptions, {.profile = "LOW"});
  ASSERT_TRUE(low.pack) << low.first();
  EXPECT_EQ(low.pack->values, (OptionValues{{"BLOOM", "false"}, {"Q", "1"}}));
  EXPECT_EQ(low.pack->currentProfile(), "LOW");
  const Loaded mixed = loadFiles(kOptions, {.values = {{"Q", "2"}}, .profile = "LOW"});
  EXPECT_EQ(mixed.pack->values, (OptionValues{{"BLOOM", "false"}}));
  EXPECT_EQ(mixed.pack->currentProfile(), "");
}

TEST(ShaderPack, profile_with_the_most_values_in_force_is_the_current_one) {
  Files files = kOptions;
  files["/shaders.properties"] =
      "profile.A = BLOOM\nprofile.B = BLOOM Q=2\nprofile.C = Q=2 BLOOM\n";
  EXPECT_EQ(loadFiles(files).pack->currentProfile(), "B");
  EXPECT_EQ(loadFiles(files, {.values = {{"Q", "3"}}}).pack->currentProfile(), "A");
}

TEST(ShaderPack, file_values_come_first_and_need_not_be_listed) {
  const Loaded loaded =
      loadFiles(kOptions, {.fileValues = {{"Q", "17"}, {"GONE", "1"}, {"BLOOM", "perhaps"}}});
  ASSERT_TRUE(loaded.pack) << loaded.first();
  EXPECT_EQ(loaded.pack->values, (OptionValues{{"Q", "17"}}));
  EXPECT_EQ(loadFiles(kOptions, {.profile = "HIGH", .fileValues = {{"Q", "17"}}}).pack->values,
            (OptionValues{{"Q", "3"}}));
}

TEST(ShaderPack, wrong_requests_name_what_is_there) {
  EXPECT_EQ(loadFiles(kOptions, {.values = {{"BLOM", "true"}}}).first(),
            "error: the pack has no option BLOM\n  hint: did you mean BLOOM?");
  EXPECT_EQ(loadFiles(kOptions, {.values = {{"Q", "7"}}}).first(),
            "/composite.fsh:3:1: error: Q cannot be 7\n  hint: its values are 1, 2, 3");
  EXPECT_EQ(loadFiles(kOptions, {.profile = "LOWER"}).first(),
            "/shaders.properties: error: the pack has no profile LOWER\n  hint: did you mean LOW?");
  EXPECT_FALSE(loadFiles(kOptions, {.values = {{"Q", "7"}}}).pack);
}

TEST(ShaderPack, hash_follows_the_final_text) {
  const auto hash = [](OptionValues values) {
    return loadFiles(kOptions, {.values = std::move(values)}).pack->programs[0].hash;
  };
  EXPECT_EQ(hash({}), hash({{"Q", "2"}}));
  EXPECT_NE(hash({}), hash({{"Q", "3"}}));
}

TEST(ShaderPack, dimensions_are_chosen_by_id_or_folder) {
  const Files files{{"/composite.fsh", kFragment},
                    {"/world0/deferred.fsh", kFragment},
                    {"/world-1/final.fsh", kFragment}};
  const auto folder = [&](const std::string& dimension) {
    return loadFiles(files, {.dimension = dimension}).pack->folder;
  };
  EXPECT_EQ(folder("minecraft:overworld"), "/world0");
  EXPECT_EQ(folder("world-1"), "/world-1");
  EXPECT_EQ(folder("the_nether"), "/world-1");
  EXPECT_EQ(folder("world1"), "/world0");
  EXPECT_EQ(folder("/"), "/");
  EXPECT_THAT(loadFiles(files).pack->dimensions, ElementsAre("/world0", "/world-1"));
}

TEST(ShaderPack, include_chain_reaches_diagnostics_of_the_preprocessor) {
  const Loaded loaded =
      loadFiles({{"/composite.fsh", "#version 330\n#include \"a.glsl\"\nvoid main() {}\n"},
                 {"/a.glsl", "#include \"b.glsl\"\n"},
                 {"/b.glsl", "\n#error here\n"}});
  EXPECT_EQ(loaded.first(),
            "/b.glsl:2:1: error: #error here\n  included from /a.glsl:1\n  included from "
            "/composite.fsh:2\n"
            "  #error here\n  ^");
  EXPECT_TRUE(loaded.pack);
}

TEST(ShaderPack, exponential_includes_end_at_a_limit) {
  Files files{{"/composite.fsh", "#version 330\n#include \"l0\"\nvoid main() {}\n"},
              {"/l40", "int a;\n"}};
  for (int i = 0; i < 40; ++i) {
    const std::string next = "#include \"l" + std::to_string(i + 1) + "\"\n";
    files["/l" + std::to_string(i)] = next + next;
  }
  const Loaded loaded = loadFiles(files);
  ASSERT_FALSE(loaded.diagnostics.empty());
  EXPECT_EQ(loaded.first().substr(0, loaded.first().find('\n')),
            "/l40: error: with its includes, /composite.fsh has more than 2000000 lines, 268435456 "
            "bytes or 50000 files here");
}

TEST(ShaderPack, features_define_macros_where_the_contract_says) {
  Files files{{"/composite.fsh",
               "#version 330\n#ifdef IRIS_FEATURE_SSBO\nint optional;\n#endif\n#ifdef "
               "IRIS_FEATURE_CUSTOM_IMAGES\n"
               "int required;\n#endif\nvoid main() {}\n"},
              {"/shaders.properties",
               "iris.features.optional = SSBO\niris.features.required = CUSTOM_IMAGES\n"
               "#ifdef IRIS_FEATURE_COMPUTE_SHADERS\nsun = false\n#endif\n"}};
  const Loaded loaded = loadFiles(files);
  ASSERT_TRUE(loaded.pack) << loaded.first();
  const std::string& text = loaded.pack->programs[0].stages[1].text.text;
  EXPECT_THAT(text, HasSubstr("int optional"));
  EXPECT_THAT(text, testing::Not(HasSubstr("int required")));
  EXPECT_FALSE(loaded.pack->properties.flag("sun", true));
}

TEST(ShaderPack, a_feature_macro_is_written_as_its_line_is) {
  const Loaded loaded =
      loadFiles({{"/composite.fsh",
                  "#version 330\n#ifdef IRIS_FEATURE_ssbo\nint lower;\n#endif\n"
                  "#ifdef IRIS_FEATURE_SSBO\nint upper;\n#endif\nvoid main() {}\n"},
                 {"/shaders.properties", "iris.features.optional = ssbo\n"}});
  ASSERT_TRUE(loaded.pack);
  EXPECT_EQ(loaded.first(),
            "/shaders.properties:1:26: warning: Iris defines the macro IRIS_FEATURE_ssbo, as it is "
            "written here\n  iris.features.optional = ssbo\n                           ^\n"
            "  hint: write SSBO");
  const std::string& text = loaded.pack->programs[0].stages[1].text.text;
  EXPECT_THAT(text, HasSubstr("int lower"));
  EXPECT_THAT(text, testing::Not(HasSubstr("int upper")));
  EXPECT_TRUE(loaded.pack->properties.feature("SSBO"));
}

/// Files of a pack that Iris refuses; the first diagnostic.
struct RefusedCase {
  Files files;
  const char* first;
};

TEST(ShaderPack, what_iris_refuses_is_refused_unless_all_mistakes_are_wanted) {
  const RefusedCase kCases[] = {
      {{{"/composite.fsh", "#version 330\n/* RENDERTARGETS: 0, 1 */\nvoid main() {}\n"}},
       "/composite.fsh:2:1: error: a blank stands beside a comma of RENDERTARGETS; Iris refuses "
       "the whole pack\n  /* RENDERTARGETS: 0, 1 */\n  ^\n  hint: write /* RENDERTARGETS: 0,1 */"},
      {{{"/composite.fsh",
         "#version 330\nconst vec4 colortex0ClearColor = vec4(0.0);\nvoid main() {}\n"}},
       "/composite.fsh:2:1: error: vec4(0.0) is no clear colour; Iris refuses the whole pack\n"
       "  const vec4 colortex0ClearColor = vec4(0.0);\n  ^\n  hint: write vec4 with four numbers"},
      {{{"/composite.csh", "#version 430\nconst ivec3 workGroups = ivec3(8);\nvoid main() {}\n"}},
       "/composite.csh:2:1: error: workGroups is \"ivec3(8)\"; Iris refuses the whole pack\n"
       "  const ivec3 workGroups = ivec3(8);\n  ^\n  hint: write ivec3 with 3 numbers"},
      {{{"/composite.fsh", "\xEF\xBB\xBF#version 330\nvoid main() {}\n"}},
       "/composite.fsh:1:1: error: the file begins with a byte-order mark; Iris refuses the whole "
       "pack\n  hint: save it as UTF-8 without one (\"UTF-8\", not \"UTF-8 with BOM\")"},
      {{{"/composite.fsh", "#version 330\n#include \"/lib.glsl\"\nvoid main() {}\n"},
        {"/lib.glsl", "\xEF\xBB\xBF// settings\n"}},
       "/lib.glsl:1:1: error: the file begins with a byte-order mark; Iris refuses the whole "
       "pack\n  included from /composite.fsh:2\n"
       "  hint: save it as UTF-8 without one (\"UTF-8\", not \"UTF-8 with BOM\")"},
      {{{"/composite.fsh", kFragment},
        {"/shaders.properties", "iris.features.required = TESSELATION_SHADERS\n"}},
       "/shaders.properties:1:26: error: this host does not offer the feature TESSELATION_SHADERS; "
       "Iris refuses the whole pack\n  iris.features.required = TESSELATION_SHADERS\n"
       "                           ^\n  hint: did you mean TESSELLATION_SHADERS?"},
  };
  for (const RefusedCase& test : kCases) {
    const Loaded refused = loadFiles(test.files);
    EXPECT_FALSE(refused.pack);
    EXPECT_EQ(refused.first(), test.first);
    EXPECT_TRUE(loadFiles(test.files, {.keepGoing = true}).pack);
  }
}

TEST(ShaderPack, a_name_of_iris_is_an_error_of_its_program) {
  const Loaded loaded =
      loadFiles({{"/composite.fsh", kFragment},
                 {"/final.fsh", "#version 330\nfloat iris_fog;\nvoid main() {}\n"},
                 {"/clrwl_gbuffers.fsh", "#version 330\nfloat iris_fog;\n"}});
  ASSERT_TRUE(loaded.pack);
  ASSERT_EQ(loaded.diagnostics.size(), 1u);
  EXPECT_EQ(loaded.first(),
            "/final.fsh:2:7: error: iris_fog begins with iris_, as Iris's own names do; Iris "
            "refuses the program\n  hint: choose another name");
}

TEST(ShaderPack, options_come_from_programs_that_iris_reads) {
  const Loaded loaded =
      loadFiles({{"/composite.fsh", "#version 330\n#define A 1 // [1 2]\nvoid main() {}\n"},
                 {"/dh_terrain.fsh", "#version 330\n#define B 1 // [1 2]\nvoid main() {}\n"},
                 {"/clrwl_gbuffers.fsh", "#version 330\n#define C 1 // [1 2]\nvoid main() {}\n"}});
  ASSERT_TRUE(loaded.pack);
  EXPECT_TRUE(loaded.pack->options.find("A"));
  EXPECT_TRUE(loaded.pack->options.find("B"));
  EXPECT_FALSE(loaded.pack->options.find("C"));
}

TEST(ShaderPack, languages_and_ids_are_read) {
  const Loaded loaded =
      loadFiles({{"/composite.fsh", kFragment},
                 {"/lang/en_US.lang", "option.Q=Quality\n"},
                 {"/block.properties", "#if MC_VERSION >= 11300\nblock.3 = stone\n#endif\n"},
                 {"/item.properties", "item.4 = torch\n"}});
  EXPECT_EQ(loaded.pack->languages.at("en_us").at("option.Q"), "Quality");
  EXPECT_EQ(loaded.pack->blockIds.idOf("minecraft:stone", {}), 3);
  EXPECT_EQ(loaded.pack->itemIds.at("minecraft:torch"), 4);
}

TEST(ShaderPack, order_of_diagnostics_does_not_depend_on_threads) {
  Files files;
  for (int i = 1; i < 60; ++i) {
    files["/composite" + std::to_string(i) + ".fsh"] =
        "#version 330\n#error " + std::to_string(i) + "\nvoid main() {}\n";
  }
  const Loaded first = loadFiles(files);
  ASSERT_EQ(first.diagnostics.size(), 59u);
  EXPECT_EQ(first.diagnostics[10].message, "#error 11");
  for (int run = 0; run < 5; ++run) {
    const Loaded again = loadFiles(files);
    for (size_t i = 0; i < 59; ++i)
      EXPECT_EQ(again.diagnostics[i].message, first.diagnostics[i].message);
  }
}

TEST(ShaderPack, shadow_colours_above_the_second_need_their_flag) {
  const std::string fragment =
      "#version 330 compatibility\n/* RENDERTARGETS: 0,2 */\nvoid main() {}\n";
  const Loaded without = loadFiles({{"/shadow.fsh", fragment}});
  EXPECT_EQ(without.first(),
            "/shadow.fsh:2:1: error: shadow colours above shadowcolor1 without the feature flag "
            "HIGHER_SHADOWCOLOR; Iris refuses the whole pack\n"
            "  hint: add iris.features.required=HIGHER_SHADOWCOLOR");
  const Loaded with =
      loadFiles({{"/shadow.fsh", fragment},
                 {"/shaders.properties", "iris.features.required = HIGHER_SHADOWCOLOR\n"}});
  EXPECT_EQ(with.first(), "");
}

TEST(StandardMacros, biomes_have_the_category_of_their_macro) {
  const auto macros = standardMacros({});
  const auto valueOf = [&](const std::string& name) {
    const auto found = std::find_if(macros.begin(), macros.end(),
                                    [&](const auto& macro) { return macro.first == name; });
    return found == macros.end() ? "none" : found->second;
  };
  const std::pair<std::string, std::string> rows[] = {{"plains", "PLAINS"},
                                                      {"desert", "DESERT"},
                                                      {"snowy_taiga", "TAIGA"},
                                                      {"frozen_ocean", "OCEAN"},
                                                      {"the_void", "NONE"},
                                                      {"warped_forest", "NETHER"},
                                                      {"end_barrens", "THE_END"},
                                                      {"deep_dark", "UNDERGROUND"},
                                                      {"windswept_hills", "EXTREME_HILLS"},
                                                      {"mangrove_swamp", "SWAMP"}};
  for (const auto& [biome, category] : rows) {
    EXPECT_EQ(std::to_string(biomeCategory("minecraft:" + biome)), valueOf("CAT_" + category))
        << biome;
  }
  EXPECT_EQ(std::to_string(biomeId("desert")), valueOf("BIOME_DESERT"));
  EXPECT_EQ(biomeCategory("aether:sky"), 0);
}

TEST(StandardMacros, name_the_host) {
  const MacroDefinitions macros = standardMacros({.glVendor = "NVIDIA Corporation",
                                                  .glRenderer = "GeForce RTX",
                                                  .glExtensions = {"GL_ARB_shader_texture_lod"}});
  const auto has = [&](const char* name, const char* body) {
    return std::find(macros.begin(), macros.end(),
                     std::pair<std::string, std::string>(name, body)) != macros.end();
  };
  EXPECT_TRUE(has("MC_VERSION", "260200"));
  EXPECT_TRUE(has("MC_GL_VENDOR_NVIDIA", ""));
  EXPECT_TRUE(has("MC_GL_RENDERER_GEFORCE", ""));
  EXPECT_TRUE(has("MC_GL_ARB_shader_texture_lod", ""));
  EXPECT_TRUE(has("MC_RENDER_STAGE_TERRAIN_TRANSLUCENT", "17"));
  EXPECT_TRUE(has("CAT_UNDERGROUND", "18"));
  EXPECT_TRUE(has("BIOME_PLAINS", std::to_string(biomeId("minecraft:plains")).c_str()));
  EXPECT_EQ(biomeId("nowhere"), -1);
}

TEST(StandardMacros, mesa_has_a_macro_of_optifine_only) {
  const auto vendor = [](bool iris) {
    for (const auto& [name, body] : standardMacros({.iris = iris})) {
      if (name.starts_with("MC_GL_VENDOR_")) return name;
    }
    return std::string();
  };
  EXPECT_EQ(vendor(true), "MC_GL_VENDOR_OTHER");
  EXPECT_EQ(vendor(false), "MC_GL_VENDOR_MESA");
}

}  // namespace
}  // namespace orris
