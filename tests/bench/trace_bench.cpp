// bench_trace WORLD...: rays per second of processor time of the path tracer on one thread, and of the bare traversal on
// the same rays; of Embree too where the build found it. One line of JSON a world.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include <orris/trace/reference_scene.h>
#include "trace_bench_embree.h"

namespace orris {
namespace {

constexpr int kWidth = 160, kHeight = 90, kSamples = 8;
constexpr int kRounds = 7;

double secondsOf(const auto& work) {
  const double start = threadSeconds();
  work();
  return threadSeconds() - start;
}

/// The best of several rounds.
double bestOf(const auto& work) {
  double best = secondsOf(work);
  for (int i = 1; i < kRounds; ++i) best = std::min(best, secondsOf(work));
  return best;
}

std::optional<ReferenceScene> open(const std::string& path) {
  Diagnostics diagnostics;
  auto world = loadWorld(path, 0, diagnostics);
  LoadRequest request;
  request.buildSources = false;
  const auto pack = loadShaderPack(memorySource(referencePackFiles()), request, diagnostics);
  if (!world || !pack) return std::nullopt;
  const Camera camera = world->cameras.front();
  return buildReferenceScene(std::move(*world), *pack, camera, kWidth, kHeight, diagnostics);
}

glm::vec3 tracePicture(const PathTracer& tracer, RayCounts& counts) {
  glm::vec3 sum(0);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const PixelView view = tracer.view(x, y, counts);
      for (std::uint32_t i = 0; i < kSamples; ++i) {
        SampleRandom random(0, std::uint32_t(y * kWidth + x), i);
        sum += tracer.sample(view, random, counts);
      }
    }
  }
  return sum;
}

void measure(const std::string& path) {
  const auto reference = open(path);
  if (!reference) {
    fmt::print(stderr, "{}: cannot be read\n", path);
    return;
  }
  const PathTracer tracer(reference->scene, reference->camera, {});
  std::vector<Ray> rays;
  RayCounts recorded;
  recorded.record = &rays;
  tracePicture(tracer, recorded);
  const double traced = bestOf([&] {
    RayCounts counts;
    tracePicture(tracer, counts);
  });
  const VoxelGrid& grid = reference->scene.grid;
  std::uint64_t met = 0;
  const double bare = bestOf([&] {
    met = 0;
    for (const Ray& ray : rays) met += grid.intersect(ray).quad != kNoQuad;
  });
  const auto count = double(rays.size());
  nlohmann::json result = {{"world", path},        {"rays", rays.size()},
                           {"hits", met},          {"tracer", count / traced},
                           {"grid", count / bare}, {"tracerOverGrid", bare / traced}};
  const EmbreeTimes embree = measureEmbree(grid, rays, kRounds);
  if (embree.present) {
    result["embree"] = count / embree.seconds;
    result["embreeHits"] = embree.hits;
    result["tracerOverEmbree"] = embree.seconds / traced;
  }
  fmt::print("{}\n", result.dump());
}

}  // namespace
}  // namespace orris

int main(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) orris::measure(argv[i]);
}
