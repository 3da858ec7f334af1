// A hundred frames through each world, in and out of its shadows: volumes against rays.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "../shaderpack/pack_session.h"
#include "caster_rays.h"
#include <orris/image/mask_compare.h>
#include <orris/plan/frame/frame_state.h>
#include <orris/trace/reference_scene.h>

namespace orris::test {
namespace {

constexpr int kFrames = 100, kWidth = 160, kHeight = 90;
/// Most pixels by far show what their rays meet first.
constexpr double kOtherSurfaces = 0.002;

struct Path {
  const char* name;
  std::string world;                                     ///< beside the worlds of ours
  std::vector<std::pair<glm::dvec3, glm::dvec3>> looks;  ///< from, to
};

void PrintTo(const Path& path, std::ostream* out) { *out << path.name; }

const std::vector<Path>& paths() {
  static const std::vector<Path> kPaths = {
      {"pillars",
       "pillars",
       {{{22, 13, 46}, {21, 2, 18}},
        {{12, 5, 22}, {11, 3, 8}},
        {{7.4, 3.4, 16.2}, {24, 2.5, 9}},
        {{34.6, 3.6, 12.2}, {10, 3, 14}},
        {{30, 4, 31}, {38, 6, 20}}}},
      {"hills",
       "hills",
       {{{48, 84, 94}, {44, 65, 40}},
        {{60, 77, 70}, {40, 67, 40}},
        {{40, 74, 50}, {70, 65, 30}},
        {{20, 77, 30}, {60, 65, 60}}}},
      {"smallhouse1",
       "../../shared/worlds/smallhouse1.schem",
       {{{-10.7, 31.3, 31.2}, {10, 10, 10}},
        {{-6, 6, 24}, {10, 6, 10}},
        {{24, 5, 23}, {8, 5, 10}},
        {{10.5, 14.62, 10.5}, {4, 13, 10}}}},
  };
  return kPaths;
}

Camera cameraAt(const Path& path, double t) {
  const double place = t * double(path.looks.size() - 1);
  const auto i = std::min(std::size_t(place), path.looks.size() - 2);
  const auto& [a, b] = std::pair(path.looks[i], path.looks[i + 1]);
  const glm::dvec3 from = glm::mix(a.first, b.first, place - double(i));
  const glm::dvec3 direction = glm::mix(a.second, b.second, place - double(i)) - from;
  Camera camera;
  camera.position = from;
  camera.yaw = float(glm::degrees(std::atan2(-direction.x, direction.z)));
  camera.pitch =
      float(glm::degrees(std::atan2(-direction.y, std::hypot(direction.x, direction.z))));
  return camera;
}

TraceCamera traceCamera(RenderSession& session) {
  const FrameState state = nextFrameState({.width = kWidth,
                                           .height = kHeight,
                                           .camera = session.camera(),
                                           .environment = session.scene().world.environment},
                                          session.renderer().pack().directives, nullptr);
  return {state.cameraPosition, state.gbufferModelViewInverse, state.gbufferProjectionInverse,
          kWidth, kHeight};
}

std::string interiorPixels(const ImageF& drawn, const ImageF& reference) {
  std::string places;
  const ImageF wrong = maskDifferenceImage(drawn, reference);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      if (wrong.at(x, y)[0] == 1 && wrong.at(x, y)[1] == 0)
        places += fmt::format(" ({}, {})", x, y);
  return places;
}

class VolumePath : public testing::TestWithParam<Path> {};

TEST_P(VolumePath, equals_rays_inside_of_lit_and_dark) {
  const std::string file = std::string(ORRIS_SOURCE_DIR "/worlds/") + GetParam().world;
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not beside this checkout";
  PackSession pack = PackSession::ofWorld(
      GetParam().world,
      {{"GI_METHOD", "NONE"}, {"SHADOW_METHOD", "VOLUME_AUTO"}, {"SHADOW_VIEW", "true"}}, kWidth,
      kHeight);
  RenderSession& session = pack.session();
  Diagnostics diagnostics;
  const ReferenceScene reference =
      buildReferenceScene(*loadWorld(file, 0, diagnostics), session.renderer().pack(),
                          session.camera(), kWidth, kHeight, diagnostics);
  const CasterRays casters(castersOf(session.scene().mesh, session.scene().atlas));
  const LightStopped ofCasters = casters.stopping(), ofBlocks = stoppedByBlocks(reference.scene);
  long long edge = 0, interior = 0, pixels = 0, others = 0;
  MaskDifference besideSun;  // with what volumes do not know: holes, glass, plants
  int inShadow = 0;
  for (int frame = 0; frame < kFrames; ++frame) {
    session.setCamera(cameraAt(GetParam(), frame / double(kFrames - 1)));
    const glm::ivec3 eye(glm::floor(session.camera().position));
    if (session.scene().world.blocks.indexAt(eye) != 0) continue;  // nothing is right in there
    pack.renderFrames(1);
    inShadow += session.renderer().facesAtEye() > 0;
    ShownFrame shown{pack.dump("depthtex0")};
    ShownFrame shownInSun = shown;
    const glm::dvec4 light(reference.shadowLight, 0);
    const TraceCamera camera = traceCamera(session);
    const ImageF mask = shadowMask(reference.scene, camera, ofCasters, light, &shown);
    const ImageF drawn = pack.dump("colortex0");
    const auto difference = compareMasks(drawn, mask, diagnostics);
    const auto inSun = compareMasks(
        drawn, shadowMask(reference.scene, camera, ofBlocks, light, &shownInSun), diagnostics);
    ASSERT_TRUE(difference && inSun);
    besideSun.edge += inSun->edge;
    besideSun.interior += inSun->interior;
    EXPECT_EQ(difference->interior, 0) << "frame " << frame << interiorPixels(drawn, mask);
    others += shown.others;
    edge += difference->edge;
    interior += difference->interior;
    pixels += difference->pixels;
  }
  RecordProperty("edge", fmt::format("{}", edge));
  RecordProperty("interior", fmt::format("{}", interior));
  fmt::print(
      "{}: {} pixels, {} wrong on edges ({:.4f} %), {} inside; the eye in shadow {} times; in {} "
      "({:.4f} %) the frame shows another surface; beside rays past blocks as they are drawn {} on edges, {} inside\n",
      GetParam().name, pixels, edge, 100.0 * double(edge) / double(pixels), interior, inShadow,
      others, 100.0 * double(others) / double(pixels), besideSun.edge, besideSun.interior);
  EXPECT_GE(inShadow, 3);
  EXPECT_LT(inShadow, kFrames - 3);
  EXPECT_GT(pixels, (kFrames - 30) * kWidth * kHeight);
  EXPECT_LT(double(edge), 0.002 * double(pixels));
  EXPECT_LT(double(others), kOtherSurfaces * double(pixels));
}

/// Sums of a picture over squares of `side` pixels.
std::vector<double> tileSums(const ImageF& picture, int side) {
  const int columns = (picture.width + side - 1) / side;
  std::vector<double> sums(std::size_t(columns * ((picture.height + side - 1) / side)));
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      sums[std::size_t(y / side * columns + x / side)] += double(picture.at(x, y)[0]);
  return sums;
}

// Of a build whose stencil counts updates instead of volumes (tile_choice.py): what choosing between
// z-pass and z-fail by tile would save (Laine 2005), if the choice cost nothing.
TEST_P(VolumePath, DISABLED_updates_that_a_choice_by_tile_saves) {
  constexpr int kStep = 4, kSides[] = {8, 16, 32};
  const std::string file = std::string(ORRIS_SOURCE_DIR "/worlds/") + GetParam().world;
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not beside this checkout";
  const auto sessionOf = [&](const std::string& method) {
    return PackSession::ofWorld(
        GetParam().world, {{"GI_METHOD", "NONE"}, {"SHADOW_METHOD", method}}, kWidth, kHeight);
  };
  PackSession zPass = sessionOf("VOLUME_ZPASS"), zFail = sessionOf("VOLUME_ZFAIL"),
              automatic = sessionOf("VOLUME_AUTO");
  double sums[3] = {0, 0, 0}, best[3] = {0, 0, 0};
  for (int frame = 0; frame < kFrames; frame += kStep) {
    std::vector<ImageF> updates;
    for (PackSession* pack : {&zPass, &zFail, &automatic}) {
      pack->session().setCamera(cameraAt(GetParam(), frame / double(kFrames - 1)));
      pack->renderFrames(1);
      updates.push_back(pack->dump("stenciltex0"));
      for (const float count : updates.back().pixels) sums[updates.size() - 1] += double(count);
    }
    for (int i = 0; i < 3; ++i) {
      const auto pass = tileSums(updates[0], kSides[i]), fail = tileSums(updates[1], kSides[i]);
      for (std::size_t k = 0; k < pass.size(); ++k) best[i] += std::min(pass[k], fail[k]);
    }
  }
  fmt::print(
      "{}: updates a frame: z-pass {:.0f}, z-fail {:.0f}, automatic {:.0f}; the fewer in each "
      "tile of 8, 16, 32 pixels: {:.3f}, {:.3f}, {:.3f} of z-pass\n",
      GetParam().name, sums[0] * kStep / kFrames, sums[1] * kStep / kFrames,
      sums[2] * kStep / kFrames, best[0] / sums[0], best[1] / sums[0], best[2] / sums[0]);
}

INSTANTIATE_TEST_SUITE_P(Worlds, VolumePath, testing::ValuesIn(paths()),
                         [](const auto& path) { return std::string(path.param.name); });

}  // namespace
}  // namespace orris::test
