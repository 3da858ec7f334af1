#include <orris/trace/grid/scene_quads.h>

#include <algorithm>
#include <array>
#include <tuple>

#include <orris/plan/scene/gpu_vertex.h>
#include <orris/trace/light/pack_lighting.h>
#include <orris/world/atlas/atlas_levels.h>

namespace orris {
namespace {

int faceOf(const glm::vec3& normal) {
  for (int face = 0; face < 6; ++face) {
    if (glm::dot(normal, glm::vec3(normalOf(FaceDirection(face)))) > 0.99f) return face;
  }
  return -1;
}

PlacedQuad placeQuad(const std::array<BlockVertex, 4>& v, const MeshSection& section,
                     glm::vec2 texels) {
  const glm::vec3 origin(section.origin);
  PlacedQuad placed;
  placed.cell =
      glm::ivec3(glm::floor(origin + v[0].position + glm::vec3(glm::ivec3(v[0].midBlock)) / 64.0f));
  placed.face = faceOf(v[0].normal);
  TraceQuad& quad = placed.quad;
  quad.corner = origin + v[0].position;
  quad.edgeU = v[3].position - v[0].position;
  quad.edgeV = v[1].position - v[0].position;
  quad.normal = glm::normalize(v[0].normal);
  const glm::vec2 u = (v[3].uv - v[0].uv) * texels, w = (v[1].uv - v[0].uv) * texels;
  quad.uvCorner = v[0].uv * texels + (u + w) * (kUvInset / 2);
  quad.uvU = u * (1 - kUvInset);
  quad.uvV = w * (1 - kUvInset);
  quad.tint = packToLinear(glm::vec3(glm::ivec3(v[0].tint)) / 255.0f);
  quad.state = v[0].state;
  quad.emission = std::uint8_t(glm::clamp(int(v[0].midBlock.w), 0, 15));
  quad.alphaTested = section.layer == RenderLayer::Cutout;
  quad.translucent = section.layer == RenderLayer::Translucent;
  return placed;
}

}  // namespace

TraceTexture linearTexture(const Image8& image) {
  TraceTexture texture{image.width, image.height, {}};
  std::array<float, 256> linear{};
  for (int i = 0; i < 256; ++i) linear[std::size_t(i)] = packToLinear(glm::vec3(float(i) / 255)).x;
  const std::vector<Image8> levels = atlasLevels(image, TraceTexture::kLevels);
  for (std::size_t level = 0; level < levels.size(); ++level) {
    const std::vector<std::uint8_t>& bytes = levels[level].pixels;
    for (std::size_t i = 0; i + 3 < bytes.size(); i += 4)
      texture.levels[level].emplace_back(linear[bytes[i]], linear[bytes[i + 1]],
                                         linear[bytes[i + 2]], float(bytes[i + 3]) / 255);
  }
  return texture;
}

std::vector<PlacedQuad> placeQuads(const BlockMesh& mesh, const BlockAtlas& atlas) {
  const glm::vec2 texels(atlas.albedo.width, atlas.albedo.height);
  std::vector<PlacedQuad> placed;
  placed.reserve(mesh.faces.size());
  for (const MeshSection& section : mesh.sections) {
    for (std::uint32_t i = 0; i + 3 < section.count; i += 4)
      placed.push_back(placeQuad(mesh.quad(section.first + i), section, texels));
  }
  std::stable_sort(placed.begin(), placed.end(), [](const PlacedQuad& a, const PlacedQuad& b) {
    return std::tie(a.cell.y, a.cell.z, a.cell.x, a.face) <
           std::tie(b.cell.y, b.cell.z, b.cell.x, b.face);
  });
  return placed;
}

glm::vec4 meanTexel(const TraceTexture& texture, const TraceQuad& quad) {
  constexpr int kSteps = 16;
  glm::vec3 color(0);
  float alpha = 0;
  int kept = 0;
  for (int i = 0; i < kSteps * kSteps; ++i) {
    const glm::vec2 at((float(i % kSteps) + 0.5f) / kSteps, (float(i / kSteps) + 0.5f) / kSteps);
    const glm::vec4 texel = texture.at(quad.uvCorner + quad.uvU * at.x + quad.uvV * at.y);
    color += glm::vec3(texel) * texel.a;
    alpha += texel.a;
    kept += texel.a >= kAlphaTest;
  }
  return {color / std::max(alpha, 1e-3f) * quad.tint, float(kept) / (kSteps * kSteps)};
}

bool isUnitSide(const PlacedQuad& placed) {
  return placed.face >= 0 && glm::dot(placed.quad.edgeU, placed.quad.edgeU) == 1 &&
         glm::dot(placed.quad.edgeV, placed.quad.edgeV) == 1;
}

}  // namespace orris
