// Worlds, facts and meshes made in a line, for the tests of this folder.
#pragma once

#include <string>
#include <vector>

#include <orris/world/files/world_json.h>
#include <orris/world/mesh/block_mesh.h>

namespace orris {

inline std::string joined(const Diagnostics& diagnostics) {
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics) {
    if (!text.empty()) text += '\n';
    text += formatDiagnostic(diagnostic);
  }
  return text;
}

/// The world that `text` describes; `errors` are the formatted diagnostics, "" when there are none.
struct ParsedWorld {
  std::optional<World> world;
  std::string errors;
};

inline ParsedWorld parseWorld(const std::string& text, const WorldFileReader& readFile = nullptr,
                              unsigned seed = 0) {
  Diagnostics diagnostics;
  ParsedWorld parsed;
  parsed.world = parseWorldJson({text, "world.json", "unnamed", seed, readFile}, diagnostics);
  parsed.errors = joined(diagnostics);
  return parsed;
}

inline BlockState blockState(const std::string& text) { return parseBlockState(text).value(); }

/// A mesh beside all of its vertices.
struct ReadMesh : BlockMesh {
  ReadMesh(BlockMesh mesh) : BlockMesh(std::move(mesh)) {
    for (std::size_t i = 0; i < vertexCount(); i += 4)
      for (const BlockVertex& vertex : quad(i)) vertices.push_back(vertex);
  }
  std::vector<BlockVertex> vertices;
};

/// Blocks of a box at (0,0,0) and all that is made of them.
struct Scene {
  explicit Scene(glm::ivec3 size, glm::ivec3 origin = glm::ivec3(0)) : blocks(origin, size) {}

  void set(glm::ivec3 at, const std::string& state) {
    blocks.set(at, blocks.paletteIndex(blockState(state)));
  }
  void fill(glm::ivec3 from, glm::ivec3 to, const std::string& state) {
    blocks.fill(from, to, blocks.paletteIndex(blockState(state)));
  }
  std::vector<BlockFacts> facts() const {
    Diagnostics diagnostics;
    return factsOfPalette(BlockTable(), blocks, diagnostics);
  }
  LightLevels light() const { return LightLevels(blocks, facts()); }
  ReadMesh mesh(float ambientOcclusionLevel = 1) const {
    const std::vector<BlockFacts> known = facts();
    const LightLevels levels(blocks, known);
    const BlockAtlas atlas = buildAtlas(texturesOf(known));
    return buildMesh({blocks, known, levels, atlas, ambientOcclusionLevel});
  }

  BlockWorld blocks;
};

inline std::size_t faceCount(const BlockMesh& mesh) { return mesh.faces.size(); }

}  // namespace orris
