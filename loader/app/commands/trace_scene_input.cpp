#include "app/commands/trace_scene_input.h"

#include "app/input/inputs.h"

namespace orris {

std::optional<ShaderPack> openReferencePack(const PackOptions& options, Report& report) {
  const std::shared_ptr<const FileSource> files = memorySource(referencePackFiles());
  auto request = makeLoadRequest(files, options, {}, report);
  if (!request) return std::nullopt;
  request->buildSources = false;
  return loadPack(files, *request, report);
}

std::optional<ReferenceScene> openReferenceScene(const PackOptions& packOptions,
                                                 const SceneOptions& scene,
                                                 const ImageOptions& image, Report& report) {
  auto world = loadScene(scene, packOptions.dimension, report);
  if (!world) return std::nullopt;
  const auto pack = openReferencePack(packOptions, report);
  const auto camera = pack ? chooseCamera(*world, scene.camera, report) : std::nullopt;
  if (!camera) return std::nullopt;
  Diagnostics diagnostics;
  auto result = buildReferenceScene(std::move(*world), *pack, *camera, image.width, image.height,
                                    diagnostics);
  report.add(diagnostics);
  return result;
}

}  // namespace orris
