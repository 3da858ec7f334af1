// A world as a frame takes it: facts, atlas, light and mesh. No GL in it.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <orris/pack/shader_pack.h>
#include <orris/plan/frame/frame_state.h>
#include <orris/plan/lists/content_scene.h>
#include <orris/plan/schedule/schedule.h>
#include <orris/world/mesh/block_mesh.h>
#include <orris/world/resources/block_look.h>
#include <orris/world/world.h>

namespace orris {

/// Everything about a world that does not change between edits; no GL in it.
struct SceneData {
  World world;
  std::vector<BlockFacts> facts;  ///< by palette index
  BlockAtlas atlas;
  std::unique_ptr<const BlockLook> look;  ///< of the world's resource packs; nullptr: our own
  std::unique_ptr<const BiomeTints> tints;  ///< of our own look; nullptr: those of the plains
  std::unique_ptr<LightLevels> light;
  BlockMesh mesh;
  ContentScene content;
  /// Kinds of geometry that an engine submits (render/scene/engine_geometry.h) in place of blocks and content.
  std::optional<GeometrySet> submitted{};

  SceneContents contents() const;
  /// What the eye at `position` stands in.
  EyeSurroundings surroundings(const glm::dvec3& position) const;
};

/// What of a pack changes the mesh.
struct MeshStyle {
  float ambientOcclusionLevel = 1;
  /// Block name -> "solid", "cutout" or "translucent": layer.* of block.properties.
  std::map<std::string, std::string> renderLayers{};
  bool operator==(const MeshStyle&) const = default;
};
MeshStyle meshStyleOf(const ShaderPack& pack);

/// Facts, atlas, light and mesh of a world; unknown blocks and mistakes in its resource packs are warnings.
SceneData buildScene(World world, const MeshStyle& style, Diagnostics& diagnostics);
/// Light and mesh again after blocks changed.
void rebuildMesh(SceneData& scene, const MeshStyle& style);

/// mc_Entity.x of each palette entry.
std::vector<int> blockIdsOf(const ShaderPack& pack, const BlockWorld& blocks);

}  // namespace orris
