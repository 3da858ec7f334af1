#include "world/mesh/block_mesh.h"

#include <fmt/core.h>
#include <malloc.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <set>

#include "core/add_diagnostic.h"
#include "core/parallel.h"
#include "world/mesh/block_faces.h"
#include "world/mesh/face_light.h"
#include "world/mesh/mesh_states.h"
#include "world/mesh/model_dice.h"
#include "world/resources/block_look.h"

namespace orris {
namespace {

/// The faces of one section by layer.
struct SectionFaces {
  std::array<std::vector<BlockVertex>, kRenderLayers> vertices;
  std::array<std::vector<MeshSection>, kRenderLayers> sections;  // `first` counts from `vertices`
};

class SectionMesher {
 public:
  SectionMesher(const MeshInput& input, const MeshStates& states, const FaceLighting& lighting)
      : input_(input), states_(states), lighting_(lighting) {}

  SectionFaces build(glm::ivec3 origin) {
    if (!isBuried(origin)) addSection(origin);
    return std::move(faces_);
  }

 private:
  /// A section of one state that shows no face: air, or stone among stone.
  bool isBuried(glm::ivec3 origin) const {
    const auto only = input_.blocks.uniformSection(origin);
    if (!only) return false;
    if (*only == 0) return true;
    if (states_[*only].coveredSides != 0x3f || !states_[*only].fluid.empty()) return false;
    for (int side = 0; side < 6; ++side) {
      const glm::ivec3 beside = origin + normalOf(FaceDirection(side)) * kSectionSize;
      const auto other = input_.blocks.uniformSection(beside);
      const bool whole = input_.blocks.contains(beside) &&
                         input_.blocks.contains(beside + kSectionSize - 1);
      if (!other || !whole || !states_[*other].hides(opposite(FaceDirection(side)))) return false;
    }
    return true;
  }

  void addSection(glm::ivec3 origin) {
    const glm::ivec3 low = glm::max(origin, input_.blocks.origin());
    const glm::ivec3 end =
        glm::min(origin + kSectionSize, input_.blocks.origin() + input_.blocks.size());
    for (int y = low.y; y < end.y; ++y) {
      for (int z = low.z; z < end.z; ++z) {
        for (int x = low.x; x < end.x; ++x) addCell({x, y, z}, origin);
      }
    }
    for (std::size_t i = 0; i < faces_.vertices.size(); ++i) {
      if (RenderLayer(i) == RenderLayer::BlockEntity) {
        addBlockEntities(origin);
      } else if (const std::size_t count = faces_.vertices[i].size(); count > 0) {
        faces_.sections[i].push_back({origin, RenderLayer(i), 0, std::uint32_t(count)});
      }
    }
  }

  // Those of one state together: each draw has one blockEntityId.
  void addBlockEntities(glm::ivec3 origin) {
    constexpr auto kLayer = std::size_t(RenderLayer::BlockEntity);
    std::vector<BlockVertex>& vertices = faces_.vertices[kLayer];
    std::stable_sort(vertices.begin(), vertices.end(),
                     [](const auto& a, const auto& b) { return a.state < b.state; });
    for (std::size_t start = 0, end; start < vertices.size(); start = end) {
      end = start;
      while (end < vertices.size() && vertices[end].state == vertices[start].state) ++end;
      faces_.sections[kLayer].push_back({origin, RenderLayer::BlockEntity, std::uint32_t(start),
                                   std::uint32_t(end - start), vertices[start].state});
    }
  }

  void addCell(glm::ivec3 cell, glm::ivec3 origin) {
    const std::uint32_t index = input_.blocks.indexAt(cell);
    if (index == 0) return;
    const MeshState& state = states_[index];
    addFaces(state.block.faces, cell, origin, index);
    if (!state.parts.empty()) addModel(state, cell, origin, index);
    if (!state.fluid.empty()) addFluidFaces(state, cell, origin);
  }

  void addModel(const MeshState& state, glm::ivec3 cell, glm::ivec3 origin, std::uint32_t index) {
    const ModelDice dice(cell, state.multipart);
    for (const MeshChoice& part : state.parts)
      addFaces(*part.alternatives[dice.choose(part.weights)], cell, origin, index);
  }

