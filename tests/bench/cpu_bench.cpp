// What the host does before any GL call: reading a pack, and turning a world into faces.
#include <benchmark/benchmark.h>

#include <memory>

#include <orris/core/files/file_source.h>
#include <orris/pack/shader_pack.h>
#include <orris/render/scene/gpu_scene.h>
#include <orris/world/world.h>

namespace {

const char* const kPack = ORRIS_SOURCE_DIR "/shaderpack";

void loadPack(benchmark::State& state) {
  orris::Diagnostics diagnostics;
  const std::shared_ptr<const orris::FileSource> files = orris::openPack(kPack, diagnostics);
  orris::LoadRequest request;
  request.environment = orris::standardMacros({});
  for (auto _ : state) {
    auto pack = orris::loadShaderPack(files, request, diagnostics);
    if (!pack) state.SkipWithError("the pack does not load");
    benchmark::DoNotOptimize(pack);
  }
}
BENCHMARK(loadPack)->Unit(benchmark::kMillisecond);

void meshWorld(benchmark::State& state, const char* name) {
  orris::Diagnostics diagnostics;
  const auto world =
      orris::loadWorld(std::string(ORRIS_SOURCE_DIR "/worlds/") + name, 0, diagnostics);
  if (!world) return state.SkipWithError("the world does not load");
  orris::SceneData scene = orris::buildScene(*world, {}, diagnostics);
  for (auto _ : state) orris::rebuildMesh(scene, {});
  state.counters["faces"] = double(scene.mesh.faces.size());
}
BENCHMARK_CAPTURE(meshWorld, cornell, "cornell")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(meshWorld, hills, "hills")->Unit(benchmark::kMillisecond);

}  // namespace
