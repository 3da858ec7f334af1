// Shadow volumes of lamps: against rays to each lamp, and what a lamp does not reach.
#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <orris/render/scene/lamp_volumes.h>
#include "volume_lab.h"

namespace orris::test {
namespace {

/// Two lamps over a floor with pillars, slabs and leaves; slabs end in the plane of the first lamp.
constexpr const char* kLampScene = R"({"block": "glowstone", "at": [[12, 6, 12]]},
  {"block": "shroomlight", "at": [[14, 8, 9]]},
  {"box": "stone", "min": [9, 2, 9], "max": [9, 7, 9]},
  {"box": "stone", "min": [15, 2, 11], "max": [15, 6, 13]},
  {"box": "stone_brick_slab[type=bottom]", "min": [10, 6, 15], "max": [14, 6, 16]},
  {"box": "stone_brick_stairs[facing=north]", "min": [6, 3, 12], "max": [8, 3, 12]},
  {"box": "oak_leaves", "min": [12, 3, 8], "max": [13, 4, 9]})";

VolumeSetup setupOf(const std::string& method, const std::string& lamps = "2") {
  return {.blocks = kLampScene,
          .method = method,
          .size = 128,
          .box = {24, 14, 24},
          .options = {{"LIGHT_METHOD", "CLUSTERED"},
                      {"LIGHT_VOLUMES", lamps},
                      {"LIGHT_RANGE", "1.5"},
                      {"LIGHT_DISTANCE", "32"}}};
}

/// The picture's channel as a mask of its own.
ImageF channelOf(const ImageF& picture, int channel) {
  ImageF mask(picture.width, picture.height, 1);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) mask.at(x, y)[0] = picture.at(x, y)[channel];
  return mask;
}

struct LampCase {
  glm::ivec3 cell{0};
  int channel = 0;
};

/// Strongest at the eye first: the picture's channels 1 and 2.
std::vector<LampCase> lampsSeenFrom(const glm::dvec3& eye) {
  const glm::ivec3 a(12, 6, 12), b(14, 8, 9);
  const bool first =
      glm::distance(eye, glm::dvec3(a) + 0.5) < glm::distance(eye, glm::dvec3(b) + 0.5);
  return {{a, first ? 1 : 2}, {b, first ? 2 : 1}};
}

const std::vector<glm::dvec3> kEyes = {
    {2, 11, 21}, {22.3, 8.2, 21.1}, {17.4, 3.1, 12.2}, {5.7, 10.6, 3.1}};

void expectThoseOfRays(VolumeLab& lab, const glm::dvec3& eye, const std::string& what) {
  lab.look(eye, {13, 2, 11.01});
  const ImageF drawn = lab.drawn();
  for (const LampCase& lamp : lampsSeenFrom(eye)) {
    Diagnostics diagnostics;
    const auto difference =
        compareMasks(channelOf(drawn, lamp.channel), lab.referenceOfLamp(lamp.cell), diagnostics);
    ASSERT_TRUE(difference);
    EXPECT_EQ(difference->interior, 0) << what << " from " << eye.x;
    EXPECT_LE(difference->edgeShare(), kEdgeShare) << what << " from " << eye.x;
    EXPECT_GT(difference->lit, difference->pixels / 30);
    EXPECT_LT(difference->lit, difference->pixels * 19 / 20);
  }
}

TEST(LampVolumes, are_those_of_rays) {
  for (const char* method : {"VOLUME_AUTO", "VOLUME_ZFAIL"}) {
    VolumeLab lab(setupOf(method));
    for (const glm::dvec3& eye : kEyes) expectThoseOfRays(lab, eye, method);
  }
}

// The middle of the world, which casters are relative to, is far from the lamps; the eye looks away from there, where
// the lamps' range ends.
TEST(LampVolumes, are_those_of_rays_far_from_the_middle_of_the_world) {
  VolumeSetup setup = setupOf("VOLUME_AUTO");
  setup.box.x = 400;
  VolumeLab lab(setup);
  expectThoseOfRays(lab, kEyes[1], "wide");
}

// Third eye: in the shadow of the wall beside the first lamp.
TEST(LampVolumes, by_z_pass_alone_are_wrong_with_the_eye_in_one) {
  VolumeLab lab(setupOf("VOLUME_ZPASS"));
  lab.look(kEyes[2], {13, 2, 11.01});
  Diagnostics diagnostics;
  const auto difference = compareMasks(channelOf(lab.drawn(), lampsSeenFrom(kEyes[2])[0].channel),
                                       lab.referenceOfLamp({12, 6, 12}), diagnostics);
  ASSERT_TRUE(difference);
  EXPECT_GT(difference->interior, difference->pixels / 10);
}

