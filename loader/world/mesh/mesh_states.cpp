#include <orris/world/mesh/mesh_states.h>

#include <algorithm>

#include <orris/world/resources/block_look.h>

namespace orris {
namespace {

constexpr const char* kWater = "minecraft:water";

/// 8/9 of a block for a source or falling fluid, less for flowing ones.
float fluidHeight(const BlockState& state) {
  const std::string_view level = state.property("level", "0");
  const int flowed = level.size() == 1 && level[0] >= '0' && level[0] <= '7' ? level[0] - '0' : 0;
  return float(8 - flowed) / 9;
}

FaceShape faceShapeOf(const BlockFace& face) {
  FaceShape shape{face.corners, face.uv, {}, face.midUv, face.normal, face.tangent, face.shade};
  for (std::size_t i = 0; i < face.corners.size(); ++i)
    shape.toMiddle[i] = glm::i8vec3(
        glm::clamp(glm::round((glm::vec3(0.5f) - face.corners[i]) * 64.0f), -128.0f, 127.0f));
  return shape;
}

}  // namespace

MeshStates::MeshStates(const MeshInput& input) : input_(input) {
  const std::vector<BlockState>& palette = input_.blocks.palette();
  const auto water = std::find_if(palette.begin(), palette.end(), [](const BlockState& state) {
    return state.name == kWater && state.property("level", "0") == "0";
  });
  for (std::size_t i = 0; i < palette.size(); ++i) {
    const BlockFacts& facts = input_.facts[i];
    MeshState& state = states_.emplace_back();
    state.block = makeBlockFaces(facts, input_.atlas);
    if (input_.look) addModel(state, input_.look->models[i], facts.emission > 0);
    state.block.faces = withShapes(std::move(state.block.faces));
    state.coveredSides = facts.coveredFaces;
    state.cullsSame = facts.cullsSame;
    if (facts.fluid) {
      // Bubble columns and flowing water join with still water.
      const bool isWater = facts.tint == Tint::Water;
      addFluid(state, isWater ? kWater : palette[i].name, i, fluidHeight(palette[i]));
    } else if (facts.waterlogged && water != palette.end()) {
      addFluid(state, kWater, std::size_t(water - palette.begin()), 8.0f / 9);
    }
    const std::vector<BlockFace>& faces = state.block.faces;
    state.hiddenByCubes =
        state.parts.empty() && state.fluid.empty() &&
        std::all_of(faces.begin(), faces.end(), [](const BlockFace& face) { return face.cull.has_value(); });
  }
}

void MeshStates::addModel(MeshState& state, const BlockModel& model, bool emits) {
  if (model.parts.empty()) return;
  state.block.faces.clear();
  state.multipart = model.multipart;
  for (const ModelChoice& part : model.parts) {
    MeshChoice& choice = state.parts.emplace_back();
    for (const ModelAlternative& one : part.alternatives) {
      auto& made = modelFaces_[{one.faces.get(), emits}];
      if (!made)
        made = std::make_shared<const std::vector<BlockFace>>(withShapes(
            makeModelFaces(*one.faces, emits, input_.atlas, input_.look->seeThrough)));
      choice.alternatives.push_back(made);
      choice.weights.push_back(one.weight);
    }
  }
}

void MeshStates::addFluid(MeshState& state, const std::string& name, std::size_t index,
                          float height) {
  state.fluid = name;
  state.height = height;
  state.fluidState = std::uint16_t(index);
  const BlockFacts& facts = input_.facts[index];
  const std::string flowing = flowingTexture(facts);
  state.fluidSurface = withShapes(makeFluidFaces(facts, input_.atlas, height, flowing));
  state.fluidFull = withShapes(makeFluidFaces(facts, input_.atlas, 1, flowing));
  for (std::size_t i = 0; !flowing.empty() && i < kFlowHeadings; ++i)
    state.flowing[i] =
        withShapes(makeFlowingSurface(facts, input_.atlas, height, flowing, i));
}

std::string MeshStates::flowingTexture(const BlockFacts& facts) const {
  if (!input_.look || facts.boxes.empty()) return "";
  const auto found = input_.look->flowing.find(facts.boxes[0].textures[0]);
  return found == input_.look->flowing.end() ? "" : found->second;
}

std::vector<BlockFace> MeshStates::withShapes(std::vector<BlockFace> faces) {
  for (BlockFace& face : faces) {
    face.shape = std::uint32_t(shapes_.size());
    shapes_.push_back(faceShapeOf(face));
  }
  return faces;
}

}  // namespace orris
