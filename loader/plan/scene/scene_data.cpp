#include <orris/plan/scene/scene_data.h>

#include <algorithm>

#include <orris/world/blocks/block_data.h>
#include <orris/world/dimension_look.h>

namespace orris {
namespace {

RenderLayer layerNamed(std::string_view name) {
  return name == "translucent" ? RenderLayer::Translucent
         : name == "cutout"    ? RenderLayer::Cutout
                               : RenderLayer::Solid;
}

}  // namespace

SceneContents SceneData::contents() const {
  const auto has = [&](RenderLayer layer, Geometry kind) {
    if (submitted) return (*submitted & bitOf(kind)) != 0;
    return std::any_of(mesh.sections.begin(), mesh.sections.end(),
                       [&](const MeshSection& s) { return s.layer == layer && s.count > 0; });
  };
  SceneContents contents;
  contents.solid = has(RenderLayer::Solid, Geometry::Solid);
  contents.cutout = has(RenderLayer::Cutout, Geometry::Cutout);
  contents.blockEntities = has(RenderLayer::BlockEntity, Geometry::BlockEntity);
  contents.translucent = has(RenderLayer::Translucent, Geometry::Translucent);
  contents.cloudPlane = world.environment.dimension == "minecraft:overworld";
  contents.clouds = world.environment.clouds;
  contents.content =
      submitted ? *submitted & contentSet() : content.kinds | weatherOf(world.environment);
  contents.sky = hasSkylight(world.environment.dimension);
  contents.endSky = world.environment.dimension == "minecraft:the_end";
  return contents;
}

EyeSurroundings SceneData::surroundings(const glm::dvec3& position) const {
  const glm::ivec3 cell(glm::floor(position));
  EyeSurroundings eye;
  eye.brightness = {light->block(cell) * 16, light->sky(cell) * 16};
  const std::uint32_t index = world.blocks.indexAt(cell);
  eye.inBlock = !facts[index].air && !facts[index].fluid && !facts[index].cross;
  if (facts[index].fluid)
    eye.fluid = world.blocks.palette()[index].name == "minecraft:lava" ? 2 : 1;
  constexpr double kEyeHeight = 1.62;  // of a standing player, blocks
  const glm::ivec3 feet(glm::floor(position - glm::dvec3(0, kEyeHeight, 0)));
  const std::uint32_t below = world.blocks.indexAt(feet);
  eye.feetInWater = facts[below].fluid && world.blocks.palette()[below].name != "minecraft:lava";
  return eye;
}

MeshStyle meshStyleOf(const ShaderPack& pack) {
  return {pack.directives.ambientOcclusionLevel, pack.blockIds.renderLayers};
}

void rebuildMesh(SceneData& scene, const MeshStyle& style) {
  scene.light = std::make_unique<LightLevels>(scene.world.blocks, scene.facts,
                                              hasSkylight(scene.world.environment.dimension));
  std::vector<BlockFacts> facts = scene.facts;
  for (size_t i = 0; i < facts.size(); ++i) {
    const auto layer = style.renderLayers.find(scene.world.blocks.palette()[i].name);
    if (layer != style.renderLayers.end()) facts[i].layer = layerNamed(layer->second);
  }
  scene.mesh = buildMesh({scene.world.blocks, facts, *scene.light, scene.atlas,
                          style.ambientOcclusionLevel, scene.look.get(), scene.tints.get()});
}

namespace {

/// Facts and atlas, and what the resource packs make of them.
void setLook(SceneData& scene, const ResourceStack* resources, Diagnostics& diagnostics) {
  const BlockTable table;
  const BlockWorld& blocks = scene.world.blocks;
  if (!resources) {
    scene.facts = factsOfPalette(table, blocks, diagnostics);
    scene.atlas = buildAtlas(texturesOf(scene.facts));
    if (scene.world.biomes || scene.world.environment.biome != Environment().biome)
      scene.tints = std::make_unique<const BiomeTints>(tintsOf(scene.world, {}));
    return;
  }
  Diagnostics unknown;  // the packs may know them
  scene.facts = factsOfPalette(table, blocks, unknown);
  scene.look = std::make_unique<const BlockLook>(
      makeBlockLook(*resources, scene.world, scene.facts, scene.atlas, diagnostics));
  warnOfUnknown(blocks, scene.facts, diagnostics);
}

}  // namespace

SceneData buildScene(World world, const MeshStyle& style, Diagnostics& diagnostics) {
  SceneData scene;
  scene.world = std::move(world);
  // States that events will place later join the palette now, so the atlas holds their textures.
  for (const Event& event : scene.world.events)
    if (const auto* set = std::get_if<SetBlock>(&event.action))
      scene.world.blocks.paletteIndex(set->state);
  std::optional<ResourceStack> resources;
  if (!scene.world.resourcePacks.empty())
    resources = openResources(scene.world.resourcePacks, diagnostics).value_or(ResourceStack());
  setLook(scene, resources ? &*resources : nullptr, diagnostics);
  scene.content = buildContent(scene.world, resources ? &*resources : nullptr, diagnostics);
  rebuildMesh(scene, style);
  return scene;
}

std::vector<int> blockIdsOf(const ShaderPack& pack, const BlockWorld& blocks) {
  std::vector<int> ids;
  for (const BlockState& state : blocks.palette())
    ids.push_back(pack.blockIds.idOf(state.name, wholeProperties(state)));
  return ids;
}

}  // namespace orris
