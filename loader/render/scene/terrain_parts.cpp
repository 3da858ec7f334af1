#include <orris/render/scene/terrain_parts.h>

#include <algorithm>

namespace orris {

std::vector<TerrainPart> terrainParts(const std::vector<MeshSection>& sections, std::uint32_t most) {
  std::vector<TerrainPart> parts(1);
  for (const MeshSection& section : sections) {
    if (parts.back().count > 0 && parts.back().count + section.count > most)
      parts.push_back({section.first, 0});
    parts.back().count += section.count;
  }
  return parts;
}

std::size_t partOf(const std::vector<TerrainPart>& parts, const MeshSection& section) {
  const auto after = std::upper_bound(
      parts.begin(), parts.end(), section.first,
      [](std::uint32_t first, const TerrainPart& part) { return first < part.first; });
  return std::size_t(after - parts.begin()) - 1;
}

}  // namespace orris
