// How much clusters leave out: false positives by distance, lights a pixel, tests a light.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "cluster_lab.h"
#include "lab.h"
#include <orris/plan/frame/frame_state.h>

namespace orris::test {
namespace {

constexpr int kColumns = 16, kRows = 9, kSlices = 24, kTiles = kColumns * kRows;
constexpr double kFirst = 4, kFar = 64, kRange = 8;

const OptionValues kGrid = {{"LIGHT_COLUMNS", "16"}, {"LIGHT_SLICES", "24"}};

double sliceStart(int slice) {
  return slice == 0 ? 0 : kFirst * std::pow(kFar / kFirst, (slice - 1.) / (kSlices - 1));
}

/// What no more than a half-space holds: dot(normal, p) <= bound.
struct HalfSpace {
  glm::dvec3 normal;
  double bound;
};

/// The part of a tile between two distances; view space with z along the view.
std::vector<HalfSpace> clusterOf(int column, int row, int slice, const glm::dvec2& scale) {
  const auto slope = [](int tile, int count, double s) { return (2. * tile / count - 1) / s; };
  const double left = slope(column, kColumns, scale.x),
               right = slope(column + 1, kColumns, scale.x);
  const double low = slope(row, kRows, scale.y), high = slope(row + 1, kRows, scale.y);
  std::vector<HalfSpace> sides = {{{0, 0, -1}, -sliceStart(slice)},
                                  {{0, 0, 1}, sliceStart(slice + 1)},
                                  {{-1, 0, left}, 0},
                                  {{1, 0, -right}, 0},
                                  {{0, -1, low}, 0},
                                  {{0, 1, -high}, 0}};
  for (HalfSpace& side : sides) {
    const double length = glm::length(side.normal);
    side = {side.normal / length, side.bound / length};
  }
  return sides;
}

/// Nearest point of their intersection, by Dykstra's alternating projections.
double distanceTo(const std::vector<HalfSpace>& sides, const glm::dvec3& point) {
  glm::dvec3 at = point;
  std::vector<glm::dvec3> added(sides.size(), glm::dvec3(0));
  for (int round = 0; round < 300; ++round)
    for (std::size_t i = 0; i < sides.size(); ++i) {
      const glm::dvec3 from = at + added[i];
      const double out = std::max(0., glm::dot(sides[i].normal, from) - sides[i].bound);
      at = from - out * sides[i].normal;
      added[i] = from - at;
    }
  return glm::distance(at, point);
}

FrameState viewOf(PackSession& pack, int width) {
  RenderSession& session = pack.session();
  return nextFrameState({.width = width,
                         .height = width,
                         .camera = session.camera(),
                         .environment = session.scene().world.environment},
                        session.renderer().pack().directives, nullptr);
}

struct Share {
  int listed = 0, wrong = 0;
  double value() const { return listed == 0 ? 0 : double(wrong) / listed; }
};

// Row F6 of docs/failure-modes.md.
// Spheres of 8 blocks spread over what is seen. Clusters at the border of the screen have no end there,
// so they are left out.
TEST(ClusterLoad, clusters_list_lights_in_vain_as_often_as_predicted) {
  constexpr int kWidth = 64;
  ClusterLab lab({.light =
                      "Light((gbufferModelViewInverse * vec4((random(i).xy * 2.0 - 1.0) * (8.0 "
                      "+ 70.0 * random(i).z / tile_scale()), -70.0 * random(i).z, 1.0)).xyz, "
                      "1.0 / 64.0, vec3(1.0), 0.25)",
                  .lights = 400,
                  .probe = "vec4(0.0)",
                  .options = kGrid,
                  .width = kWidth});
  lab.renderFrames(1);
  const FrameState view = viewOf(lab.pack(), kWidth);
  const glm::dvec2 scale(view.gbufferProjection[0][0], view.gbufferProjection[1][1]);
  const ImageF table = lab.pack().dump("light_table"), list = lab.pack().dump("light_list");
  const ImageF bits = lab.pack().dump("light_bits");
  const glm::dvec3 fraction = glm::fract(view.cameraPosition);
  const auto placeOf = [&](int lamp) {
    const float* stored = table.at(2 * lamp, table.height - 1);
    const glm::vec3 player =
        glm::vec3(stored[0], stored[1], stored[2]) - glm::vec3(fraction) - 64.f;
    const glm::vec4 seen = view.gbufferModelView * glm::vec4(player, 1);
    return glm::dvec3(seen.x, seen.y, -seen.z);
  };
  std::map<int, Share> bySlice;
  for (int slice = 0; slice + 1 < kSlices; ++slice)
    for (int row = 1; row + 1 < kRows; ++row)
      for (int column = 1; column + 1 < kColumns; ++column) {
        const int y = list.height - 1 - (slice * kTiles + row * kColumns + column);
        const int length = lampsOfLength(bits.at(bits.width - 1, y)[0]);
        const auto sides = clusterOf(column, row, slice, scale);
        for (int i = 0; i < length; ++i) {
          ++bySlice[slice].listed;
          bySlice[slice].wrong +=
              distanceTo(sides, placeOf(int(list.at(i, y)[0]))) > kRange * 1.001;
        }
      }
  // Predicted for boxes about clusters: 8 % of those 4.5 to 6 blocks away, 22 at 16 to 22, 43 at 56 to
  // 77. Spheres against tiles of slices leave less than the least of it everywhere.
  const auto between = [&](double from, double to) {
    Share sum;
    for (const auto& [slice, share] : bySlice)
      if (sliceStart(slice) >= from && sliceStart(slice + 1) <= to) {
        sum.listed += share.listed;
        sum.wrong += share.wrong;
      }
    return sum;
  };
  const Share near = between(4, 7), middle = between(15, 23), far = between(45, 65);
  fmt::print("in vain: {:.3f} of {}, {:.3f} of {}, {:.3f} of {}\n", near.value(), near.listed,
             middle.value(), middle.listed, far.value(), far.listed);
  for (const Share& share : {near, middle, far}) EXPECT_GT(share.listed, 500);
  for (const Share& share : {near, middle, far}) {
    EXPECT_GT(share.value(), 0);
    EXPECT_LE(share.value(), 0.08);
  }
}

// Points of a floor 2.6 below the eye; lights a block over it.
constexpr const char* kFloor = R"(
vec4 load(ivec2 pixel) {
    vec3 ray = vec3(((vec2(pixel) + 0.5) / 32.0 - 1.0) / tile_scale(), -1.0);
    float down = -(mat3(gbufferModelViewInverse) * ray).y;
    vec3 view = ray * (2.6 / max(down, 0.01));
    if (down < 0.05) return vec4(-1.0);
    vec3 place = to_lamp_space((gbufferModelViewInverse * vec4(view, 1.0)).xyz);
    float reached = 0.0;
    for (uint i = 0u; i < lamp_count(); ++i) {
        vec4 stored = imageLoad(light_table, table_texel(i));
        reached += float(dot(stored.xyz - place, stored.xyz - place) * stored.w < 1.0);
    }
    return vec4(cluster_count(cluster_of(view)), reached, 1.0, 1.0);
}
)";

struct Load {
  double asked = 0, reached = 0;  ///< lights a pixel
  double border = 0,
         beside = 0;  ///< asked in the outermost columns of tiles, and in those next to them
};

/// `side` squared lights, one in each square of a lattice.
Load loadOf(int side, const char* method) {
  ClusterLab lab(
      {.light = fmt::format("Light(vec3((float(i % {0}) + random(i).x) * 120.0 / {0}.0 - "
                            "60.0, -1.6, (float(i / {0}) + random(i).z) * 120.0 / {0}.0 "
                            "- 60.0), 1.0 / 64.0, vec3(1.0), 0.25)",
                            side),
       .lights = side * side,
       .probe = "load(pixel)",
       .options = {{"LIGHT_METHOD", method}, {"LIGHT_COLUMNS", "16"}},
       .width = 64,
       .functions = kFloor});
  lab.renderFrames(1);
  Load sum;
  double pixels = 0;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      const auto [asked, reached, one, unused] = lab.probe(x, y);
      if (asked < 0) continue;
      sum.asked += asked;
      if (x < 4 || x >= 60) sum.border += asked;
      if ((x >= 4 && x < 8) || (x >= 56 && x < 60)) sum.beside += asked;
      sum.reached += reached;
      ++pixels;
    }
  return {sum.asked / pixels, sum.reached / pixels, sum.border, sum.beside};
}

