// What is in a world, counted: the contents of `orris world`.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <orris/world/mesh/block_mesh.h>

namespace orris {

struct BlockCount {
  BlockState state;
  std::int64_t count = 0;
  int emission = 0;   ///< 0..15
  bool known = true;  ///< false: drawn with the fallback
};

struct WorldSummary {
  glm::ivec3 origin{0}, size{0};
  std::int64_t blocks = 0;         ///< other than air
  std::vector<BlockCount> states;  ///< other than air, most frequent first, then by name
  std::array<std::int64_t, kRenderLayers> faces{};  ///< by RenderLayer
  std::int64_t lights = 0;                          ///< blocks that emit light
  std::vector<std::string> unknown;                 ///< block names without facts, sorted
};

/// `facts` by palette index of `blocks`.
WorldSummary summarize(const BlockWorld& blocks, const std::vector<BlockFacts>& facts,
                       const BlockMesh& mesh);

}  // namespace orris
