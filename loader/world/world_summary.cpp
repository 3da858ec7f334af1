#include <orris/world/world_summary.h>

#include <algorithm>
#include <set>

namespace orris {
namespace {

std::vector<std::int64_t> countStates(const BlockWorld& blocks) {
  std::vector<std::int64_t> counts(blocks.palette().size());
  const glm::ivec3 low = blocks.origin(), end = low + blocks.size();
  for (int y = low.y; y < end.y; ++y) {
    for (int z = low.z; z < end.z; ++z) {
      for (int x = low.x; x < end.x; ++x) ++counts[blocks.indexAt({x, y, z})];
    }
  }
  return counts;
}

}  // namespace

WorldSummary summarize(const BlockWorld& blocks, const std::vector<BlockFacts>& facts,
                       const BlockMesh& mesh) {
  WorldSummary summary;
  summary.origin = blocks.origin();
  summary.size = blocks.size();
  const std::vector<std::int64_t> counts = countStates(blocks);
  std::set<std::string> unknown;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] == 0 || facts[i].air) continue;
    const BlockState& state = blocks.palette()[i];
    summary.states.push_back({state, counts[i], facts[i].emission, facts[i].known});
    summary.blocks += counts[i];
    if (facts[i].emission > 0) summary.lights += counts[i];
    if (!facts[i].known) unknown.insert(state.name);
  }
  std::sort(summary.states.begin(), summary.states.end(),
            [](const BlockCount& a, const BlockCount& b) {
              return a.count != b.count ? a.count > b.count : a.state < b.state;
            });
  summary.unknown.assign(unknown.begin(), unknown.end());
  for (const MeshSection& section : mesh.sections) {
    summary.faces[std::size_t(section.layer)] += section.count / 4;
  }
  return summary;
}

}  // namespace orris