// Row F7 of docs/failure-modes.md.
TEST(ClusterLoad, tiles_at_the_border_ask_no_more_than_those_beside_them) {
  const Load load = loadOf(32, "CLUSTERED");
  EXPECT_GT(load.beside, 1000);
  EXPECT_NEAR(load.border / load.beside, 1, 0.25);
}

TEST(ClusterLoad, lights_a_pixel_are_those_that_reach_it_and_few_more) {
  const Load few = loadOf(16, "CLUSTERED"), many = loadOf(32, "CLUSTERED");
  const Load tiled = loadOf(32, "TILED");
  fmt::print("lights a pixel: {:.2f} of {:.2f}, {:.2f} of {:.2f}, tiled {:.1f}\n", few.asked,
             few.reached, many.asked, many.reached, tiled.asked);
  EXPECT_NEAR(many.reached / few.reached, 4, 1) << "linear in their number";
  EXPECT_NEAR(many.asked / few.asked, 4, 1);
  // Predicted: 1.5 to 2.5 times what reaches the pixel.
  EXPECT_GE(many.asked, many.reached);
  EXPECT_LE(many.asked, 2.5 * many.reached);
  EXPECT_GT(tiled.asked, 2 * many.asked);
  EXPECT_GT(1024, 10 * many.asked);
}

