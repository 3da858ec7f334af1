#include <orris/world/mesh/block_mesh.h>

#include <fmt/core.h>
#include <malloc.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

#include <orris/core/add_diagnostic.h>
#include <orris/core/parallel.h>
#include <orris/world/mesh/face_light.h>
#include <orris/world/mesh/mesh_states.h>
#include <orris/world/mesh/model_dice.h>
#include <orris/world/mesh/section_cells.h>
#include <orris/world/resources/block_look.h>

namespace orris {
namespace {

/// The faces of one section by layer.
struct SectionFaces {
  std::array<std::vector<MeshFace>, kRenderLayers> faces;
  std::array<std::vector<MeshSection>, kRenderLayers> sections;  // `first` counts from those faces
};

class SectionMesher {
 public:
  SectionMesher(const MeshInput& input, const MeshStates& states, const FaceLighting& lighting)
      : input_(input), states_(states), lighting_(lighting) {}

  SectionFaces build(glm::ivec3 origin, SectionLinks& links) {
    if (const auto only = uniformStateOf(origin)) links = linksOfUniform(*only);
    if (isBuried(origin)) return {};
    cells_.emplace(input_.blocks, origin);
    if (!uniformStateOf(origin)) links = linksOf(opaqueCells(origin));
    addSection(origin);
    return std::move(made_);
  }

 private:
  static constexpr std::uint8_t kAllSides = 0x3f;

  /// nullopt, too, for a section that the world has only a part of.
  std::optional<std::uint32_t> uniformStateOf(glm::ivec3 origin) const {
    const bool whole = input_.blocks.contains(origin) && input_.blocks.contains(origin + kSectionSize - 1);
    return whole ? input_.blocks.uniformSection(origin) : std::nullopt;
  }

  SectionLinks linksOfUniform(std::uint32_t state) const {
    SectionLinks links;
    if (states_[state].coveredSides == kAllSides) links.from.fill(0);
    return links;
  }

  OpaqueCells opaqueCells(glm::ivec3 origin) const {
    OpaqueCells opaque;
    for (int y = 0; y < kSectionSize; ++y)
      for (int z = 0; z < kSectionSize; ++z)
        for (int x = 0; x < kSectionSize; ++x) {
          const glm::ivec3 cell(x, y, z);
          if (stateAt(origin + cell).coveredSides == kAllSides) opaque.set(indexOfCell(cell));
        }
    return opaque;
  }

  /// A section of one state that shows no face: air, or stone among stone.
  bool isBuried(glm::ivec3 origin) const {
    const auto only = input_.blocks.uniformSection(origin);
    if (!only) return false;
    if (*only == 0) return true;
    if (states_[*only].coveredSides != kAllSides || !states_[*only].fluid.empty()) return false;
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
    for (std::size_t i = 0; i < made_.faces.size(); ++i) {
      if (RenderLayer(i) == RenderLayer::BlockEntity) {
        addBlockEntities(origin);
      } else if (const std::size_t count = made_.faces[i].size(); count > 0) {
        made_.sections[i].push_back({origin, RenderLayer(i), 0, std::uint32_t(count * 4)});
      }
    }
  }

  // Those of one state together: each draw has one blockEntityId.
  void addBlockEntities(glm::ivec3 origin) {
    constexpr auto kLayer = std::size_t(RenderLayer::BlockEntity);
    std::vector<MeshFace>& faces = made_.faces[kLayer];
    std::stable_sort(faces.begin(), faces.end(),
                     [](const auto& a, const auto& b) { return a.state < b.state; });
    for (std::size_t start = 0, end; start < faces.size(); start = end) {
      end = start;
      while (end < faces.size() && faces[end].state == faces[start].state) ++end;
      made_.sections[kLayer].push_back({origin, RenderLayer::BlockEntity, std::uint32_t(start * 4),
                                        std::uint32_t((end - start) * 4), faces[start].state});
    }
  }

  void addCell(glm::ivec3 cell, glm::ivec3 origin) {
    const std::uint32_t index = cells_->at(cell);
    if (index == 0) return;
    const MeshState& state = states_[index];
    if (state.hiddenByCubes && isWalledIn(cell)) return;
    addFaces(state.block.faces, cell, origin, index);
    if (!state.parts.empty()) addModel(state, cell, origin, index);
    if (!state.fluid.empty()) addFluidFaces(state, cell, origin);
  }

  bool isWalledIn(glm::ivec3 cell) const {
    return stateAt(cell + glm::ivec3(0, -1, 0)).hides(FaceDirection::Up) &&
           stateAt(cell + glm::ivec3(0, 1, 0)).hides(FaceDirection::Down) &&
           stateAt(cell + glm::ivec3(0, 0, -1)).hides(FaceDirection::South) &&
           stateAt(cell + glm::ivec3(0, 0, 1)).hides(FaceDirection::North) &&
           stateAt(cell + glm::ivec3(-1, 0, 0)).hides(FaceDirection::East) &&
           stateAt(cell + glm::ivec3(1, 0, 0)).hides(FaceDirection::West);
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
    const std::uint32_t other = cells_->at(cell + normalOf(*face.cull));
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
    const auto heading = submerged ? std::nullopt : headingOf(cell, state);
    for (const BlockFace& face : submerged ? state.fluidFull : state.fluidSurface) {
      const bool surface = face.normal.y != 0 && !face.flush;
      if (face.flush && isFluidHidden(face, cell, state, submerged)) continue;
      if (!surface || !heading) addFace(face, cell, origin, state.fluidState, true);
    }
    if (!heading) return;
    for (const BlockFace& face : state.flowing[*heading])
      addFace(face, cell, origin, state.fluidState, true);
  }

