#include <algorithm>
#include <set>

#include "frame/gpu_scene.h"

namespace orris {

SceneContents SceneData::contents() const {
  const auto has = [&](RenderLayer layer) {
    return std::any_of(mesh.sections.begin(), mesh.sections.end(),
                       [&](const MeshSection& s) { return s.layer == layer && s.count > 0; });
  };
  SceneContents contents;
  contents.solid = has(RenderLayer::Solid);
  contents.cutout = has(RenderLayer::Cutout);
  contents.translucent = has(RenderLayer::Translucent);
  contents.sky = world.environment.dimension != "minecraft:the_nether";
  return contents;
}

EyeSurroundings SceneData::surroundings(const glm::dvec3& position) const {
  const glm::ivec3 cell(glm::floor(position));
  EyeSurroundings eye;
  eye.brightness = {light->block(cell) * 16, light->sky(cell) * 16};
  const std::uint32_t index = world.blocks.indexAt(cell);
  if (facts[index].fluid)
    eye.fluid = world.blocks.palette()[index].name == "minecraft:lava" ? 2 : 1;
  return eye;
}

void rebuildMesh(SceneData& scene, float ambientOcclusionLevel) {
  scene.light = std::make_unique<LightLevels>(scene.world.blocks, scene.facts);
  scene.mesh = buildMesh(
      {scene.world.blocks, scene.facts, *scene.light, scene.atlas, ambientOcclusionLevel});
}

SceneData buildScene(World world, float ambientOcclusionLevel, Diagnostics& diagnostics) {
  SceneData scene;
  scene.world = std::move(world);
  // States that events will place later join the palette now, so the atlas holds their textures.
  for (const Event& event : scene.world.events)
    if (const auto* set = std::get_if<SetBlock>(&event.action))
      scene.world.blocks.paletteIndex(set->state);
  const BlockTable table;
  scene.facts = factsOfPalette(table, scene.world.blocks, diagnostics);
  scene.atlas = buildAtlas(texturesOf(scene.facts));
  rebuildMesh(scene, ambientOcclusionLevel);
  return scene;
}

}  // namespace orris
