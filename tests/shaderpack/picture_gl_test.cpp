// What the options do to pictures, and that unused methods cost nothing.
#include <gtest/gtest.h>

#include <algorithm>

#include "pack_session.h"

namespace orris::test {
namespace {

bool mentions(const Schedule& schedule, const ShaderPack& pack, const std::string& program) {
  return std::any_of(schedule.programs.begin(), schedule.programs.end(),
                     [&](int index) { return pack.programs[index].name == program; });
}

TEST(cost, without_lights_and_shadows_no_voxels_floodfill_or_shadow_map_exist) {
  PackSession pack =
      PackSession::ofWorld("cornell", {{"GI_METHOD", "NONE"}, {"SHADOW_METHOD", "NONE"}}, 32, 32);
  const FrameRenderer& renderer = pack.session().renderer();
  const Schedule& schedule = renderer.schedule();
  EXPECT_EQ(schedule.shadowResolution, 0);
  EXPECT_TRUE(schedule.shadowcolor.empty());
  EXPECT_FALSE(schedule.shadowtex1);
  for (const int target : {3, 4, 5}) EXPECT_FALSE(schedule.target(false, target)) << target;
  for (const char* program : {"shadow", "prepare", "prepare1", "deferred"})
    EXPECT_FALSE(mentions(schedule, renderer.pack(), program)) << program;
  EXPECT_TRUE(mentions(schedule, renderer.pack(), "deferred4"));
}

TEST(cost, shadow_map_alone_needs_no_voxels) {
  PackSession pack = PackSession::ofWorld("cornell", {{"GI_METHOD", "NONE"}}, 32, 32);
  const Schedule& schedule = pack.session().renderer().schedule();
  EXPECT_EQ(schedule.shadowResolution, 1024);
  for (const int target : {3, 4, 5}) EXPECT_FALSE(schedule.target(false, target)) << target;
  EXPECT_FALSE(mentions(schedule, pack.session().renderer().pack(), "prepare"));
}

TEST(cost, bounces_need_no_floodfill) {
  PackSession pack = PackSession::ofWorld("cornell", {{"GI_METHOD", "BOUNCE_2"}}, 32, 32);
  const Schedule& schedule = pack.session().renderer().schedule();
  EXPECT_TRUE(schedule.target(false, 3));
  EXPECT_FALSE(schedule.target(false, 4));
}

}  // namespace
}  // namespace orris::test
