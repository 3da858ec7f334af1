#include <orris/pack/programs/program_id.h>

#include <gtest/gtest.h>

#include <set>

namespace orris {
namespace {

TEST(ProgramId, file_name_tells_folder_program_stage_and_suffix) {
  const auto file = parseProgramFile("/world0/composite3_a.csh");
  ASSERT_TRUE(file);
  EXPECT_EQ(file->folder, "/world0");
  EXPECT_EQ(file->program, "composite3");
  EXPECT_EQ(file->group, ProgramGroup::Composite);
  EXPECT_EQ(file->index, 3);
  EXPECT_EQ(file->stage, Stage::Compute);
  EXPECT_EQ(file->computeSuffix, 'a');
}

TEST(ProgramId, numbers_go_from_1_to_99_without_zeros_in_front) {
  EXPECT_EQ(parseProgramFile("/deferred.fsh")->index, 0);
  EXPECT_EQ(parseProgramFile("/deferred1.fsh")->index, 1);
  EXPECT_EQ(parseProgramFile("/deferred99.fsh")->index, 99);
  for (const char* name :
       {"/deferred0.fsh", "/deferred01.fsh", "/deferred100.fsh", "/deferred-1.fsh",
        "/deferred+1.fsh", "/final1.fsh", "/gbuffers_water1.fsh"}) {
    EXPECT_FALSE(parseProgramFile(name)) << name;
  }
}

TEST(ProgramId, compute_shaders_belong_to_passes_that_run_them) {
  for (const char* name : {"/setup.csh", "/setup7.csh", "/begin.csh", "/shadow.csh",
                           "/shadow_b.csh", "/shadowcomp_z.csh", "/prepare.csh", "/final_a.csh"}) {
    EXPECT_TRUE(parseProgramFile(name)) << name;
  }
  for (const char* name :
       {"/gbuffers_terrain.csh", "/shadow_solid.csh", "/dh_terrain.csh", "/composite_A.csh",
        "/composite_ab.csh", "/composite_a.fsh", "/setup.fsh", "/setup_a.csh", "/setup7_c.csh"}) {
    EXPECT_FALSE(parseProgramFile(name)) << name;
  }
}

TEST(ProgramId, unknown_names_and_stages_are_no_programs) {
  for (const char* name : {"/lib/sky.glsl", "/gbuffers_unicorn.fsh", "/composite",
                           "/composite.fsh.bak", "/COMPOSITE.fsh", "", "/", "/.fsh"}) {
    EXPECT_FALSE(parseProgramFile(name)) << name;
  }
}

TEST(ProgramId, shadow_names_are_not_taken_for_shadowcomp) {
  EXPECT_EQ(parseProgramFile("/shadow.fsh")->group, ProgramGroup::Shadow);
  EXPECT_EQ(parseProgramFile("/shadowcomp2.fsh")->group, ProgramGroup::ShadowComp);
  EXPECT_EQ(parseProgramFile("/shadow_entities.tcs")->stage, Stage::TessControl);
}

TEST(ProgramId, fallbacks_lead_to_a_root) {
  EXPECT_EQ(fallbackOf("gbuffers_water"), "gbuffers_terrain");
  EXPECT_EQ(fallbackOf("gbuffers_hand_water"), "gbuffers_hand");
  EXPECT_EQ(fallbackOf("shadow_lightning"), "shadow_entities");
  EXPECT_EQ(fallbackOf("composite"), "");
  for (const GeometryProgram& program : geometryPrograms()) {
    std::set<std::string_view> seen;
    for (std::string_view name = program.name; !name.empty(); name = fallbackOf(name)) {
      EXPECT_TRUE(seen.insert(name).second) << program.name;
    }
  }
}

TEST(ProgramId, fullscreen_groups_draw_a_quad) {
  EXPECT_TRUE(isFullscreen(ProgramGroup::Final));
  EXPECT_TRUE(isFullscreen(ProgramGroup::ShadowComp));
  EXPECT_FALSE(isFullscreen(ProgramGroup::Setup));
  EXPECT_FALSE(isFullscreen(ProgramGroup::Shadow));
}

}  // namespace
}  // namespace orris
