// The world on the GPU: terrain vertices, sky shapes, the fullscreen quad, and the host's own
// textures (atlas, lightmap, noise).
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <orris/gl/buffer.h>
#include <orris/gl/texture.h>
#include <orris/pack/shader_pack.h>
#include <orris/plan/frame/clouds.h>
#include <orris/plan/frame/frame_state.h>
#include <orris/plan/frame/visible_sections.h>
#include <orris/plan/scene/gpu_vertex.h>
#include <orris/plan/lists/draw_lists.h>
#include <orris/plan/scene/scene_data.h>
#include <orris/plan/schedule/schedule.h>
#include <orris/plan/scene/shapes.h>
#include <orris/render/scene/animated_tiles.h>
#include <orris/render/scene/terrain_parts.h>
#include <orris/world/mesh/block_mesh.h>

namespace orris {

/// The clouds that were drawn last, on the GPU.
struct CloudLayer {
  bool fancy = false;
  std::vector<CloudPart> parts;
  gl::Buffer buffer;
};

class GpuScene {
 public:
  GpuScene(const SceneData& scene, const std::vector<int>& blockIds, const VertexStyle& style);
  /// New vertices for the same world.
  void uploadMesh(const SceneData& scene, const std::vector<int>& blockIds,
                  const VertexStyle& style);

  const gl::Texture& atlas() const { return atlas_; }
  const gl::Texture& normals() const { return normals_; }
  const gl::Texture& specular() const { return specular_; }
  const gl::Texture& lightmap() const { return lightmap_; }
  const gl::Texture& white() const { return white_; }
  const gl::Texture& endSky() const { return endSky_; }        ///< of the End alone
  const gl::Texture& celestial() const { return celestial_; }  ///< sun left half, moon right half
  /// Of content (plan/lists/): made only of what the scene has; 1x1 white where there is none.
  const gl::Texture& sheet(Sheet sheet) const;
  const gl::Texture& contentNormals() const { return contentNormals_; }
  const gl::Texture& contentSpecular() const { return contentSpecular_; }
  /// The vertices of a frame's draw lists, for bindLists().
  void uploadLists(const DrawLists& lists);
  void bindLists() const;
  /// For drawQuads() of vertices that are not the scene's.
  void reserveQuads(unsigned quads) { needIndices(quads); }
  void bindIndices() const;
  glm::ivec2 atlasSize() const { return {atlas_.width, atlas_.height}; }
  const std::vector<MeshSection>& sections() const { return sections_; }
  /// Those that are seen from `eye` (world blocks), which is in no block; the same while the eye stays in its section.
  const VisibleSections& seenFrom(const glm::dvec3& eye);
  /// The id that block.properties gives a palette index, -1 for none.
  int blockId(std::uint16_t state) const {
    return state < blockIds_.size() ? blockIds_[state] : -1;
  }

  /// Does a palette index give light?
  bool emits(std::uint16_t state) const { return state < emits_.size() && emits_[state]; }

  void updateLightmap(const FrameState& state);
  /// Shows animated textures as they are at that time.
  void animate(const FrameState& state);
  /// The buffer of the terrain that holds a section.
  std::size_t terrainPart(const MeshSection& section) const { return partOf(parts_, section); }
  void bindTerrain(std::size_t part) const;
  /// Draws a section; its part of the terrain must be bound.
  void drawSection(const MeshSection& section, bool patches) const;
  void bindShapes() const;
  /// Made when first asked for.
  const CloudLayer& clouds(bool fancy);
  void bindClouds() const;
  /// Orders the translucent quads of each section from far to near as seen from `eye` (world blocks),
  /// as blending needs; free while neither eye nor mesh has moved.
  void sortTranslucent(const glm::dvec3& eye);
  /// Draws a translucent section in that order; its part of the terrain must be bound.
  void drawSorted(const MeshSection& section, bool patches) const;
  /// Draws quads of the bound buffer; `patches` for tessellation.
  void drawQuads(const QuadRange& range, bool patches) const;

  QuadRange fullscreen, horizon, skyDisc, stars, sun, moon, endCube;

 private:
  void buildShapes();
  void buildContent(const ContentScene& content, GeometrySet kinds);
  /// Makes the index buffer serve draws of so many quads.
  void needIndices(unsigned quads);
  void collectTranslucent(const BlockMesh& mesh);
  gl::Texture contentAtlas_, contentNormals_, contentSpecular_;
  std::map<Sheet, gl::Texture> sheets_;
  gl::Texture atlas_, normals_, specular_, lightmap_, white_, celestial_, endSky_;
  gl::Buffer shapes_, lists_, indices_, sortedIndices_;
  std::vector<TerrainPart> parts_;
  std::vector<gl::Buffer> terrain_;  ///< of each part
  unsigned indexedQuads_ = 0;
  std::optional<CloudLayer> clouds_;
  AnimatedTiles animated_, animatedContent_;
  std::vector<int> blockIds_;
  std::vector<bool> emits_;
  std::vector<MeshSection> sections_;
  SectionGrid grid_;
  std::optional<glm::ivec3> seenFor_;  ///< the section of the eye
  VisibleSections seen_;               ///< of grid_
  std::vector<glm::vec3>
      translucentCenters_;         ///< of each translucent quad, relative to its section
  unsigned firstTranslucent_ = 0;  ///< vertex
  std::optional<glm::dvec3> sortedFor_;
};

/// The noise texture of packs: independent bytes, the same every run, alpha 255.
gl::Texture makeNoiseTexture(int resolution);

}  // namespace orris
