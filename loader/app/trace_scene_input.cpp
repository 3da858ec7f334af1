#include "app/trace_scene_input.h"

#include <cstdlib>

#include "app/inputs.h"
#include "frame/gpu_scene.h"
#include "frame/loaded_pack.h"

namespace orris {
namespace {

/// The reference pack with its options in force. Only options and block ids are wanted of it.
std::optional<ShaderPack> openReferencePack(const PackOptions& options, Report& report,
                                            int& status) {
  const std::shared_ptr<const FileSource> files = memorySource(referencePackFiles());
  auto request = makeLoadRequest(files, options, {}, report, status);
  if (!request) return std::nullopt;
  request->buildSources = false;
  return loadPack(files, *request, report, status);
}

OptionValues optionsInForce(const ShaderPack& pack) {
  OptionValues values;
  for (const auto& [name, option] : pack.options.all())
    values[name] = pack.options.value(pack.values, name);
  return values;
}

LightingInput lightingOf(const FrameState& frame, const OptionValues& options) {
  const glm::mat3 toWorld(frame.gbufferModelViewInverse);
  LightingInput lighting;
  lighting.options = options;
  lighting.sunDirection = glm::normalize(toWorld * frame.sunPosition);
  lighting.lightDirection = glm::normalize(toWorld * frame.shadowLightPosition);
  lighting.rainStrength = frame.environment.rain;
  return lighting;
}

}  // namespace

std::optional<TraceView> openTraceView(const PackOptions& packOptions, const SceneOptions& scene,
                                       const ImageOptions& image, Report& report, int& status) {
  auto world = loadScene(scene, packOptions.dimension, report, status);
  if (!world) return std::nullopt;
  const auto pack = openReferencePack(packOptions, report, status);
  const auto camera = pack ? chooseCamera(*world, scene.camera, report, status) : std::nullopt;
  if (!camera) return std::nullopt;

  const OptionValues options = optionsInForce(*pack);
  PackDirectives directives;
  directives.sunPathRotation = std::strtof(options.at("sunPathRotation").c_str(), nullptr);
  const FrameState frame = nextFrameState({.width = image.width,
                                           .height = image.height,
                                           .camera = *camera,
                                           .environment = world->environment},
                                          directives, nullptr);

  Diagnostics diagnostics;
  const SceneData data = buildScene(std::move(*world), meshStyleOf(*pack), diagnostics);
  report.add(diagnostics);
  const std::vector<int> blockIds = blockIdsOf(*pack, data.world.blocks);
  return TraceView{buildTraceScene({data.world.blocks, data.facts, blockIds, data.atlas, data.mesh,
                                    lightingOf(frame, options)}),
                   {frame.cameraPosition, frame.gbufferModelViewInverse,
                    frame.gbufferProjectionInverse, frame.width, frame.height}};
}

}  // namespace orris
