// Shadow volumes in the frame against rays: docs/failure-modes.md D1 to D9 as far as pixels show them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <orris/plan/schedule/schedule.h>
#include "volume_lab.h"

namespace orris::test {
namespace {

/// A tower beside a roof on a post.
constexpr const char* kScene = R"({"box": "stone", "min": [12, 2, 12], "max": [13, 9, 13]},
  {"box": "stone", "min": [18, 8, 10], "max": [24, 8, 20]},
  {"box": "stone", "min": [21, 2, 15], "max": [21, 7, 15]},
  {"box": "oak_leaves", "min": [5, 5, 5], "max": [8, 7, 8]},
  {"box": "stone_brick_slab[type=bottom]", "min": [6, 2, 18], "max": [10, 2, 24]},
  {"box": "stone_brick_stairs[facing=north]", "min": [12, 2, 24], "max": [16, 2, 24]})";

void expectTrue(const MaskDifference& difference, const std::string& what) {
  EXPECT_EQ(difference.interior, 0) << what;
  EXPECT_LE(difference.edgeShare(), kEdgeShare) << what;
  EXPECT_GT(difference.lit, difference.pixels / 20) << what;
  EXPECT_LT(difference.lit, difference.pixels * 19 / 20) << what;
}

TEST(ShadowVolumes, are_drawn_only_where_a_program_reads_them) {
  const auto stepsOf = [](const std::string& method, const OptionValues& options) {
    const VolumeLab lab({.blocks = kScene, .method = method, .size = 16, .options = options});
    const Schedule schedule = const_cast<VolumeLab&>(lab).session().session().renderer().schedule();
    int steps = 0;
    for (const Step& step : schedule.frame) steps += step.kind == Step::Kind::ShadowVolumes;
    EXPECT_EQ(schedule.stencil, steps == 1);
    return std::pair(steps, schedule.shadowResolution);
  };
  EXPECT_EQ(stepsOf("VOLUME_AUTO", {}), std::pair(1, 0)) << "and no shadow map";
  EXPECT_EQ(stepsOf("MAP_PCF", {}), std::pair(0, 1024));
  EXPECT_EQ(stepsOf("NONE", {}), std::pair(0, 0));
}

// Row D1 of docs/failure-modes.md.
TEST(ShadowVolumeCounts, volumes_of_each_method_are_those_of_rays_seen_from_the_light) {
  for (const char* method : {"VOLUME_ZPASS", "VOLUME_ZFAIL", "VOLUME_AUTO"}) {
    VolumeLab lab({.blocks = kScene, .time = 3000, .method = method});
    lab.look({4, 16, 30}, {17, 3, 14});
    expectTrue(lab.difference(), method);
  }
}

TEST(ShadowVolumeCounts, only_z_pass_is_wrong_with_the_eye_in_a_volume) {
  // Under the roof.
  const auto differenceOf = [](const std::string& method) {
    VolumeLab lab({.blocks = kScene, .method = method, .sunPathRotation = "0.0"});
    lab.look({20.3, 4.2, 12.4}, {14, 2, 20});
    return lab.difference();
  };
  expectTrue(differenceOf("VOLUME_ZFAIL"), "z-fail");
  expectTrue(differenceOf("VOLUME_AUTO"), "automatic");
  const MaskDifference wrong = differenceOf("VOLUME_ZPASS");
  EXPECT_GT(wrong.interior, wrong.pixels / 3);
}

// Else hardly any wrong pixel would count as inside.
TEST(ShadowMask, doubts_few_pixels) {
  VolumeLab lab({.blocks = kScene, .sunPathRotation = "0.0"});
  lab.look({20.3, 4.2, 12.4}, {14, 2, 20});
  int sure = 0, doubted = 0;
  for (const float value : lab.reference().pixels) {
    sure += value == 0;
    doubted += value > 0 && value < 0.5f;
  }
  EXPECT_GT(sure, 10 * doubted) << "of the dark ones";
}

// Row D2 of docs/failure-modes.md.
TEST(ShadowVolumeCounts, a_path_in_and_out_of_shadow_has_no_wrong_pixel_inside) {
  VolumeLab lab({.blocks = kScene, .time = 4000, .size = 64});
  int inside = 0;
  for (int frame = 0; frame < 24; ++frame) {
    const double t = frame / 23.0;
    lab.look({10 + 16 * t, 3.4 + t, 18.7 - 1.3 * t}, {16, 2.5, 10 + 4 * t});
    const MaskDifference difference = lab.difference();
    EXPECT_EQ(difference.interior, 0) << frame;
    EXPECT_LE(difference.edgeShare(), 2 * kEdgeShare) << frame << ": of 4096 pixels";
    inside += lab.session().session().renderer().facesAtEye() > 0;
  }
  EXPECT_GT(inside, 3);
  EXPECT_LT(inside, 21);
}

// The roof's shadow begins at x = 18, which is now before the near plane, now on it, now behind it.
// z-pass counts from the eye itself: with the near rectangle alone in a volume it is right.
TEST(ShadowVolumeCounts, volumes_at_the_near_plane_are_whole) {
  for (const std::string method : {"VOLUME_ZPASS", "VOLUME_ZFAIL", "VOLUME_AUTO"}) {
    VolumeLab lab({.blocks = kScene, .method = method, .sunPathRotation = "0.0", .size = 48});
    for (const double x : {17.9, 17.96, 17.98, 17.999, 18.001, 18.02, 18.1}) {
      if (method == "VOLUME_ZPASS" && x > 18) continue;
      for (const double way : {6.0, -6.0}) {
        lab.look({x, 4.2, 12.4}, {x + way, 2.5, 13.1});
        EXPECT_EQ(lab.difference().interior, 0) << method << " at " << x << ", " << way;
      }
    }
  }
}

// Row D3 of docs/failure-modes.md.
TEST(ShadowVolumeShapes, caps_of_leaves_lie_behind_what_is_seen) {
  for (const char* method : {"VOLUME_ZFAIL", "VOLUME_AUTO"})
    for (const glm::dvec3 eye : {glm::dvec3(3, 12, 3), {16, 5, 16}, {6.5, 3, 12}}) {
      VolumeLab lab({.blocks = R"({"box": "oak_leaves", "min": [5, 5, 5], "max": [8, 7, 8]})",
                     .time = 3000,
                     .method = method});
      lab.look(eye, {7, 5, 7});
      const MaskDifference difference = lab.difference();
      EXPECT_LE(difference.interior, 2) << method;
      EXPECT_LE(difference.edgeShare(), 0.02) << method << ": holes are edges all over";
    }
}

// Of a wide world coordinates are large wherever they begin but near the eye.
TEST(ShadowVolumeShapes, leaves_far_from_the_middle_of_the_world_do_not_shade_themselves) {
  VolumeLab lab({.blocks = R"({"box": "oak_leaves", "min": [4, 2, 4], "max": [12, 9, 5]})", .time = 3000, .size = 64, .box = {512, 24, 16}});
  int inside = 0;
  for (int i = 0; i < 24; i += 3) {
    const double aside = 0.25 * (i - 12), away = 0.7 + 0.061 * i;
    lab.look({8.3, 4.4, 6 + away}, {8.3 + aside * away, 4.1, 6});
    inside += int(lab.difference().interior);
  }
  EXPECT_LE(inside, 2);
}

// Row D4 of docs/failure-modes.md.
// Leaves have a face between each two of them, so that a column of n makes n volumes.
TEST(ShadowVolumeCounts, counts_are_exact_modulo_256) {
  for (const int volumes : {1, 255, 256, 257}) {
    VolumeLab lab(
        {.blocks = fmt::format(R"({{"box": "oak_leaves", "min": [8, 20, 8], "max": [8, {}, 8]}})",
                               19 + volumes),
         .sunPathRotation = "0.0",
         .size = 17,
         .box = {16, 300, 16}});
    lab.look({8.5, 10, 12.5}, {8.5, 2, 8.5}, 10);
    lab.drawn();
    EXPECT_EQ(lab.count(8, 8), volumes % 256);
    EXPECT_EQ(lab.drawn().at(8, 8)[0] > 0.5f, volumes == 256) << volumes;
  }
}

// 300 volumes that begin and end before what is seen, or behind it, and one that holds it. Counts that stop at 0 and
// 255 instead of wrapping around are 0 or 255 there.
TEST(ShadowVolumeCounts, volumes_in_front_cancel_beyond_255) {
  for (const char* method : {"VOLUME_ZPASS", "VOLUME_ZFAIL", "VOLUME_AUTO"}) {
    VolumeLab lab({.blocks = R"({"box": "oak_leaves", "min": [8, 20, 8], "max": [8, 319, 8]},
                               {"box": "stone", "min": [2, 20, 7], "max": [4, 20, 9]})",
                   .method = method,
                   .sunPathRotation = "0.0",
                   .size = 17,
                   .box = {16, 324, 16}});
    // Behind the 300, and before them.
    for (const double x : {14.5, 0.5}) {
      lab.look({x, 7.1, 8.5}, {3.5, 2, 8.5}, 4);
      EXPECT_LT(lab.drawn().at(8, 8)[0], 0.5f) << method << " from " << x;
      EXPECT_EQ(lab.count(8, 8), 1) << method << " from " << x;
    }
  }
}