  void addFaces(const std::vector<BlockFace>& faces, glm::ivec3 cell, glm::ivec3 origin,
                std::uint32_t index) {
    for (const BlockFace& face : faces) {
      if (!isHidden(face, cell, index)) addFace(face, cell, origin, index, false);
    }
  }

  bool isHidden(const BlockFace& face, glm::ivec3 cell, std::uint32_t index) const {
    if (!face.cull) return false;
    const std::uint32_t other = input_.blocks.indexAt(cell + normalOf(*face.cull));
    const MeshState& neighbour = states_[other];
    const FaceDirection side = opposite(*face.cull);
    if (neighbour.hides(side)) return true;
    const auto& palette = input_.blocks.palette();
    const bool same = states_[index].cullsSame && palette[index].name == palette[other].name;
    if (!same && !neighbour.block.hidesBehind) return false;
    const auto& covered = neighbour.block.covered[std::size_t(side)];
    return std::any_of(covered.begin(), covered.end(),
                       [&](const SideRectangle& area) { return area.covers(face.side); });
  }

  void addFluidFaces(const MeshState& state, glm::ivec3 cell, glm::ivec3 origin) {
    const bool submerged = stateAt(cell + glm::ivec3(0, 1, 0)).fluid == state.fluid;
    for (const BlockFace& face : submerged ? state.fluidFull : state.fluidSurface) {
      if (face.flush && isFluidHidden(face, cell, state, submerged)) continue;
      addFace(face, cell, origin, state.fluidState, true);
    }
  }

  bool isFluidHidden(const BlockFace& face, glm::ivec3 cell, const MeshState& state,
                     bool submerged) const {
    const glm::ivec3 beside = cell + normalOf(face.direction);
    const MeshState& neighbour = stateAt(beside);
    if (neighbour.hides(opposite(face.direction))) return true;
    if (neighbour.fluid != state.fluid) return false;
    if (face.direction == FaceDirection::Down || face.direction == FaceDirection::Up) return true;
    // A lower surface beside leaves a step to be seen.
    const bool besideSubmerged = stateAt(beside + glm::ivec3(0, 1, 0)).fluid == state.fluid;
    return (besideSubmerged ? 1 : neighbour.height) >= (submerged ? 1 : state.height);
  }

  const MeshState& stateAt(glm::ivec3 cell) const { return states_[input_.blocks.indexAt(cell)]; }

  void addFace(const BlockFace& face, glm::ivec3 cell, glm::ivec3 origin, std::uint32_t index,
               bool fluid) {
    const BlockFacts& facts = input_.facts[index];
    const std::array<CornerLight, 4> light = lighting_.corners(face, cell);
    const glm::u8vec3 colour = colourOf(face, facts, index, cell);
    const RenderLayer layer = layerOf(face, facts);
    std::vector<BlockVertex>& vertices = faces_.vertices[std::size_t(layer)];
    for (std::size_t i = 0; i < 4; ++i) {
      const float occlusion = 1 - input_.ambientOcclusionLevel * (1 - light[i].occlusion);
      const glm::ivec3 toMiddle(glm::clamp(
          glm::round((glm::vec3(0.5f) - face.corners[i]) * 64.0f), -128.0f, 127.0f));
      BlockVertex vertex;
      vertex.position = glm::vec3(cell - origin) + face.corners[i];
      vertex.uv = face.uv[i];
      vertex.midUv = face.midUv;
      vertex.normal = face.normal;
      vertex.tangent = face.tangent;
      vertex.tint = glm::u8vec4(colour, std::lround(occlusion * 255));
      vertex.light = {std::lround(light[i].block), std::lround(light[i].sky)};
      vertex.midBlock = glm::i8vec4(toMiddle, facts.emission);
      vertex.state = std::uint16_t(index);
      vertex.fluid = fluid ? 1 : 0;
      vertices.push_back(vertex);
    }
  }

