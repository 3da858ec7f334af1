#include <orris/world/mesh/casters.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <tuple>

namespace orris {
namespace {

/// Share of opaque texels of a part of the atlas; each part is looked at once.
class Coverage {
 public:
  explicit Coverage(const BlockAtlas& atlas) : image_(atlas.albedo) {}

  float of(const std::array<BlockVertex, 4>& v) {
    glm::vec2 low = v[0].uv, high = v[0].uv;
    for (std::size_t i = 1; i < v.size(); ++i) {
      low = glm::min(low, v[i].uv);
      high = glm::max(high, v[i].uv);
    }
    const glm::vec2 size(image_.width, image_.height);
    const glm::ivec2 first = texel(low * size + 0.01f), last = texel(high * size - 0.01f);
    const auto [known, fresh] = shares_.try_emplace({first.x, first.y, last.x, last.y}, 0.0f);
    if (fresh) known->second = shareOf(first, last);
    return known->second;
  }

 private:
  glm::ivec2 texel(const glm::vec2& at) const {
    return glm::clamp(glm::ivec2(glm::floor(at)), glm::ivec2(0),
                      glm::ivec2(image_.width - 1, image_.height - 1));
  }

  float shareOf(const glm::ivec2& first, const glm::ivec2& last) const {
    int opaque = 0, all = 0;
    for (int y = first.y; y <= last.y; ++y)
      for (int x = first.x; x <= last.x; ++x, ++all)
        opaque += float(image_.at(x, y)[3]) / 255 >= kCasterAlpha;
    return all == 0 ? 0 : float(opaque) / float(all);
  }

  const Image8& image_;
  std::map<std::tuple<int, int, int, int>, float> shares_;
};

/// Blocks that are mostly holes on some side: their frames and edges alone are no casters.
std::set<std::uint16_t> openStates(const BlockMesh& mesh, Coverage& coverage) {
  std::set<std::uint16_t> open;
  for (const MeshSection& section : mesh.sections) {
    if (section.layer != RenderLayer::Cutout) continue;
    for (std::uint32_t i = 0; i + 3 < section.count; i += 4) {
      const auto v = mesh.quad(section.first + i);
      if (coverage.of(v) < kCasterCoverage) open.insert(v[0].state);
    }
  }
  return open;
}

glm::ivec3 middleOf(const BlockMesh& mesh) {
  glm::ivec3 low(std::numeric_limits<int>::max()), high(std::numeric_limits<int>::min());
  for (const MeshSection& section : mesh.sections) {
    low = glm::min(low, section.origin);
    high = glm::max(high, section.origin);
  }
  return mesh.sections.empty() ? glm::ivec3(0) : low + (high - low) / 2;
}

}  // namespace

CasterSet castersOf(const BlockMesh& mesh, const BlockAtlas& atlas) {
  CasterSet set;
  set.origin = middleOf(mesh);
  Coverage coverage(atlas);
  const std::set<std::uint16_t> open = openStates(mesh, coverage);
  set.faces.reserve(mesh.faces.size());
  for (const MeshSection& section : mesh.sections) {
    if (section.layer == RenderLayer::Translucent) continue;
    const glm::vec3 offset(section.origin - set.origin);
    for (std::uint32_t i = 0; i + 3 < section.count; i += 4) {
      const MeshFace& made = mesh.faces[(section.first + i) / 4];
      const FaceShape& shape = mesh.shapes[made.shape];
      CasterFace face;
      face.seeThrough = section.layer != RenderLayer::Solid;
      if (face.seeThrough && open.count(made.state) != 0) continue;
      for (std::size_t k = 0; k < 4; ++k)
        face.corners[k] = offset + (glm::vec3(made.cell) + shape.corners[k]);
      face.normal = glm::normalize(shape.normal);
      set.faces.push_back(face);
    }
  }
  return set;
}

CasterSet castersOfLamp(const CasterSet& casters, const glm::ivec3& cell, double range) {
  constexpr float kInside = 0.01f;
  const glm::ivec3 own = cell - casters.origin;
  const glm::vec3 lamp = glm::vec3(own) + 0.5f;
  CasterSet near;
  near.origin = casters.origin;
  for (const CasterFace& face : casters.faces) {
    const glm::vec3 middle = (face.corners[0] + face.corners[2]) * 0.5f;
    if (glm::ivec3(glm::floor(middle - face.normal * kInside)) == own) continue;
    glm::vec3 low = face.corners[0], high = low;
    for (const glm::vec3& corner : face.corners) {
      low = glm::min(low, corner);
      high = glm::max(high, corner);
    }
    if (glm::distance(glm::clamp(lamp, low, high), lamp) <= range) near.faces.push_back(face);
  }
  return near;
}

}  // namespace orris
