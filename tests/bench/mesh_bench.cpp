// How much faster light and mesh of a save are made on all cores than on one: bench_mesh REGION [ROUNDS]. REGION is a file
// r.X.Z.mca; all of its finished chunks are taken. Rounds alternate, and the least time of each counts: what else the machine
// does only adds.
#include <fmt/core.h>
#include <sched.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <limits>

#include <orris/plan/scene/scene_data.h>

namespace {

struct Spent {
  double passing = std::numeric_limits<double>::infinity();  ///< seconds
  double processor = std::numeric_limits<double>::infinity();
};

double processorSeconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return double(now.tv_sec) + double(now.tv_nsec) * 1e-9;
}

/// Threads that are started inherit the cores.
void measureOn(const cpu_set_t& cores, orris::SceneData& scene, Spent& least) {
  sched_setaffinity(0, sizeof cores, &cores);
  const double processor = processorSeconds();
  const auto began = std::chrono::steady_clock::now();
  orris::rebuildMesh(scene, {});
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - began;
  least.passing = std::min(least.passing, passed.count());
  least.processor = std::min(least.processor, processorSeconds() - processor);
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 2) return fmt::print("usage: bench_mesh REGION [ROUNDS]\n"), 2;
  const int rounds = count > 2 ? std::atoi(arguments[2]) : 15;
  orris::Diagnostics diagnostics;
  orris::SavePart part;
  part.radius = 16;
  auto world = orris::loadWorld(arguments[1], 0, diagnostics, part);
  if (!world) return fmt::print("{}\n", diagnostics.back().message), 2;
  orris::SceneData scene = orris::buildScene(std::move(*world), {}, diagnostics);

  cpu_set_t all, one;
  sched_getaffinity(0, sizeof all, &all);
  CPU_ZERO(&one);
  int first = 0;
  while (!CPU_ISSET(first, &all)) ++first;
  CPU_SET(first, &one);
  Spent onOne, onAll;
  for (int i = 0; i < rounds; ++i) {
    measureOn(one, scene, onOne);
    measureOn(all, scene, onAll);
  }
  fmt::print("{}, {} faces, {} rounds\n", scene.world.exercises, scene.mesh.faces.size(), rounds);
  fmt::print("one core    {:.3f} s passing, {:.3f} s processor\n", onOne.passing, onOne.processor);
  fmt::print("{} cores     {:.3f} s passing, {:.3f} s processor\n", CPU_COUNT(&all), onAll.passing,
             onAll.processor);
  fmt::print("ratio       {:.2f}\n", onOne.passing / onAll.passing);
  return 0;
}