  glm::u8vec3 colourOf(const BlockFace& face, const BlockFacts& facts, std::uint32_t index,
                       glm::ivec3 cell) const {
    if (!face.tinted) return glm::u8vec3(255);
    if (!input_.look) return plainsTint(facts.tint);
    return modelTint(input_.blocks.palette()[index], facts, face.tintIndex, input_.look->tintAt(cell));
  }

  static RenderLayer layerOf(const BlockFace& face, const BlockFacts& facts) {
    if (facts.blockEntity) return RenderLayer::BlockEntity;
    return face.seeThrough && facts.layer == RenderLayer::Solid ? RenderLayer::Cutout : facts.layer;
  }

  const MeshInput& input_;
  const MeshStates& states_;
  const FaceLighting& lighting_;
  SectionFaces faces_;
};

std::vector<glm::ivec3> sectionsOf(const BlockWorld& blocks) {
  std::vector<glm::ivec3> origins;
  const glm::ivec3 low = sectionOrigin(blocks.origin()), end = blocks.origin() + blocks.size();
  for (int x = low.x; x < end.x; x += kSectionSize) {
    for (int y = low.y; y < end.y; y += kSectionSize) {
      for (int z = low.z; z < end.z; z += kSectionSize) origins.emplace_back(x, y, z);
    }
  }
  return origins;
}

/// By layer, then in the order of the parts, whose memory is given back as they are taken.
BlockMesh joinParts(std::vector<SectionFaces>& parts) {
  BlockMesh mesh;
  std::size_t total = 0;
  for (const SectionFaces& part : parts) {
    for (const auto& vertices : part.vertices) total += vertices.size();
  }
  mesh.vertices.reserve(total);
  for (std::size_t layer = 0; layer < std::size_t(kRenderLayers); ++layer) {
    for (SectionFaces& part : parts) {
      const auto start = std::uint32_t(mesh.vertices.size());
      const std::vector<BlockVertex> vertices = std::move(part.vertices[layer]);
      mesh.vertices.insert(mesh.vertices.end(), vertices.begin(), vertices.end());
      for (MeshSection section : part.sections[layer]) {
        section.first += start;
        mesh.sections.push_back(section);
      }
    }
  }
  return mesh;
}

}  // namespace

BlockMesh buildMesh(const MeshInput& input) {
  const MeshStates states(input);
  const FaceLighting lighting(input.blocks, input.light, input.facts);
  const std::vector<glm::ivec3> origins = sectionsOf(input.blocks);
  std::vector<SectionFaces> parts(origins.size());
  forEachInParallel(origins.size(), [&](std::size_t i) {
    parts[i] = SectionMesher(input, states, lighting).build(origins[i]);
  });
  BlockMesh mesh = joinParts(parts);
  parts.clear();
  // What many threads allocated in small pieces stays with the process unless it is asked for.
  malloc_trim(0);
  return mesh;
}

void warnOfUnknown(const BlockWorld& blocks, const std::vector<BlockFacts>& facts,
                   Diagnostics& diagnostics) {
  std::set<std::string> unknown;
  for (std::size_t i = 0; i < facts.size(); ++i) {
    const std::string& name = blocks.palette()[i].name;
    if (facts[i].known || !unknown.insert(name).second) continue;
    addWarning(
        diagnostics, "unknown-block", {},
        fmt::format("the block \"{}\" is not known: drawn as a cube with the missing texture",
                    name));
  }
}

std::vector<BlockFacts> factsOfPalette(const BlockTable& table, const BlockWorld& blocks,
                                       Diagnostics& diagnostics) {
  std::vector<BlockFacts> facts;
  for (const BlockState& state : blocks.palette()) facts.push_back(table.factsOf(state));
  warnOfUnknown(blocks, facts, diagnostics);
  return facts;
}

std::vector<std::string> texturesOf(const std::vector<BlockFacts>& facts) {
  std::set<std::string> names;
  for (const BlockFacts& fact : facts) {
    for (const ShapeBox& box : fact.boxes) {
      for (const std::string& texture : box.textures) {
        if (!texture.empty()) names.insert(texture);
      }
    }
  }
  return {names.begin(), names.end()};
}

}  // namespace orris