TEST(ShadowVolumeCounts, z_pass_lacks_the_volumes_that_hold_the_eye) {
  const auto countsOf = [](const std::string& method, int volumes) {
    VolumeLab lab(
        {.blocks = fmt::format(R"({{"box": "oak_leaves", "min": [8, 16, 8], "max": [8, {}, 8]}})",
                               15 + volumes),
         .method = method,
         .sunPathRotation = "0.0",
         .size = 16});
    lab.look({8.4, 5, 8.5}, {11, 2, 8.6});
    lab.drawn();
    return lab.session().dump("stenciltex0").pixels;
  };
  for (const int volumes : {1, 3}) {
    const auto zPass = countsOf("VOLUME_ZPASS", volumes), zFail = countsOf("VOLUME_ZFAIL", volumes);
    for (std::size_t i = 0; i < zPass.size(); ++i)
      EXPECT_EQ((int(zFail[i]) - int(zPass[i]) + 256) % 256, volumes) << i;
  }
}

// Row D7 of docs/failure-modes.md.
// A lit wall fills the picture, and behind it lie volumes with long straight edges, which z-fail counts:
// all cancel. Of merged runs the rasteriser leaves cracks between their ends and the corners of caps.
TEST(ShadowVolumeShapes, straight_edges_leave_no_cracks) {
  std::string blocks = R"({"box": "stone", "min": [40, 2, 0], "max": [40, 23, 63]})";
  for (int i = 0; i < 8; ++i)
    blocks += fmt::format(R"(, {{"box": "stone", "min": [{}, {}, 2], "max": [{}, {}, 61]}})",
                          6 + 4 * i, 4 + i % 4 * 4, 6 + 4 * i, 4 + i % 4 * 4);
  VolumeLab lab(
      {.blocks = blocks, .time = 3000, .method = "VOLUME_ZFAIL", .size = 320, .box = {64, 24, 64}});
  long long dark = 0;
  for (int i = 0; i < 12; ++i) {
    lab.look({58, 12.4 + 0.1 * i, 30.3 + 0.3 * i}, {40, 13.1, 32}, 60);
    EXPECT_EQ(lab.drawn().at(160, 160)[0], 1);
    for (const float count : lab.session().dump("stenciltex0").pixels) dark += count != 0;
  }
  EXPECT_EQ(dark, 0);
}

