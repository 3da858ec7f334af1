#include <orris/pack/mods/mods.h>

#include <gmock/gmock.h>

#include <orris/glsl/compile/validate.h>
#include "loaded_pack.h"

namespace orris {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Loaded loadWithFinal(Files files, bool mods = true) {
  files.try_emplace("/final.fsh", kFragment);
  return loadFiles(std::move(files), {.buildModPrograms = mods});
}

std::vector<std::string> programNames(const ProgramList& programs) {
  std::vector<std::string> result;
  for (const ProgramSource& program : programs) result.push_back(program.name);
  return result;
}

/// What glslang says of the only program of a mod.
std::string verdict(const Loaded& loaded) {
  Diagnostics diagnostics = loaded.diagnostics;
  const ProgramSource& program = loaded.pack->modPrograms.at(0);
  std::vector<const StageText*> stages;
  for (const StageText& stage : program.stages) stages.push_back(&stage);
  validateWithGlslang(stages, {}, diagnostics);
  return diagnostics.empty() ? "" : formatDiagnostic(diagnostics[0]);
}

TEST(Mods, programs_of_other_mods_stand_apart_from_those_of_the_pack) {
  const Files files{{"/dh_water.vsh", kVertex},
                    {"/dh_water.fsh", kFragment},
                    {"/clrwl_shadow.vsh", kVertex},
                    {"/clrwl_shadow.fsh", kFragment}};
  const Loaded with = loadWithFinal(files);
  ASSERT_TRUE(with.pack);
  EXPECT_THAT(programNames(with.pack->programs), ElementsAre("final"));
  EXPECT_THAT(programNames(with.pack->modPrograms), ElementsAre("dh_water", "clrwl_shadow"));
  EXPECT_THAT(with.pack->modPrograms[0].drawBuffers, ElementsAre(0));
  EXPECT_THAT(with.pack->modPrograms[1].drawBuffers, ElementsAre(0, 1));
  EXPECT_THAT(programNames(loadWithFinal(files, false).pack->modPrograms), IsEmpty());
}

TEST(Mods, a_program_sees_the_macro_and_the_names_of_its_mod_only) {
  const std::string vertex =
      "#version 330 compatibility\n#if !defined DISTANT_HORIZONS || defined HAS_COLORWHEEL\n"
      "#error wrong mod\n#endif\nflat out int m;\n"
      "void main() { m = dhMaterialId; gl_Position = ftransform(); }\n";
  EXPECT_EQ(verdict(loadWithFinal({{"/dh_terrain.vsh", vertex}, {"/dh_terrain.fsh", kFragment}})),
            "");

  const std::string fragment =
      "#version 330 compatibility\n#if defined DISTANT_HORIZONS || !defined HAS_COLORWHEEL\n"
      "#error wrong mod\n#endif\nuniform sampler2D gtexture;\n"
      "void main() { vec4 c = texture(gtexture, vec2(0)), o; vec2 l; float ao;\n"
      "  clrwl_computeFragment(c, c, l, ao, o); gl_FragData[0] = c * clrwl_vertexColor + o; }\n";
  EXPECT_EQ(
      verdict(loadWithFinal({{"/clrwl_gbuffers.vsh", kVertex}, {"/clrwl_gbuffers.fsh", fragment}})),
      "");
  // The name is not given to programs of another mod.
  EXPECT_NE(
      verdict(loadWithFinal({{"/clrwl_gbuffers.vsh", vertex}, {"/clrwl_gbuffers.fsh", kFragment}})),
      "");
}

TEST(Mods, a_program_is_enabled_as_if_its_mod_were_there) {
  const std::string properties =
      "#ifdef DISTANT_HORIZONS\nprogram.dh_water.enabled = false\n#else\n"
      "program.dh_terrain.enabled = false\n#endif\n";
  const Loaded loaded = loadWithFinal({{"/dh_water.fsh", kFragment},
                                       {"/dh_terrain.fsh", kFragment},
                                       {"/shaders.properties", properties}});
  EXPECT_THAT(programNames(loaded.pack->modPrograms), ElementsAre("dh_terrain"));
}

Loaded loadVoxy(const std::string& opaque, std::map<std::string, std::string> types) {
  Loaded loaded;
  const LoadRequest request{.environment = standardMacros({}),
                            .buildModPrograms = true,
                            .uniformTypes = std::move(types)};
  // Texts over lines, directives inside and keys without quotes, as packs write it.
  const std::string interface =
      "{ \"unused\": \"\n#define far near\n\", \"blending\": {-1: \"off\"},\n"
      "  \"uniforms\": [\"far\", \"own\"\n#ifndef VOXY\n, \"unknown\"\n#endif\n],\n"
      "  \"samplers\": [\"noisetex\"], \"ssbos\": {-1: \"\",\n"
      "  \"0\": \"{vec3 a; float b;}\", 1:\"{float c;} own1\"} }\n";
  loaded.pack = loadShaderPack(memorySource({{"/final.fsh", kFragment},
                                             {"/shaders.properties", "uniform.bool.own = true\n"},
                                             {"/voxy.json", interface},
                                             {"/voxy_opaque.glsl", opaque}}),
                               request, loaded.diagnostics);
  return loaded;
}

TEST(Mods, voxy_gets_what_its_interface_file_lists) {
  const std::string opaque =
      "layout(location = 0) out vec4 color;\n"
      "void voxy_emitFragment(VoxyFragmentParameters p) {\n"
      "  color = p.sampledColour * far * float(own) * b * own1.c + texture(noisetex, p.uv);\n}\n";
  const Loaded loaded = loadVoxy(opaque, {{"far", "float"}});
  ASSERT_TRUE(loaded.pack);
  EXPECT_THAT(programNames(loaded.pack->modPrograms), ElementsAre("voxy_opaque"));
  EXPECT_EQ(verdict(loaded), "");
  const Loaded asked = loadVoxy("#if VOXY < 2\n#error an old Voxy\n#endif\n" + opaque, {{"far", "float"}});
  EXPECT_EQ(asked.diagnostics.size(), loaded.diagnostics.size());
  EXPECT_EQ(verdict(asked), "");
  const Loaded wrong =
      loadVoxy("void voxy_emitFragment(VoxyFragmentParameters p) { x = 1; }\n", {{"far", "float"}});
  EXPECT_THAT(verdict(wrong), testing::StartsWith("/voxy_opaque.glsl:1:"));
}

TEST(Mods, a_voxy_program_with_a_uniform_of_unknown_type_is_not_judged) {
  EXPECT_THAT(programNames(loadVoxy("nonsense", {}).pack->modPrograms), IsEmpty());
}

TEST(Mods, what_is_wrong_with_a_program_of_a_mod_is_a_warning_that_names_the_mod) {
  const Loaded loaded =
      loadWithFinal({{"/dh_water.fsh", "void main() {}\n"}, {"/dh_water.vsh", kVertex}});
  ASSERT_TRUE(loaded.pack);
  ASSERT_EQ(loaded.diagnostics.size(), 1u);
  EXPECT_EQ(formatDiagnostic(loaded.diagnostics[0]),
            "/dh_water.fsh:1: warning: no active #version; exactly one is required\n"
            "  note: this concerns players with Distant Horizons only\n"
            "  hint: begin the file with '#version 330 compatibility'");
}

}  // namespace
}  // namespace orris