// Row F9 of docs/failure-modes.md.
TEST(ClusterLoad, each_light_is_tested_against_the_clusters_about_it_only) {
  const auto entriesOf = [](bool andTests) {
    ClusterSetup setup{
        .light =
            "Light(vec3(random(i).x * 120.0 - 60.0, -1.6, random(i).z * 120.0 - 60.0), 1.0 / "
            "64.0, vec3(1.0), 0.25)",
        .lights = 1000,
        .probe = "vec4(0.0)",
        .options = kGrid,
        .width = 16};
    if (andTests)
      setup.change = [](PackTexts& files) {
        edit(files["/program/lights/assign.glsl"], "float wide = gap(",
             "imageAtomicAdd(lamp_tally, lamp_entries, 1u);\n            float wide = gap(");
      };
    ClusterLab lab(setup);
    lab.renderFrames(1);
    return stateOf(lab.pack()).entries;
  };
  const double entries = entriesOf(false), tests = entriesOf(true) - entries;
  fmt::print("{} entries, {} tests\n", entries, tests);
  EXPECT_GT(entries, 1000);
  EXPECT_GE(tests, entries);
  EXPECT_LT(tests, 1.2 * entries);
  // All clusters against all lights: two orders more.
  EXPECT_LT(tests, 0.02 * kTiles * kSlices * 1000);
}

// Row F2 of docs/failure-modes.md.
TEST(ClusterSlices, no_slice_is_spent_on_what_is_right_before_the_eye) {
  // Columns: distances 4 and 1 to 64; where the slices are.
  ClusterLab lab({.light = "Light(vec3(0.0), 1.0, vec3(1.0), 0.25)",
                  .lights = 1,
                  .probe = "vec4(slice_of(float[3](0.05, 1.0, 3.99)[min(pixel.x, 2)]), "
                           "slice_start(pixel.x + 2) / slice_start(pixel.x + 1), 0.0, 1.0)",
                  .options = kGrid,
                  .width = 24});
  lab.renderFrames(1);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(lab.probe(i, 0)[0], 0) << i;
  // 1.37 to 1.62 where the logarithm begins at the near plane.
  for (int i = 0; i < 22; ++i)
    EXPECT_NEAR(lab.probe(i, 0)[1], std::pow(kFar / kFirst, 1. / 23), 1e-3) << i;
}

}  // namespace
}  // namespace orris::test