// Row D8 of docs/failure-modes.md.
// The sun stands over the plane of x = 32, in which each second roof ends and the next begins: the
// ground below lies in one shadow.
TEST(ShadowVolumeShapes, volumes_that_meet_in_a_plane_leave_no_gap) {
  std::string roofs;
  for (int i = 0; i < 12; ++i)
    roofs += fmt::format(R"({}{{"box": "stone", "min": [{}, {}, {}], "max": [{}, {}, {}]}})",
                         i ? ", " : "", 4 + 4 * i, 9 + i % 2 * 3, 4, 7 + 4 * i, 9 + i % 2 * 3, 60);
  VolumeLab lab({.blocks = roofs, .sunPathRotation = "-30.0", .size = 320, .box = {64, 24, 64}});
  long long interior = 0;
  for (const int i : {0, 1, 4}) {
    lab.look({8.3 + 6.1 * i, 3.2 + 0.2 * i, 59 - 0.37 * i}, {50 - 5.5 * i, 2, 16});
    interior += lab.difference().interior;
  }
  EXPECT_EQ(interior, 0);
}

// Row D5 of docs/failure-modes.md.
TEST(ShadowVolumeShapes, a_lone_pane_casts_its_outline_and_nothing_else) {
  for (const char* method : {"VOLUME_ZPASS", "VOLUME_ZFAIL", "VOLUME_AUTO"}) {
    VolumeLab lab({.blocks = R"({"block": "white_carpet", "at": [[16, 8, 16]]})",
                   .method = method,
                   .sunPathRotation = "0.0",
                   .size = 128});
    lab.look({16.5, 30, 16.6}, {16.5, 2, 16.5}, 40);
    const ImageF light = lab.drawn();
    int dark = 0;
    for (const float value : light.pixels) dark += value < 0.5f;
    const MaskDifference difference = lab.difference();
    EXPECT_EQ(difference.interior, 0) << method;
    EXPECT_GT(difference.lit, difference.pixels * 3 / 4);
  }
}