TEST(LampVolumes, darken_the_light_of_their_lamp_alone) {
  struct Lit {
    ImageF light, hidden;
  };
  const auto litBy = [](const std::string& lamps) {
    VolumeSetup setup = setupOf("NONE", lamps);
    setup.options["SHADOW_VIEW"] = "false";
    for (const char* other : {"DIRECT_LIGHT", "TONE_MAP"}) setup.options[other] = "NONE";
    for (const char* other : {"SKY_STRENGTH", "AMBIENT_MINIMUM"}) setup.options[other] = "0.0";
    VolumeLab lab(setup);
    lab.look(kEyes[0], {13, 2, 11.01});
    Lit lit{lab.drawn(), {}};
    if (lamps != "0") lit.hidden = lab.session().dump("stenciltex1");
    return lit;
  };
  const Lit open = litBy("0"), one = litBy("1"), two = litBy("2");
  int darker[2] = {0, 0}, litByOther[2] = {0, 0};
  for (int y = 0; y < open.light.height; ++y)
    for (int x = 0; x < open.light.width; ++x) {
      const float all = open.light.at(x, y)[0], without = one.light.at(x, y)[0],
                  withoutBoth = two.light.at(x, y)[0];
      EXPECT_LE(without, all + 1e-3f);
      EXPECT_LE(withoutBoth, without + 1e-3f);
      const int bits = int(two.hidden.at(x, y)[0]);
      EXPECT_EQ(int(one.hidden.at(x, y)[0]), bits & 1);
      darker[0] += without < all - 0.01f;
      darker[1] += withoutBoth < without - 0.01f;
      for (int lamp = 0; lamp < 2; ++lamp)
        litByOther[lamp] += bits == 1 << lamp && withoutBoth > 0.01f;
    }
  for (int lamp = 0; lamp < 2; ++lamp) {
    EXPECT_GT(darker[lamp], 100);
    EXPECT_GT(litByOther[lamp], 100);
  }
}

TEST(LampVolumes, are_drawn_only_where_a_program_reads_them) {
  const auto stencilOf = [](const std::string& method, const std::string& lamps) {
    VolumeSetup setup = setupOf(method, lamps);
    setup.size = 16;
    VolumeLab lab(setup);
    const Schedule& schedule = lab.session().session().renderer().schedule();
    return std::tuple(schedule.stencil, schedule.sunVolumes, schedule.lampShadows);
  };
  EXPECT_EQ(stencilOf("MAP_PCF", "0"), std::tuple(false, false, false));
  EXPECT_EQ(stencilOf("MAP_PCF", "2"), std::tuple(true, false, true));
  EXPECT_EQ(stencilOf("VOLUME_AUTO", "0"), std::tuple(true, true, false));
  EXPECT_EQ(stencilOf("VOLUME_AUTO", "2"), std::tuple(true, true, true));
}

TEST(LampVolumes, are_made_again_only_for_other_lamps) {
  VolumeSetup setup = setupOf("NONE", "1");
  setup.size = 32;
  VolumeLab lab(setup);
  const auto buildsFrom = [&](const glm::dvec3& eye) {
    lab.look(eye, {13, 2, 11});
    lab.drawn();
    return lab.session().session().renderer().silhouetteBuilds();
  };
  EXPECT_EQ(buildsFrom({8, 5, 15}), 1);
  EXPECT_EQ(buildsFrom({7, 6, 16}), 1);
  EXPECT_EQ(buildsFrom({18, 10, 5}), 2) << "the other lamp is nearer";
}

CasterFace faceAt(const glm::vec3& corner, const glm::vec3& u, const glm::vec3& v) {
  CasterFace face;
  face.corners = {corner, corner + u, corner + u + v, corner + v};
  face.normal = glm::normalize(glm::cross(u, v));
  return face;
}

TEST(LampVolumes, casters_are_those_in_range_without_the_lamp) {
  CasterSet set;
  set.origin = {100, 0, 0};
  set.faces = {faceAt({3, 0, 0}, {0, 1, 0}, {0, 0, 1}),   // the lamp's own, at its high end of x
               faceAt({3, 0, 0}, {0, 0, 1}, {0, 1, 0}),   // its neighbour's
               faceAt({7, 0, 0}, {0, 1, 0}, {0, 0, 1}),   // 4.5 blocks away
               faceAt({8, 0, 0}, {0, 1, 0}, {0, 0, 1})};  // 5.5
  const CasterSet near = castersOfLamp(set, {102, 0, 0}, 5);
  ASSERT_EQ(near.faces.size(), 2u);
  EXPECT_EQ(near.origin, set.origin);
  EXPECT_EQ(near.faces[0].normal.x, -1);
  EXPECT_EQ(near.faces[1].corners[0].x, 7);
}

TEST(LampVolumes, are_counted_only_where_their_light_may_be) {
  const glm::mat4 clip = glm::perspective(glm::radians(90.0f), 1.0f, 0.1f, 100.0f);
  const PixelRect ahead = rectOfBall(clip, {0, 0, -10}, 1, 100, 100);
  // The near side of its box: 1 / 9 of half the picture either way.
  EXPECT_EQ(ahead, (PixelRect{44, 44, 12, 12}));
  EXPECT_EQ(rectOfBall(clip, {30, 0, -10}, 1, 100, 100), PixelRect()) << "beside the picture";
  EXPECT_EQ(rectOfBall(clip, {0, 0, 0}, 1, 100, 100), (PixelRect{0, 0, 100, 100}))
      << "around the eye";
}

TEST(LampVolumes, settings_are_a_count_and_a_range) {
  EXPECT_EQ(parseVolumeLights("4")->count, 4);
  EXPECT_EQ(parseVolumeLights("2 1.5")->range, 1.5f);
  for (const char* wrong : {"", "9", "-1", "two", "2 0", "2 1 1", "2 x"})
    EXPECT_FALSE(parseVolumeLights(wrong)) << wrong;
}

}  // namespace
}  // namespace orris::test
