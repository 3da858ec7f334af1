#include <orris/pack/properties/shader_properties.h>

#include <gmock/gmock.h>

#include <orris/pack/expressions/boolean_expression.h>

namespace orris {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

OptionSet switchesAndQ() {
  OptionSet options;
  for (const char* name : {"BLOOM", "FOG", "SSAO"}) {
    options.all()[name] = {
        .name = name, .isBoolean = true, .defaultValue = "true", .values = {"true", "false"}};
  }
  options.all()["Q"] = {.name = "Q", .defaultValue = "2", .values = {"1", "2", "3"}};
  return options;
}

/// BLOOM is on, FOG and SSAO are off, Q is 2.
ShaderProperties parseValid(const std::string& text) {
  Diagnostics diagnostics;
  ShaderProperties properties = parseShaderProperties(
      "/shaders.properties", text, {{"BLOOM", "1"}, {"Q", "2"}}, switchesAndQ(), diagnostics);
  EXPECT_THAT(diagnostics, IsEmpty()) << formatDiagnostic(diagnostics[0]);
  return properties;
}

TEST(ShaderProperties, programs_are_enabled_by_conditions) {
  const auto enabled =
      parseValid(
          "program.world0/composite.enabled = BLOOM\nprogram.composite1.enabled = !BLOOM\n"
          "program.composite2.enabled = FOG\nprogram.composite3.enabled = FOG || BLOOM && !FOG\n"
          "program.composite4_a.enabled = unknown\nprogram.composite5.enabled = "
          "(FOG||SSAO)&&BLOOM\n")
          .programEnabled;
  EXPECT_EQ(enabled, (std::map<std::string, bool>{{"world0/composite", true},
                                                  {"composite1", false},
                                                  {"composite2", false},
                                                  {"composite3", true},
                                                  {"composite4_a", true},
                                                  {"composite5", false}}));
}

TEST(ShaderProperties, typed_keys) {
  const ShaderProperties p = parseValid(
      "alphaTest.gbuffers_water = GREATER 0.25\nalphaTest.gbuffers_clouds = off\n"
      "blend.gbuffers_water = SRC_ALPHA ONE ZERO ONE\nblend.gbuffers_water.gaux1 = off\n"
      "flip.composite.gcolor = false\nflip.composite_pre.colortex2 = true\nscale.composite = 0.5 "
      "0.25 0.25\n"
      "size.buffer.colortex7 = 0.5 128\nindirect.composite_a = 2 16\n");
  EXPECT_EQ(p.alphaTest.at("gbuffers_water").function, "GREATER");
  EXPECT_FLOAT_EQ(p.alphaTest.at("gbuffers_water").reference, 0.25f);
  EXPECT_TRUE(p.alphaTest.at("gbuffers_clouds").off);
  EXPECT_THAT(p.blend.at("gbuffers_water").factors, ElementsAre("SRC_ALPHA", "ONE", "ZERO", "ONE"));
  EXPECT_TRUE(p.bufferBlend.at("gbuffers_water").at("colortex4").off);
  EXPECT_FALSE(p.flip.at("composite").at("colortex0"));
  EXPECT_TRUE(p.flip.at("composite_pre").at("colortex2"));
  EXPECT_EQ(p.scale.at("composite"), (std::array{0.5f, 0.25f, 0.25f}));
  EXPECT_EQ(p.bufferSize.at("colortex7").size, (std::array{0.5f, 128.0f}));
  EXPECT_EQ(p.bufferSize.at("colortex7").relative, (std::array{true, false}));
  EXPECT_EQ(p.indirect.at("composite_a"), std::pair(2, 16LL));
}

TEST(ShaderProperties, legacy_buffer_name_wins_in_either_order) {
  for (const char* text : {"size.buffer.gaux1 = 1 1\nsize.buffer.colortex4 = 2 2\n",
                           "size.buffer.colortex4 = 2 2\nsize.buffer.gaux1 = 1 1\n"}) {
    EXPECT_FLOAT_EQ(parseValid(text).bufferSize.at("colortex4").size[0], 1);
  }
}

TEST(ShaderProperties, names_of_newer_versions_of_iris) {
  const ShaderProperties p = parseValid(
      "iris.features.required = SSBO CUSTOM_IMAGES TEXTURE_FILTERING FADE_VARIABLE\n"
      "bufferObject.12 = 64\nshadow.culling = safe_zone\nbreaksAnisotropy = true\n"
      "fallbackTex = 16\nsize.buffer.colortex31 = 0.5 0.5\nflip.composite.colortex16 = true\n"
      "blend.composite.colortex16 = off\n"
      "image.light = none RGB R11F_G11F_B10F UNSIGNED_INT_10F_11F_11F_REV true false 8 8\n"
      "image.sky = none RGB RGB9_E5 UNSIGNED_INT_5_9_9_9_REV true false 8 8\n");
  EXPECT_EQ(p.bufferObjects.at(0).index, 12);
  EXPECT_EQ(p.settings.at("shadow.culling"), "safe_zone");
  EXPECT_EQ(p.settings.at("breaksAnisotropy"), "true");
  EXPECT_EQ(p.settings.at("fallbackTex"), "16");
  EXPECT_TRUE(p.bufferSize.contains("colortex31"));
  EXPECT_EQ(p.images.size(), 2u);
}

TEST(ShaderProperties, a_pack_states_its_oldest_versions) {
  EXPECT_FALSE(statedMinimum(parseValid("clouds = off\n")));
  const ShaderProperties both =
      parseValid("orris.minimum.iris = 1.8\norris.minimum.game = 1.21.4\n");
  EXPECT_EQ(statedMinimum(both), (HostVersions{{1, 8, 0}, {1, 21, 4}}));
  EXPECT_EQ(statedMinimum(parseValid("orris.minimum.game = 1.20.1\n")),
            (HostVersions{{1, 7, 6}, {1, 20, 1}}));
  Diagnostics diagnostics;
  const ShaderProperties bad = parseShaderProperties(
      "/shaders.properties", "orris.minimum.iris = soon\nfallbackTex = 32\n", {}, {}, diagnostics);
  ASSERT_EQ(diagnostics.size(), 2u);
  EXPECT_EQ(diagnostics[0].message,
            "orris.minimum.iris: \"soon\" is no version of Iris, which look like 1.10.5");
  EXPECT_EQ(diagnostics[1].message, "fallbackTex is \"32\", expected 0 to 31");
  EXPECT_FALSE(statedMinimum(bad));
}

TEST(ShaderProperties, textures_images_and_buffers) {
  const ShaderProperties p = parseValid(
      "iris.features.required = ssbo\niris.features.optional = CUSTOM_IMAGES\n"
      "texture.noise = tex/noise.png\ntexture.deferred.colortex6.1 = /tex/a.dat texture_3d r8 4 5 "
      "6 red unsigned_byte\n"
      "customTexture.atlas = minecraft:textures/atlas/blocks.png\n"
      "image.vox = voxTex RED_INTEGER R32UI UNSIGNED_INT true false 16 8 4\n"
      "image.half = none RGBA RGBA8 UNSIGNED_BYTE false true 0.5 0.5\n"
      "bufferObject.1 = 64 true 0.5 1\nbufferObject.2 = 0\nbufferObject.3 = 8 data.bin\n"
      "bufferObject.4 = 8 false 0 0\n");
  ASSERT_EQ(p.textures.size(), 3u);
  EXPECT_EQ(p.textures[0].sampler, "noisetex");
  EXPECT_EQ(p.textures[0].path, "/tex/noise.png");
  EXPECT_EQ(p.textures[1].stage, "deferred");
  EXPECT_EQ(p.textures[1].sampler, "colortex6");
  EXPECT_EQ(p.textures[1].rawType, "TEXTURE_3D");
  EXPECT_EQ(p.textures[1].size, (std::array{4, 5, 6}));
  EXPECT_EQ(p.textures[2].path, "minecraft:textures/atlas/blocks.png");
  ASSERT_EQ(p.images.size(), 2u);
  EXPECT_EQ(p.images[0].dimensions, 3);
  EXPECT_TRUE(p.images[0].clear);
  EXPECT_EQ(p.images[1].sampler, "");
  EXPECT_TRUE(p.images[1].relative);
  EXPECT_FLOAT_EQ(p.images[1].size[1], 0.5f);
  ASSERT_EQ(p.bufferObjects.size(), 3u);
  EXPECT_FALSE(p.bufferObjects[2].relative);
  EXPECT_TRUE(p.bufferObjects[0].relative);
  EXPECT_EQ(p.bufferObjects[1].file, "/data.bin");
  EXPECT_TRUE(p.feature("SSBO"));
  EXPECT_TRUE(p.feature("CUSTOM_IMAGES"));
  EXPECT_FALSE(p.feature("TESSELLATION_SHADERS"));
}

TEST(ShaderProperties, settings) {
  const ShaderProperties p = parseValid(
      "sun = false\nclouds = off\nseparateAo=1\nparticles.ordering = MIXED\nother.mod = 3\n");
  EXPECT_FALSE(p.flag("sun", true));
  EXPECT_TRUE(p.flag("moon", true));
  EXPECT_TRUE(p.flag("separateAo", false));
  EXPECT_EQ(p.settings.at("clouds"), "off");
  EXPECT_EQ(p.settings.at("particles.ordering"), "mixed");
  EXPECT_FALSE(p.settings.contains("other.mod"));
}

TEST(ShaderProperties, conditionals_rule_all_keys_but_those_of_the_option_screens) {
  const ShaderProperties p = parseValid(
      "#if Q > 2\nsun = false\nscreen = BLOOM\n#else\nmoon = false\nscreen.A = FOG\n#endif\n");
  EXPECT_TRUE(p.flag("sun", true));
  EXPECT_FALSE(p.flag("moon", true));
  ASSERT_EQ(p.screens.size(), 2u);
  EXPECT_THAT(p.screens[0].entries, ElementsAre("BLOOM"));
}

TEST(ShaderProperties, screens_and_sliders) {
  const ShaderProperties p = parseValid(
      "screen = <profile> <empty> [A] *\nscreen.columns = 3\nscreen.A = BLOOM \\\n  "
      "Q\nscreen.A.columns=1\nsliders = Q\n");
  ASSERT_EQ(p.screens.size(), 2u);
  EXPECT_EQ(p.screens[0].name, "");
  EXPECT_EQ(p.screens[0].columns, 3);
  EXPECT_THAT(p.screens[1].entries, ElementsAre("BLOOM", "Q"));
  EXPECT_EQ(p.screens[1].columns, 1);
  EXPECT_THAT(p.sliders, ElementsAre("Q"));
}

TEST(ShaderProperties, profiles_inherit_and_later_items_override) {
  const auto profiles = parseValid(
                            "profile.LOW = !BLOOM Q=1 !program.composite4\nprofile.HIGH = "
                            "profile.LOW BLOOM Q:3 !FOG\n")
                            .profiles;
  ASSERT_EQ(profiles.size(), 2u);
  EXPECT_EQ(profiles[0].values, (OptionValues{{"BLOOM", "false"}, {"Q", "1"}}));
  EXPECT_EQ(profiles[1].values, (OptionValues{{"BLOOM", "true"}, {"FOG", "false"}, {"Q", "3"}}));
  EXPECT_THAT(profiles[1].disabledPrograms, ElementsAre("composite4"));
}

TEST(ShaderProperties, first_definition_of_a_custom_uniform_is_kept) {
  Diagnostics diagnostics;
  const auto p = parseShaderProperties(
      "/p", "uniform.float.a = 1\nvariable.int.b = 2\nuniform.int.a = 3\n", {}, {}, diagnostics);
  ASSERT_EQ(p.customUniforms.size(), 2u);
  EXPECT_EQ(p.customUniforms[0].expression, "1");
  EXPECT_TRUE(p.customUniforms[0].uploaded);
  EXPECT_FALSE(p.customUniforms[1].uploaded);
  ASSERT_EQ(diagnostics.size(), 1u);
  EXPECT_EQ(diagnostics[0].message, "a is already defined in line 1; Iris ignores this line");
}

TEST(ShaderProperties, option_names_become_their_values) {
  EXPECT_EQ(parseValid("uniform.float.a = Q + BLOOM\n").customUniforms[0].expression, "2 + 1");
}

struct LineCase {
  const char* line;
  Effect effect;
};

// Iris: ShaderProperties, whose readers split values at single blanks.
TEST(ShaderProperties, what_the_game_does_about_a_line) {
  using enum Effect;
  const LineCase kCases[] = {
      {"blend.gbuffers_water = SRC_ALPHA ONE ZERO ONE", Unstated},
      {"blend.gbuffers_water = SRC_ALPHA  ONE ZERO ONE", RefusesPack},
      {"blend.gbuffers_water = SRC_ALPHA\tONE ZERO ONE", RefusesPack},
      {"blend.gbuffers_water = SRC_ALPHA ONE ZERO", RefusesPack},
      {"blend.gbuffers_water = src_alpha ONE ZERO ONE", RefusesPack},
      {"blend.gbuffers_water = SRC_ALPHA ONE ZERO ONE ONE", Unstated},
      {"blend.gbuffers_water.foo = off", RefusesPack},
      {"blend.gbuffers_water.colortexA = off", RefusesPack},
      {"blend.gbuffers_water.colortex1 = SRC_ALPHA  ONE ZERO ONE", RefusesPack},
      {"alphaTest.gbuffers_water = GREATER 0.5", Unstated},
      {"alphaTest.gbuffers_water = GREATER 0.5 more", Unstated},
      {"alphaTest.gbuffers_water = GL_ALWAYS 0.5", Unstated},
      {"alphaTest.gbuffers_water = GREATER  0.5", IgnoresLine},
      {"alphaTest.gbuffers_water = greater 0.5", IgnoresLine},
      {"alphaTest.gbuffers_water = GL_GREATER 0.5", IgnoresLine},
      {"alphaTest.gbuffers_water = GREATER", IgnoresLine},
      {"scale.composite = 0.5 0.25 0.25 1", Unstated},
      {"scale.composite = 0.5  0.25 0.25", IgnoresLine},
      {"scale.composite = 0.5 0.25", IgnoresLine},
      {"size.buffer.colortex1 = 0.5 128", Unstated},
      {"size.buffer.colortex1 = 0.5  128", IgnoresLine},
      {"size.buffer.colortex1 = a b", RefusesPack},
      {"size.buffer.nothing = a b", RefusesPack},
      {"size.buffer.colortex1 = 0.5 128f", RefusesPack},
      {"flip.composite.colortex1 = true", Unstated},
      {"flip.composite.colortex1 = yes", IgnoresLine},
      {"flip.composite = true", RefusesPack},
      {"program.composite = BLOOM", RefusesPack},
      {"indirect.composite = 1 16 3", Unstated},
      {"indirect.composite = 1", IgnoresLine},
      {"texture.composite = a.png", RefusesPack},
      {"texture.sky.a = a.png", IgnoresLine},
      {"texture.composite.a = a.dat TEXTURE_2D R8 4 4 RED UNSIGNED_BYTE", Unstated},
      {"texture.composite.a = a.dat TEXTURE_2D R8 4 x RED UNSIGNED_BYTE", RefusesPack},
      {"texture.composite.a = a.dat TEXTURE_2D R9 4 4 RED UNSIGNED_BYTE", RefusesPack},
      {"texture.composite.a = a.dat  TEXTURE_2D R8 4 4 RED UNSIGNED_BYTE", RefusesPack},
      {"texture.composite.a = a.dat TEXTURE_2D R8", IgnoresLine},
      {"image.a = none RED R8", RefusesPack},
      {"image.a = none RED R8 UNSIGNED_BYTE false false", IgnoresLine},
      {"image.a = none RED R8 UNSIGNED_BYTE false true 1", RefusesPack},
      {"image.a = none RED R8 UNSIGNED_BYTE false true 1 x", RefusesPack},
      {"image.a = none RED R8 UNSIGNED_BYTE false false 8 8 8 8", IgnoresLine},
      {"bufferObject.0 = 16 true 1", IgnoresLine},
      {"clouds = Off", IgnoresLine},
      {"particles.ordering = Mixed", Unstated},
      {"sun = yes", IgnoresLine},
  };
  for (const LineCase& test : kCases) {
    Diagnostics diagnostics;
    parseShaderProperties("/shaders.properties", test.line, {}, switchesAndQ(), diagnostics);
    const auto stated =
        std::ranges::find_if(diagnostics, [](const Diagnostic& d) { return d.effect != Unstated; });
    EXPECT_EQ(stated == diagnostics.end() ? Unstated : stated->effect, test.effect) << test.line;
    EXPECT_TRUE(test.effect != RefusesPack || hasErrors(diagnostics)) << test.line;
  }
}

TEST(ShaderProperties, words_of_the_weather_other_than_true_are_false) {
  Diagnostics diagnostics;
  const auto weather = [&](const char* value) {
    return parseShaderProperties("/shaders.properties", std::string("weather = ") + value, {}, {},
                                 diagnostics)
        .settings.at("weather");
  };
  EXPECT_EQ(weather("true false"), "true false");
  EXPECT_TRUE(diagnostics.empty());
  EXPECT_EQ(weather("1"), "false");
  EXPECT_EQ(diagnostics.size(), 1u);
}

TEST(ShaderProperties, textures_may_lie_beside_the_shaders_folder) {
  const ShaderProperties p = parseValid(
      "texture.noise = ../assets/noise.png\ncustomTexture.a = /../shaders/tex/a.png\n"
      "bufferObject.0 = 16 ../data.bin\n");
  EXPECT_EQ(p.textures[0].path, "/../assets/noise.png");
  EXPECT_EQ(p.textures[1].path, "/tex/a.png");
  EXPECT_EQ(p.bufferObjects[0].file, "/../data.bin");
}

TEST(BooleanExpression, and_goes_before_or) {
  const auto value = [](std::string_view text) {
    return evaluateCondition(text, [](std::string_view name) { return name != "no"; });
  };
  EXPECT_EQ(value("yes || no && no"), true);
  EXPECT_EQ(value("(yes || no) && no"), false);
  EXPECT_EQ(value("!!yes&&1"), true);
  EXPECT_EQ(value("yes & no"), false);
  EXPECT_EQ(value("no | yes"), true);
  EXPECT_EQ(value("yes &no"), true);  // "o" is no option, and those are on
  EXPECT_EQ(value(""), std::nullopt);
  EXPECT_EQ(value("yes no"), std::nullopt);
  EXPECT_EQ(value("A == 2"), std::nullopt);
  EXPECT_EQ(value(std::string(1000, '(')), std::nullopt);
}

}  // namespace
}  // namespace orris
