// The quads of the path tracer by material, as triangles.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <tuple>
#include <vector>

#include <orris/trace/trace_scene.h>

namespace orris {

enum class ExportAlpha { Opaque, Mask, Blend };

/// What all faces of one material share.
struct ExportMaterial {
  std::uint16_t state = 0;    ///< palette index
  ExportAlpha alpha = ExportAlpha::Opaque;
  std::uint8_t emission = 0;  ///< light level 0..15
  bool doubleSided = false;   ///< two quads of one place, each seen from its side
  bool thin = false, water = false;
  bool filters = false;            ///< tints light at its faces and not by the distance inside
  glm::vec3 emissionTint{1};       ///< linear, times the texture; of a lamp
  glm::vec3 radiance{0};           ///< that its fronts send to other surfaces
  auto key() const {
    return std::tuple(state, alpha, emission, doubleSided, filters, emissionTint.x, emissionTint.y,
                      emissionTint.z);
  }
};

/// Faces of one material: four vertices each, (0,1,2)(2,3,0) counter-clockwise seen from outside.
struct ExportPart {
  ExportMaterial material;
  std::vector<glm::vec3> positions;  ///< grid space, blocks
  std::vector<glm::vec3> normals;
  std::vector<glm::vec2> uvs;      ///< atlas, 0..1, (0,0) top left
  std::vector<glm::vec3> tints;    ///< linear; empty: white everywhere
  std::vector<std::uint32_t> indices;
};

/// In the order of palette indices. Of two quads in one place the first is kept.
std::vector<ExportPart> exportParts(const TraceScene& scene);

}  // namespace orris
