// The Cornell box without its blocks: what one wall gets from another is known in closed form.
#include <gtest/gtest.h>

#include <array>

#include "cube_scene.h"

namespace orris {
namespace {

using test::Cubes;
using test::Estimate;

const glm::ivec3 kRoom(14, 9, 13);
constexpr double kPi = 3.14159265358979;

/// Between equal rectangles x by y that face each other at a distance of 1.
double facing(double x, double y) {
  const double xx = 1 + x * x, yy = 1 + y * y;
  return 2 / (kPi * x * y) *
         (std::log(std::sqrt(xx * yy / (xx + yy - 1))) +
          x * std::sqrt(yy) * std::atan(x / std::sqrt(yy)) +
          y * std::sqrt(xx) * std::atan(y / std::sqrt(xx)) - x * std::atan(x) - y * std::atan(y));
}

/// From a rectangle of width w to one of height h at a right angle, along a common edge of 1.
double adjoining(double w, double h) {
  const double hh = h * h, ww = w * w, sum = hh + ww;
  const double a = (1 + ww) * (1 + hh) / (1 + sum);
  const double b = std::pow(ww * (1 + sum) / ((1 + ww) * sum), ww);
  const double c = std::pow(hh * (1 + sum) / ((1 + hh) * sum), hh);
  return (w * std::atan(1 / w) + h * std::atan(1 / h) -
          std::sqrt(sum) * std::atan(1 / std::sqrt(sum)) + std::log(a * b * c) / 4) /
         (kPi * w);
}

/// The side on which a cell of the room's shell lies; -1 at edges, which see no other wall.
int wallOf(glm::ivec3 cell) {
  int wall = -1;
  for (int axis = 0; axis < 3; ++axis) {
    const int low[3] = {4, 0, 2};
    if (cell[axis] == 0) wall = wall < 0 ? low[axis] : 6;
    if (cell[axis] == kRoom[axis] + 1) wall = wall < 0 ? low[axis] + 1 : 6;
  }
  return wall == 6 ? -1 : wall;
}

/// One wall glows, all are black.
TraceScene roomLitBy(int wall) {
  Cubes cubes = test::roomOf(kRoom, {});
  for (auto& [cell, cube] : cubes) {
    if (wallOf(cell) == wall) cube.radiance = glm::vec3(1);
  }
  return test::sceneOf(cubes);
}

Estimate floorReceives(const TraceScene& scene, const TraceSettings& settings) {
  const PathTracer tracer(scene, {}, settings);
  RayCounts counts;
  return test::estimate(400000, [&](std::uint32_t i) {
    SampleRandom random(3, 0, i);
    const glm::ivec3 cell(1 + int(i) % kRoom.x, 0, 1 + int(i) / kRoom.x % kRoom.z);
    const TraceSurface surface = test::surfaceOn(cell, FaceDirection::Up, random.pair());
    return double(tracer.incoming(surface, random, counts).r);
  });
}

TEST(FormFactors, of_every_wall_as_seen_from_the_floor) {
  const double x = kRoom.x, y = kRoom.y, z = kRoom.z;
  // By FaceDirection: down up north south west east.
  const std::array<double, 6> expected{0,
                                       facing(x / y, z / y),
                                       adjoining(z / x, y / x),
                                       adjoining(z / x, y / x),
                                       adjoining(x / z, y / z),
                                       adjoining(x / z, y / z)};
  double sum = 0;
  for (const double factor : expected) sum += factor;
  ASSERT_NEAR(sum, 1, 1e-9) << "the formulas of the test itself";
  for (int wall = 1; wall < 6; ++wall) {
    const Estimate result = floorReceives(roomLitBy(wall), {});
    EXPECT_NEAR(result.mean, expected[std::size_t(wall)], 4 * result.error) << "wall " << wall;
    EXPECT_LT(result.error, 0.002 * result.mean + 1e-4);
  }
}

/// What a point with this normal gets from a rectangle over the corner (0,0) at height h.
double cornerFactor(double a, double b, double h) {
  const double p = a / h, q = b / h;
  return (p / std::sqrt(1 + p * p) * std::atan(q / std::sqrt(1 + p * p)) +
          q / std::sqrt(1 + q * q) * std::atan(p / std::sqrt(1 + q * q))) /
         (2 * kPi);
}

double lampFactor(double x, double z, double h, double x0, double x1, double z0, double z1) {
  const auto part = [&](double a, double b) {
    const double sign = (a < 0 ? -1 : 1) * (b < 0 ? -1 : 1);
    return sign * cornerFactor(std::abs(a), std::abs(b), h);
  };
  return part(x1 - x, z1 - z) - part(x0 - x, z1 - z) - part(x1 - x, z0 - z) + part(x0 - x, z0 - z);
}

/// Room with a lamp of 4 x 4 in its ceiling, albedo .5 below, seen from the ceiling's height.
TraceScene lampRoom() {
  Cubes cubes = test::roomOf(kRoom, {});
  for (auto& [cell, cube] : cubes) {
    const bool lamp =
        cell.y == kRoom.y + 1 && cell.x >= 6 && cell.x < 10 && cell.z >= 5 && cell.z < 9;
    if (lamp) cube.radiance = glm::vec3(16);
    if (cell.y == 0) cube.albedo = glm::vec3(0.5f);
  }
  return test::sceneOf(cubes);
}

// Every pixel of a picture of the floor against the lamp's form factor at its point.
TEST(DirectLight, of_a_lamp_is_the_analytic_picture) {
  const TraceScene scene = lampRoom();
  TraceCamera camera;
  camera.width = 14;
  camera.height = 13;
  camera.position = {8, 8, 7.5};
  // Looks straight down with a field of view in which pixels are cells of the floor, 7 below.
  camera.modelViewInverse = glm::mat4(1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1);
  camera.projectionInverse = glm::mat4(1);
  camera.projectionInverse[0][0] = 1;
  camera.projectionInverse[1][1] = 13.0f / 14;
  camera.projectionInverse[2] = glm::vec4(0, 0, 0, 0);
  camera.projectionInverse[3] = glm::vec4(0, 0, -1, 1);
  TraceSettings settings;
  settings.bounces = 1;
  const TraceFilm film = trace(scene, camera, settings, 4096, 2);
  double squares = 0, noise = 0;
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      const double expected = 0.5 * 16 * lampFactor(1.5 + x, 1.5 + y, kRoom.y, 6, 10, 5, 9);
      const double a = film.half(0, x, y).g, b = film.half(1, x, y).g;
      EXPECT_NEAR((a + b) / 2, expected, 0.03 * expected) << x << "," << y;
      squares += std::pow(((a + b) / 2 - expected) / expected, 2);
      noise += std::pow((a - b) / 2 / expected, 2);
    }
  }
  const double pixels = camera.width * camera.height;
  EXPECT_LT(std::sqrt(squares / pixels), 0.01);
  EXPECT_LT(squares, 1.5 * noise) << "an error beyond the noise that the halves tell";
}

}  // namespace
}  // namespace orris