  /// Where the surface flows to, as the game has it: down the differences in height to what is beside.
  std::optional<std::size_t> headingOf(glm::ivec3 cell, const MeshState& state) const {
    if (state.flowing[0].empty()) return std::nullopt;
    constexpr float kSource = 8.0f / 9;
    glm::vec2 flow(0);
    for (const glm::ivec3 step : {glm::ivec3(1, 0, 0), {-1, 0, 0}, {0, 0, 1}, {0, 0, -1}}) {
      const MeshState& beside = stateAt(cell + step);
      const MeshState& under = stateAt(cell + step - glm::ivec3(0, 1, 0));
      float fall = 0;
      if (beside.fluid == state.fluid)
        fall = state.height - beside.height;
      else if (beside.fluid.empty() && beside.coveredSides == 0 && under.fluid == state.fluid)
        fall = state.height - (under.height - kSource);
      flow += glm::vec2(step.x, step.z) * fall;
    }
    if (glm::dot(flow, flow) < 1e-6f) return std::nullopt;
    constexpr float kTurn = 6.2831853f;
    return std::size_t(std::lround(std::atan2(flow.y, flow.x) / kTurn * float(kFlowHeadings))) %
           kFlowHeadings;
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

  const MeshState& stateAt(glm::ivec3 cell) const { return states_[cells_->at(cell)]; }

  void addFace(const BlockFace& face, glm::ivec3 cell, glm::ivec3 origin, std::uint32_t index,
               bool fluid) {
    const BlockFacts& facts = input_.facts[index];
    const std::array<CornerLight, 4> light = lighting_.corners(face, cell);
    MeshFace made{face.shape, std::uint16_t(index), std::uint8_t(facts.emission),
                  std::uint8_t(fluid ? 1 : 0), glm::u8vec3(cell - origin),
                  colourOf(face, facts, index, cell), {}, {}};
    for (std::size_t i = 0; i < 4; ++i) {
      const float occlusion = 1 - input_.ambientOcclusionLevel * (1 - light[i].occlusion);
      made.occlusion[i] = std::uint8_t(std::lround(occlusion * 255));
      made.light[i] = {std::lround(light[i].block), std::lround(light[i].sky)};
    }
    made_.faces[std::size_t(layerOf(face, facts))].push_back(made);
  }

  glm::u8vec3 colourOf(const BlockFace& face, const BlockFacts& facts, std::uint32_t index,
                       glm::ivec3 cell) const {
    if (!face.tinted) return glm::u8vec3(255);
    if (input_.look)
      return modelTint(input_.blocks.palette()[index], facts, face.tintIndex, input_.look->tints.at(cell));
    return input_.tints ? biomeColor(facts.tint, input_.tints->at(cell)) : plainsTint(facts.tint);
  }

  static RenderLayer layerOf(const BlockFace& face, const BlockFacts& facts) {
    if (facts.blockEntity) return RenderLayer::BlockEntity;
    return face.seeThrough && facts.layer == RenderLayer::Solid ? RenderLayer::Cutout : facts.layer;
  }

  const MeshInput& input_;
  const MeshStates& states_;
  const FaceLighting& lighting_;
  std::optional<SectionCells> cells_;  ///< of the section being built
  SectionFaces made_;
};

/// In the order of sectionsOf().
SectionGrid gridOf(const BlockWorld& blocks) {
  SectionGrid grid;
  grid.origin = sectionOrigin(blocks.origin());
  grid.size = (sectionOrigin(blocks.origin() + blocks.size() - 1) - grid.origin) / kSectionSize + 1;
  grid.links.resize(std::size_t(grid.size.x) * std::size_t(grid.size.y) * std::size_t(grid.size.z));
  return grid;
}

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
    for (const auto& faces : part.faces) total += faces.size();
  }
  mesh.faces.reserve(total);
  for (std::size_t layer = 0; layer < std::size_t(kRenderLayers); ++layer) {
    for (SectionFaces& part : parts) {
      const auto start = std::uint32_t(mesh.vertexCount());
      const std::vector<MeshFace> faces = std::move(part.faces[layer]);
      mesh.faces.insert(mesh.faces.end(), faces.begin(), faces.end());
      for (MeshSection section : part.sections[layer]) {
        section.first += start;
        mesh.sections.push_back(section);
      }
    }
  }
  return mesh;
}

}  // namespace

std::array<BlockVertex, 4> BlockMesh::quad(std::size_t first) const {
  const MeshFace& face = faces[first / 4];
  const FaceShape& shape = shapes[face.shape];
  std::array<BlockVertex, 4> quad;
  for (std::size_t i = 0; i < quad.size(); ++i)
    quad[i] = {glm::vec3(face.cell) + shape.corners[i],
               shape.uv[i],
               shape.midUv,
               shape.normal,
               shape.tangent,
               glm::u8vec4(face.tint, face.occlusion[i]),
               face.light[i],
               glm::i8vec4(shape.toMiddle[i], face.emission),
               face.state,
               face.fluid,
               shape.shade};
  return quad;
}

BlockMesh buildMesh(const MeshInput& input) {
  MeshStates states(input);
  const FaceLighting lighting(input.blocks, input.light, input.facts);
  const std::vector<glm::ivec3> origins = sectionsOf(input.blocks);
  std::vector<SectionFaces> parts(origins.size());
  SectionGrid grid = gridOf(input.blocks);
  forEachInParallel(origins.size(), [&](std::size_t i) {
    parts[i] = SectionMesher(input, states, lighting).build(origins[i], grid.links[i]);
  });
  BlockMesh mesh = joinParts(parts);
  mesh.grid = std::move(grid);
  mesh.shapes = states.takeShapes();
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
