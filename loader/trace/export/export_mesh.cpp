#include <orris/trace/export/export_mesh.h>

#include <algorithm>
#include <map>

namespace orris {
namespace {

ExportMaterial exportMaterialOf(const TraceScene& scene, const TraceQuad& quad) {
  ExportMaterial material;
  material.state = quad.state;
  material.alpha = quad.translucent   ? ExportAlpha::Blend
                   : quad.alphaTested ? ExportAlpha::Mask
                                      : ExportAlpha::Opaque;
  material.emission = quad.emission;
  material.doubleSided = quad.twin != kNoQuad;
  material.thin = quad.thin;
  material.water = quad.water;
  material.filters = quad.filters;
  if (quad.emission > 0) material.emissionTint = quad.tint;
  if (quad.lamp != kNoQuad) material.radiance = scene.lamps.face(quad.lamp).radiance;
  return material;
}

void appendQuad(const TraceQuad& quad, glm::vec2 texels, ExportPart& part) {
  static constexpr glm::vec2 kCorners[4] = {{0, 0}, {0, 1}, {1, 1}, {1, 0}};
  static constexpr std::uint32_t kTriangles[6] = {0, 1, 2, 2, 3, 0};
  const std::uint32_t first = std::uint32_t(part.positions.size());
  for (const glm::vec2& at : kCorners) {
    part.positions.push_back(quad.corner + quad.edgeU * at.x + quad.edgeV * at.y);
    part.normals.push_back(quad.normal);
    part.uvs.push_back((quad.uvCorner + quad.uvU * at.x + quad.uvV * at.y) / texels);
    part.tints.push_back(quad.tint);
  }
  for (const std::uint32_t corner : kTriangles) part.indices.push_back(first + corner);
}

}  // namespace

std::vector<ExportPart> exportParts(const TraceScene& scene) {
  const std::vector<TraceQuad>& quads = scene.grid.quads();
  const glm::vec2 texels(scene.grid.texture().width, scene.grid.texture().height);
  std::map<decltype(ExportMaterial().key()), ExportPart> parts;
  for (std::uint32_t i = kHiddenQuad + 1; i < quads.size(); ++i) {
    if (quads[i].twin != kNoQuad && quads[i].twin < i) continue;
    const ExportMaterial material = exportMaterialOf(scene, quads[i]);
    ExportPart& part = parts[material.key()];
    part.material = material;
    appendQuad(quads[i], texels, part);
  }
  std::vector<ExportPart> result;
  for (auto& [key, part] : parts) {
    const bool white = std::all_of(part.tints.begin(), part.tints.end(),
                                   [](const glm::vec3& tint) { return tint == glm::vec3(1); });
    if (white || part.material.emission > 0) part.tints.clear();
    result.push_back(std::move(part));
  }
  return result;
}

}  // namespace orris
