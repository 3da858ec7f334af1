#include <orris/plan/schedule/schedule.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include <orris/core/files/file_source.h>
#include <orris/plan/schedule/program_uses.h>
#include "support/memory_pack.h"

namespace orris {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

const std::string kVertex =
    "#version 330 compatibility\nvoid main() { gl_Position = ftransform(); }\n";

/// A fragment stage that reads `reads` and draws to `targets`.
std::string fragment(const std::vector<std::string>& reads, const std::string& targets,
                     const std::string& more = "") {
  std::string text = "#version 330 compatibility\n";
  if (!targets.empty()) text += "/* RENDERTARGETS: " + targets + " */\n";
  for (const std::string& name : reads) text += "uniform sampler2D " + name + ";\n";
  text += more + "\nvoid main() {\n  vec4 c = vec4(0.0);\n";
  for (const std::string& name : reads) text += "  c += texture2D(" + name + ", vec2(0.5));\n";
  return text + "  gl_FragData[0] = c;\n}\n";
}

void add(Files& files, const std::string& program, const std::string& text) {
  files["/" + program + ".vsh"] = kVertex;
  files["/" + program + ".fsh"] = text;
}

Schedule scheduleOf(const ShaderPack& pack, const SceneContents& scene = {}) {
  Diagnostics diagnostics;
  Schedule schedule = buildSchedule(pack, 64, 32, scene, diagnostics);
  for (const Diagnostic& d : diagnostics) ADD_FAILURE() << formatDiagnostic(d);
  return schedule;
}

std::vector<std::string> stepNames(const Schedule& schedule) {
  std::vector<std::string> names;
  for (const Step& step : schedule.frame) names.push_back(step.name);
  return names;
}

std::vector<int> targets(const std::vector<TargetPlan>& plans) {
  std::vector<int> indices;
  for (const TargetPlan& plan : plans) indices.push_back(plan.index);
  return indices;
}

const Step& stepNamed(const Schedule& schedule, const std::string& name) {
  const auto it = std::find_if(schedule.frame.begin(), schedule.frame.end(),
                               [&](const Step& s) { return s.name == name; });
  EXPECT_NE(it, schedule.frame.end()) << name;
  return *it;
}

TEST(Schedule, steps_follow_the_order_of_the_contract) {
  Files files;
  for (const char* name : {"begin", "prepare", "deferred", "composite", "composite2"})
    add(files, name, fragment({"colortex0"}, "0"));
  add(files, "shadow", fragment({"gtexture"}, ""));
  add(files, "shadowcomp", fragment({"shadowcolor0"}, "0"));
  add(files, "gbuffers_textured", fragment({"gtexture"}, "0"));
  add(files, "final", fragment({"colortex0", "shadowtex1", "depthtex1", "depthtex2"}, ""));
  EXPECT_THAT(
      stepNames(scheduleOf(loadClean(files))),
      ElementsAre("clear_images", "clear_color", "begin", "clear_shadow", "shadow_solid",
                  "shadow_cutout", "shadow_block", "copy_shadowtex1", "shadow_water",
                  "shadow_mipmaps", "shadowcomp", "prepare", "gbuffers_skybasic",
                  "gbuffers_skybasic", "gbuffers_skytextured", "gbuffers_terrain_solid",
                  "gbuffers_terrain_cutout", "gbuffers_block", "copy_depthtex2", "copy_depthtex1",
                  "deferred", "gbuffers_water", "composite", "composite2", "final"));
}

TEST(Schedule, fullscreen_programs_flip_what_they_draw) {
  Files files;
  add(files, "composite", fragment({"colortex0"}, "0,3"));
  add(files, "composite1", fragment({"colortex0"}, "0"));
  add(files, "final", fragment({"colortex0", "colortex3"}, ""));
  const Schedule schedule = scheduleOf(loadClean(files));
  EXPECT_EQ(stepNamed(schedule, "composite").flipped, 0u);
  EXPECT_TRUE(stepNamed(schedule, "composite").writesAlt(0));
  EXPECT_EQ(stepNamed(schedule, "composite1").flipped, 0b1001u);
  EXPECT_FALSE(stepNamed(schedule, "composite1").writesAlt(0));
  EXPECT_EQ(stepNamed(schedule, "final").flipped, 0b1000u);
  EXPECT_EQ(schedule.finalFlipped, 0b1000u);
}

TEST(Schedule, flip_properties_override_and_pre_flips_come_first) {
  Files files;
  files["/shaders.properties"] =
      "flip.composite.colortex0=false\nflip.composite.colortex5=true\nflip.composite_pre.colortex2="
      "true\n";
  add(files, "composite", fragment({"colortex0", "colortex2", "colortex5"}, "0"));
  add(files, "final", fragment({"colortex0", "colortex5"}, ""));
  const Schedule schedule = scheduleOf(loadClean(files));
  EXPECT_EQ(stepNamed(schedule, "composite").flipped, 0b000100u);
  EXPECT_EQ(stepNamed(schedule, "final").flipped, 0b100100u);
}

TEST(Schedule, gbuffers_write_the_side_they_read) {
  Files files;
  add(files, "deferred", fragment({"colortex0"}, "0"));
  add(files, "gbuffers_textured", fragment({"gtexture"}, "0"));
  add(files, "final", fragment({"colortex0"}, ""));
  const Schedule schedule = scheduleOf(loadClean(files));
  EXPECT_FALSE(stepNamed(schedule, "gbuffers_terrain_solid").writesAlt(0));
  EXPECT_TRUE(stepNamed(schedule, "gbuffers_water").writesAlt(0));
}

TEST(Schedule, only_buffers_that_some_program_touches_exist) {
  Files files;
  add(files, "gbuffers_textured", fragment({"gtexture"}, "2"));
  add(files, "composite", fragment({"gnormal", "gaux4"}, "0"));
  add(files, "final", fragment({"colortex0"}, ""));
  const Schedule schedule = scheduleOf(loadClean(files));
  EXPECT_THAT(targets(schedule.colortex), ElementsAre(0, 2, 7));
  EXPECT_TRUE(schedule.target(false, 0)->needsAlt);
  EXPECT_FALSE(schedule.target(false, 2)->needsAlt);
  EXPECT_EQ(schedule.shadowResolution, 0);
  EXPECT_FALSE(schedule.depthtex1);
}

TEST(Schedule, a_declaration_that_nothing_uses_allocates_nothing) {
  Files files;
  add(files, "final",
      fragment({"colortex0"}, "", "uniform sampler2D shadowtex0;\nuniform sampler2D colortex9;"));
  add(files, "shadow", fragment({"gtexture"}, ""));
  const Schedule schedule = scheduleOf(loadClean(files));
  EXPECT_THAT(targets(schedule.colortex), ElementsAre(0));
  EXPECT_EQ(schedule.shadowResolution, 0);
  EXPECT_THAT(schedule.shadowcolor, IsEmpty());
  for (int program : schedule.programs) EXPECT_NE(loadClean(files).programs[program].name, "shadow");
}

TEST(Schedule, unread_shadow_colours_are_not_allocated) {
  Files files;
  add(files, "shadow", fragment({"gtexture"}, ""));
  add(files, "final", fragment({"colortex0", "shadowtex0"}, ""));
  EXPECT_THAT(scheduleOf(loadClean(files)).shadowcolor, IsEmpty());
  add(files, "final", fragment({"colortex0", "shadowtex0", "shadowcolor0"}, ""));
  EXPECT_THAT(targets(scheduleOf(loadClean(files)).shadowcolor), ElementsAre(0));
}

TEST(Schedule, programs_without_geometry_are_not_compiled) {
  Files files;
  add(files, "gbuffers_water", fragment({"gtexture"}, "0"));
  add(files, "gbuffers_entities", fragment({"gtexture"}, "0"));
  add(files, "final", fragment({"colortex0"}, ""));
  const ShaderPack pack = loadClean(files);
  const Schedule schedule = scheduleOf(pack, {.translucent = false});
  std::vector<std::string> names;
  for (int program : schedule.programs) names.push_back(pack.programs[program].name);
  EXPECT_THAT(names, ElementsAre("final"));
}

TEST(Schedule, uncleared_buffers_that_end_on_alt_keep_their_history) {
  Files files;
  add(files, "composite", fragment({"colortex4"}, "0,4", "const bool colortex4Clear = false;"));
  add(files, "final", fragment({"colortex0"}, ""));
  const Schedule schedule = scheduleOf(loadClean(files));
  EXPECT_TRUE(schedule.target(false, 4)->history);
  EXPECT_FALSE(schedule.target(false, 0)->history);
}

TEST(Schedule, sizes_formats_and_clears_come_from_directives) {
  Files files;
  files["/shaders.properties"] = "size.buffer.colortex5=0.5 0.25\nsize.buffer.gaux3=100 7\n";
  add(files, "composite", fragment({"colortex5", "colortex6"}, "1", R"(
/*
const int colortex5Format = R11F_G11F_B10F;
const vec4 colortex5ClearColor = vec4(0.1, 0.2, 0.3, 0.4);
*/)"));
  add(files, "final", fragment({"colortex0", "colortex1"}, ""));
  const Schedule schedule = scheduleOf(loadClean(files));
  const TargetPlan& five = *schedule.target(false, 5);
  EXPECT_EQ(five.format, "R11F_G11F_B10F");
  EXPECT_EQ(five.width, 32);
  EXPECT_EQ(five.height, 8);
  EXPECT_FLOAT_EQ(five.clearColor[2], 0.3f);
  EXPECT_EQ(schedule.target(false, 6)->width, 100);
  EXPECT_TRUE(schedule.target(false, 0)->clearToFog);
  EXPECT_FLOAT_EQ(schedule.target(false, 1)->clearColor[3], 1);
}

TEST(Schedule, draw_buffers_of_unequal_size_are_reported_at_the_directive) {
  Files files;
  files["/shaders.properties"] = "size.buffer.colortex5=0.5 0.5\n";
  add(files, "composite", fragment({"colortex0"}, "0,5"));
  add(files, "final", fragment({"colortex0"}, ""));
  const ShaderPack pack = loadClean(files);
  Diagnostics diagnostics;
  buildSchedule(pack, 64, 32, {}, diagnostics);
  ASSERT_EQ(diagnostics.size(), 1u);
  EXPECT_EQ(diagnostics[0].message,
            "composite draws to colortex5 of 32x16, but colortex0 of the same program is 64x32");
  EXPECT_EQ(diagnostics[0].at.file, "/composite.fsh");
  EXPECT_EQ(diagnostics[0].at.line, 2);
}

TEST(Schedule, a_small_buffer_of_a_gbuffers_program_is_a_warning) {
  Files files;
  files["/shaders.properties"] = "size.buffer.colortex5=0.5 0.5\n";
  add(files, "gbuffers_skybasic", fragment({}, "5"));
  add(files, "final", fragment({"colortex5"}, ""));
  const ShaderPack pack = loadClean(files);
  Diagnostics diagnostics;
  buildSchedule(pack, 64, 32, {}, diagnostics);
  removeDuplicates(diagnostics);  // the sky and the stars
  ASSERT_EQ(diagnostics.size(), 1u);
  EXPECT_EQ(diagnostics[0].severity, Severity::Warning);
  EXPECT_EQ(diagnostics[0].message,
            "gbuffers_skybasic draws to colortex5 of 32x16, but a gbuffers program covers the "
            "window: the rest of its picture is lost");
}

TEST(Schedule, an_empty_gbuffers_program_may_have_a_small_buffer) {
  Files files;
  files["/shaders.properties"] = "size.buffer.colortex5=0.5 0.5\n";
  add(files, "gbuffers_skybasic",
      "#version 330 compatibility\n/* RENDERTARGETS: 5,0 */\nvoid main() {}\n");
  add(files, "final", fragment({"colortex5"}, ""));
  const ShaderPack pack = loadClean(files);
  Diagnostics diagnostics;
  buildSchedule(pack, 64, 32, {}, diagnostics);
  EXPECT_THAT(diagnostics, IsEmpty());
}

TEST(Schedule, a_pack_without_final_copies_colortex0) {
  Files files;
  add(files, "gbuffers_textured", fragment({"gtexture"}, "0"));
  const Schedule schedule = scheduleOf(loadClean(files));
  EXPECT_EQ(schedule.frame.back().kind, Step::Kind::Present);
  EXPECT_EQ(schedule.frame.back().program, -1);
}

TEST(Schedule, block_entities_are_drawn_where_there_are_some) {
  Files files;
  add(files, "gbuffers_terrain", fragment({}, "0"));
  add(files, "gbuffers_block", fragment({}, "0"));
  add(files, "final", fragment({"shadowtex0"}, ""));
  add(files, "shadow", fragment({}, "0"));
  const auto count = [](const Schedule& schedule, const std::string& name) {
    const auto names = stepNames(schedule);
    return std::count(names.begin(), names.end(), name);
  };
  const ShaderPack pack = loadClean(files);
  const Schedule with = scheduleOf(pack), without = scheduleOf(pack, {.blockEntities = false});
  EXPECT_EQ(count(with, "gbuffers_block"), 1);
  EXPECT_EQ(count(with, "shadow_block"), 1);
  EXPECT_EQ(count(without, "gbuffers_block") + count(without, "shadow_block"), 0);
  EXPECT_FALSE(without.programs.contains(pack.programs.indexOf(pack.find("gbuffers_block"))));
  files["/shaders.properties"] = "shadowBlockEntities=false\n";
  EXPECT_EQ(count(scheduleOf(loadClean(files)), "shadow_block"), 0);
}

TEST(Schedule, clouds_follow_the_pack_then_the_world) {
  struct Case {
    std::string properties;
    Clouds world;
    bool plane;
    std::optional<Geometry> drawn;
  };
  const Case cases[] = {{"", Clouds::Off, true, {}},
                        {"", Clouds::Fast, true, Geometry::CloudsFast},
                        {"", Clouds::Fancy, true, Geometry::CloudsFancy},
                        {"", Clouds::Fancy, false, {}},
                        {"clouds=off", Clouds::Fancy, true, {}},
                        {"clouds=fast", Clouds::Fancy, true, Geometry::CloudsFast},
                        {"clouds=fancy", Clouds::Off, true, Geometry::CloudsFancy}};
  for (const Case& c : cases) {
    Files files{{"/shaders.properties", c.properties + "\n"}};
    add(files, "gbuffers_clouds", fragment({}, "0"));
    add(files, "final", fragment({"colortex0"}, ""));
    const ShaderPack pack = loadClean(files);
    const Schedule schedule = scheduleOf(pack, {.cloudPlane = c.plane, .clouds = c.world});
    std::optional<Geometry> drawn;
    for (const Step& step : schedule.frame)
      if (step.name == "gbuffers_clouds") drawn = step.geometry;
    EXPECT_EQ(drawn, c.drawn) << c.properties;
    EXPECT_EQ(schedule.programs.contains(pack.programs.indexOf(pack.find("gbuffers_clouds"))),
              c.drawn.has_value());
  }
}

TEST(Schedule, shadow_enabled_forces_or_forbids_the_pass) {
  Files files;
  add(files, "shadow", fragment({"gtexture"}, ""));
  add(files, "final", fragment({"colortex0"}, ""));
  files["/shaders.properties"] = "shadow.enabled=true\n";
  EXPECT_GT(scheduleOf(loadClean(files)).shadowResolution, 0);
  add(files, "final", fragment({"colortex0", "shadowtex0"}, ""));
  files["/shaders.properties"] = "shadow.enabled=false\n";
  for (const Step& step : scheduleOf(loadClean(files)).frame)
    EXPECT_NE(step.kind, Step::Kind::DrawShadow);
}

TEST(ProgramUses, buffer_names_and_their_legacy_names) {
  EXPECT_EQ(parseBufferName("gaux4", false)->index, 7);
  EXPECT_EQ(parseBufferName("shadow", false)->index, 0);
  EXPECT_EQ(parseBufferName("shadow", true)->index, 1);
  EXPECT_TRUE(parseBufferName("colorimg3", false)->image);
  EXPECT_EQ(parseBufferName("colortex31", false)->index, 31);
  EXPECT_EQ(parseBufferName("colorimg16", false)->index, 16);
  EXPECT_FALSE(parseBufferName("colortex32", false));
  EXPECT_FALSE(parseBufferName("colortexture", false));
}

/// All kinds of content.
SceneContents everyContent() {
  SceneContents scene;
  for (const ContentKind& kind : contentKinds()) scene.content |= bitOf(kind.geometry);
  return scene;
}

std::vector<std::string> drawnNames(const Schedule& schedule) {
  std::vector<std::string> names;
  for (const Step& step : schedule.frame)
    if (step.kind == Step::Kind::Draw || step.name == "deferred" || step.kind == Step::Kind::CopyDepth)
      names.push_back(step.name);
  return names;
}

TEST(ScheduleContent, is_drawn_in_the_order_of_the_game) {
  Files files;
  add(files, "gbuffers_basic", fragment({}, "0"));
  add(files, "deferred", fragment({"colortex0", "depthtex1", "depthtex2"}, "0"));
  files["/shaders.properties"] = "sky=false\nstars=false\nsun=false\nmoon=false\n";
  EXPECT_THAT(
      drawnNames(scheduleOf(loadClean(files), everyContent())),
      ElementsAre("gbuffers_terrain_solid", "gbuffers_terrain_cutout", "gbuffers_basic",
                  "gbuffers_entities", "gbuffers_entities_translucent", "gbuffers_spidereyes",
                  "gbuffers_armor_glint", "gbuffers_lightning", "gbuffers_block",
                  "gbuffers_block_translucent", "gbuffers_beaconbeam", "gbuffers_beaconbeam",
                  "gbuffers_damagedblock", "gbuffers_line", "copy_depthtex2", "gbuffers_hand",
                  "gbuffers_armor_glint", "copy_depthtex1", "deferred", "gbuffers_water", "gbuffers_particles",
                  "gbuffers_particles_translucent", "gbuffers_weather", "gbuffers_weather",
                  "gbuffers_textured", "gbuffers_hand_water"));
}

TEST(ScheduleContent, the_pack_orders_particles_and_entities_that_blend) {
  const auto halves = [](const std::string& properties, bool deferred) {
    Files files;
    add(files, "gbuffers_basic", fragment({}, "0"));
    if (deferred) add(files, "deferred", fragment({"colortex0"}, "0"));
    files["/shaders.properties"] = properties;
    const auto names = stepNames(scheduleOf(loadClean(files), everyContent()));
    const auto place = [&](const char* name) {
      return std::find(names.begin(), names.end(), name) - names.begin();
    };
    std::string text;
    for (const char* name : {"gbuffers_entities_translucent", "gbuffers_particles",
                             "gbuffers_particles_translucent"})
      text += place(name) < place("gbuffers_hand") ? '<' : '>';
    return text;
  };
  EXPECT_EQ(halves("", true), "<>>");
  EXPECT_EQ(halves("", false), "<<>");
  EXPECT_EQ(halves("particles.ordering=before\n", true), "<<<");
  EXPECT_EQ(halves("particles.ordering=MIXED\n", true), "<<>");
  EXPECT_EQ(halves("particles.ordering=after\n", false), "<>>");
  EXPECT_EQ(halves("particles.before.deferred=true\n", true), "<<<");
  EXPECT_EQ(halves("separateEntityDraws=true\n", true), "><>");
  EXPECT_EQ(halves("separateEntityDraws=false\n", true), "<<>");
}

TEST(ScheduleContent, shadows_follow_the_switches_of_the_pack) {
  const auto casters = [](const std::string& properties) {
    Files files;
    add(files, "shadow", fragment({"gtexture"}, "0"));
    add(files, "final", fragment({"shadowtex0", "shadowcolor0"}, ""));
    files["/shaders.properties"] = properties;
    std::vector<std::string> names;
    for (const Step& step : scheduleOf(loadClean(files), everyContent()).frame)
      if (step.kind == Step::Kind::DrawShadow && findContentKind(step.geometry))
        names.push_back(step.name);
    return names;
  };
  EXPECT_THAT(casters(""), ElementsAre("shadow", "shadow_entities", "shadow_entities",
                                       "shadow_entities", "shadow_lightning", "shadow_block",
                                       "shadow_entities"));
  EXPECT_THAT(casters("shadowEntities=false\n"), ElementsAre("shadow_block", "shadow_entities"));
  EXPECT_THAT(casters("shadowEntities=false\nshadowPlayer=true\n"),
              ElementsAre("shadow_entities", "shadow_block", "shadow_entities"));
  EXPECT_THAT(casters("shadowEntities=false\nshadowBlockEntities=false\n"), IsEmpty());
}

TEST(ScheduleContent, weather_is_the_packs_to_leave_out) {
  Files files;
  add(files, "gbuffers_basic", fragment({}, "0"));
  files["/shaders.properties"] = "weather=false\n";
  EXPECT_THAT(stepNames(scheduleOf(loadClean(files), everyContent())),
              ::testing::Not(::testing::Contains("gbuffers_weather")));
}

/// The reference pack with everything off: no voxel, floodfill or shadow target, no such program.
TEST(ReferencePack, cost_follows_use) {
  Diagnostics diagnostics;
  std::shared_ptr<const FileSource> source = openPack(ORRIS_SOURCE_DIR "/shaderpack", diagnostics);
  ASSERT_NE(source, nullptr);
  const auto schedule = [&](const OptionValues& values, std::vector<std::string>& compiled) {
    const auto pack =
        loadShaderPack(source, {.values = values, .environment = standardMacros({})}, diagnostics);
    EXPECT_TRUE(pack.has_value());
    const Schedule result = buildSchedule(*pack, 64, 64, {}, diagnostics);
    for (int program : result.programs) compiled.push_back(pack->programs[program].name);
    return result;
  };
  std::vector<std::string> off, on;
  const Schedule none = schedule({{"GI_METHOD", "NONE"}, {"SHADOW_METHOD", "NONE"}}, off);
  const Schedule full = schedule({{"GI_METHOD", "FLOODFILL"}, {"SHADOW_METHOD", "MAP_PCF"}}, on);
  EXPECT_EQ(none.shadowResolution, 0);
  EXPECT_THAT(none.shadowcolor, IsEmpty());
  EXPECT_GT(full.shadowResolution, 0);
  EXPECT_LT(none.colortex.size(), full.colortex.size());
  EXPECT_THAT(off, ::testing::Not(::testing::Contains("shadow")));
  EXPECT_THAT(on, ::testing::Contains("shadow"));
  EXPECT_LT(off.size(), on.size());
  for (const Diagnostic& d : diagnostics) ADD_FAILURE() << formatDiagnostic(d);
}

}  // namespace
}  // namespace orris
