// Scenes of real blocks, as the frame meshes them.
#pragma once

#include <gtest/gtest.h>

#include <orris/trace/film/trace_run.h>
#include <orris/world/files/world_json.h>

namespace orris::test {

struct BlockScene {
  World world;
  TraceScene scene;
};

/// What a test changes of the atlas before it becomes the tracer's texture.
using EditAtlas = void (*)(BlockAtlas& atlas);

/// `ids`: block.properties by block name; unlisted: -1.
inline BlockScene blockScene(const std::string& json, const std::map<std::string, int>& ids,
                             const LightingInput& lighting, EditAtlas edit = nullptr) {
  Diagnostics diagnostics;
  auto world = parseWorldJson({.text = json, .file = "world.json"}, diagnostics);
  if (!world) return {};
  const std::vector<BlockFacts> facts = factsOfPalette(BlockTable(), world->blocks, diagnostics);
  for (const Diagnostic& diagnostic : diagnostics) ADD_FAILURE() << formatDiagnostic(diagnostic);
  BlockAtlas atlas = buildAtlas(texturesOf(facts));
  if (edit != nullptr) edit(atlas);
  const LightLevels light(world->blocks, facts);
  BlockMesh mesh = buildMesh({world->blocks, facts, light, atlas});
  // An edited atlas is meant to be seen as it is.
  for (MeshFace& face : mesh.faces)
    if (edit != nullptr) face.tint = glm::u8vec3(255);
  std::vector<int> blockIds;
  for (const BlockState& state : world->blocks.palette()) {
    const auto found = ids.find(state.name);
    blockIds.push_back(found == ids.end() ? -1 : found->second);
  }
  BlockScene result;
  result.scene = buildTraceScene({world->blocks, facts, blockIds, atlas, mesh, lighting});
  result.world = std::move(*world);
  return result;
}

}  // namespace orris::test
