// Prints the gain of a step over gamma and alpha, for the picture that stability_map.py draws.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "lab.h"

namespace orris::test {
namespace {

constexpr int kSteps = 4;  // few enough for half floats

double gainOf(double alpha, double gamma) {
  Lab lab({.initial = "vec3(16.0)",
           .periodic = true,
           .constants = {{"FLOODFILL_ALPHA", fmt::format("{}", alpha)},
                         {"FLOODFILL_GAMMA", fmt::format("{:.3f}", gamma)}}});
  lab.step(kSteps);
  return std::pow(lab.light().red({16, 16, 16}) / 16, 1.0 / kSteps);
}

}  // namespace
}  // namespace orris::test

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);  // of the checks in the lab
  for (double gamma = 1; gamma <= 3; gamma += 0.125)
    for (double alpha = 0.5; alpha <= 3.25; alpha += 0.125)
      fmt::print("{},{},{:.5f}\n", gamma, alpha, orris::test::gainOf(alpha, gamma));
}
