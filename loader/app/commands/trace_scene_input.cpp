#include "app/commands/trace_scene_input.h"

#include "app/input/inputs.h"

namespace orris {

std::optional<ShaderPack> openReferencePack(const PackOptions& options, Report& report,
                                            int& status) {
  const std::shared_ptr<const FileSource> files = memorySource(referencePackFiles());
  auto request = makeLoadRequest(files, options, {}, report, status);
  if (!request) return std::nullopt;
  request->buildSources = false;
  return loadPack(files, *request, report, status);
}

std::optional<ReferenceScene> openReferenceScene(const PackOptions& packOptions,
                                                 const SceneOptions& scene,
                                                 const ImageOptions& image, Report& report,
                                                 int& status) {
  auto world = loadScene(scene, packOptions.dimension, report, status);
  if (!world) return std::nullopt;
  const auto pack = openReferencePack(packOptions, report, status);
  const auto camera = pack ? chooseCamera(*world, scene.camera, report, status) : std::nullopt;
  if (!camera) return std::nullopt;
  Diagnostics diagnostics;
  auto result = buildReferenceScene(std::move(*world), *pack, *camera, image.width, image.height,
                                    diagnostics);
  report.add(diagnostics);
  return result;
}

}  // namespace orris