TEST(ShadowVolumeShapes, light_along_faces_and_edges) {
  const std::string diagonal = R"({"box": "stone", "min": [10, 2, 10], "max": [13, 6, 13]},
    {"box": "stone", "min": [14, 2, 14], "max": [17, 6, 17]},
    {"box": "stone", "min": [10, 7, 14], "max": [13, 9, 17]})";
  for (const char* method : {"VOLUME_ZPASS", "VOLUME_ZFAIL", "VOLUME_AUTO"}) {
    VolumeLab lab({.blocks = diagonal, .method = method, .sunPathRotation = "0.0"});
    for (const glm::dvec3 eye : {glm::dvec3(4, 14, 4), {26, 12, 20}, {14, 20, 14}}) {
      lab.look(eye, {14, 3, 14.01});
      const MaskDifference difference = lab.difference();
      EXPECT_EQ(difference.interior, 0) << method;
      EXPECT_LE(difference.edgeShare(), kEdgeShare) << method;
    }
  }
}

// Row D9 of docs/failure-modes.md.
TEST(ShadowVolumeChoice, the_automatic_choice_is_z_fail_pixel_for_pixel) {
  VolumeLab automatic({.blocks = kScene, .time = 2500, .size = 64});
  VolumeLab zFail({.blocks = kScene, .time = 2500, .method = "VOLUME_ZFAIL", .size = 64});
  int differing = 0, atEye = 0;
  for (int i = 0; i < 40; ++i) {
    // Over all of the scene, many of the places in shadow and some on whole blocks.
    const glm::dvec3 eye(4 + i * 7 % 25, 3.13 + i % 5 * 1.5, 4 + i * 11 % 25);
    const glm::dvec3 place = eye + glm::dvec3(i % 2 * 0.37, 0, i % 3 * 0.21);
    const BlockWorld& blocks = automatic.session().session().scene().world.blocks;
    if (blocks.indexAt(glm::ivec3(glm::floor(place))) != 0) continue;
    automatic.look(place, {16, 4, 16.01});
    zFail.look(place, {16, 4, 16.01});
    // Light, not counts: on faces that turn away z-fail may count their own cap.
    const ImageF a = automatic.drawn(), b = zFail.drawn();
    for (std::size_t k = 0; k < a.pixels.size(); k += std::size_t(a.channels))
      differing += (a.pixels[k] > 0.5f) != (b.pixels[k] > 0.5f);
    atEye += automatic.session().session().renderer().facesAtEye() > 0;
  }
  EXPECT_GT(atEye, 2);
  EXPECT_LT(atEye, 30);
  EXPECT_EQ(differing, 0);
}

TEST(ShadowVolumes, silhouettes_are_made_again_only_for_another_light) {
  VolumeLab lab({.blocks = kScene, .time = 3000, .size = 32});
  auto& session = lab.session().session();
  for (int i = 0; i < 5; ++i) {
    lab.look({4.0 + i, 16, 30}, {17, 3, 14});
    lab.drawn();
  }
  EXPECT_EQ(session.renderer().silhouetteBuilds(), 1);
  session.setTime(3600);
  lab.drawn();
  EXPECT_EQ(session.renderer().silhouetteBuilds(), 2);
}

}  // namespace
}  // namespace orris::test
