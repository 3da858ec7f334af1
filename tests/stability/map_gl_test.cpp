// Numbers for the picture of docs/accuracy.md, by stability_map.py; nothing is asserted here.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "lab.h"

namespace orris::test {
namespace {

constexpr int kSteps = 4;  // few enough for half floats

TEST(map, DISABLED_gain_over_alpha_and_gamma) {
  for (double gamma = 1; gamma <= 3; gamma += 0.125)
    for (double alpha = 0.5; alpha <= 3.25; alpha += 0.125) {
      Lab lab({.initial = "vec3(16.0)",
               .periodic = true,
               .constants = {{"FLOODFILL_ALPHA", fmt::format("{}", alpha)},
                             {"FLOODFILL_GAMMA", fmt::format("{:.3f}", gamma)}}});
      lab.step(kSteps);
      const double gain = std::pow(lab.light().red({16, 16, 16}) / 16, 1.0 / kSteps);
      fmt::print("gain,{},{},{:.5f}\n", gamma, alpha, gain);
    }
}

}  // namespace
}  // namespace orris::test
