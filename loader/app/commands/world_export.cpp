#include "app/commands/world_export.h"

#include <filesystem>

#include "app/commands/trace_scene_input.h"
#include "app/input/inputs.h"
#include <orris/trace/export/gltf_scene.h>

namespace orris {

bool checkExportPath(const std::string& path, Report& report) {
  const std::string ending = std::filesystem::path(path).extension();
  if (ending == ".glb" || ending == ".gltf") return checkWritable(path, report);
  report.error("export-format", "no format of export has this ending",
               "use .glb, or .gltf for text", path);
  return false;
}

void exportWorld(World world, const PackOptions& pack, const std::string& path, Report& report) {
  const auto reference = openReferencePack(pack, report);
  if (!reference) return;
  const std::string name = world.name;
  const std::vector<Camera> cameras = world.cameras;
  std::vector<std::string> states;
  for (const BlockState& state : world.blocks.palette()) states.push_back(state.toString());
  Diagnostics diagnostics;
  // A picture's size changes nothing of the scene.
  const ReferenceScene scene =
      buildReferenceScene(std::move(world), *reference, cameras.at(0), 16, 9, diagnostics);
  // Those of the world's blocks are reported already.
  diagnostics.clear();
  const auto gltf = makeGltf({name, scene.scene, states, cameras}, path, diagnostics);
  report.add(diagnostics);
  if (!gltf) return;
  const bool binary = std::filesystem::path(path).extension() == ".glb";
  writeWholeFile(path, binary ? glbFile(*gltf) : gltfFile(*gltf), report);
}

}  // namespace orris
