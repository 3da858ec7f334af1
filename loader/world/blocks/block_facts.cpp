#include <orris/world/blocks/block_facts.h>

#include <algorithm>
#include <string_view>

#include <orris/world/blocks/block_data.h>
#include <orris/world/blocks/shape_boxes.h>

namespace orris {
namespace {

template <class T>
void overwrite(std::optional<T>& target, const std::optional<T>& source) {
  if (source) target = source;
}

void apply(FactsPatch& target, const FactsPatch& patch) {
  overwrite(target.shape, patch.shape);
  overwrite(target.emission, patch.emission);
  overwrite(target.opacity, patch.opacity);
  overwrite(target.layer, patch.layer);
  overwrite(target.tint, patch.tint);
  overwrite(target.air, patch.air);
  overwrite(target.fluid, patch.fluid);
  overwrite(target.cullsSame, patch.cullsSame);
  overwrite(target.waterlogged, patch.waterlogged);
  overwrite(target.blockEntity, patch.blockEntity);
  for (const auto& [part, texture] : patch.textures) target.textures[part] = texture;
}

bool isFullCube(const std::vector<ShapeBox>& boxes) {
  return std::any_of(boxes.begin(), boxes.end(), [](const ShapeBox& box) {
    return box.from == glm::vec3(0) && box.to == glm::vec3(16);
  });
}

/// Textures drawn grey say so in the data file; the others keep their own colour.
void markTintedFaces(std::vector<ShapeBox>& boxes) {
  const auto& textures = blockData().textures;
  for (ShapeBox& box : boxes) {
    for (int face = 0; face < 6; ++face) {
      const auto found = textures.find(box.textures[face]);
      if (found != textures.end() && found->second.numbers.count("tinted") != 0) {
        box.tintedFaces = std::uint8_t(box.tintedFaces | (1u << face));
      }
    }
  }
}

BlockFacts factsFrom(const FactsPatch& spec, const BlockProperties& properties) {
  BlockFacts facts;
  facts.air = spec.air.value_or(false);
  facts.fluid = spec.fluid.value_or(false);
  facts.cullsSame = spec.cullsSame.value_or(false);
  facts.blockEntity = spec.blockEntity.value_or(false);
  facts.emission = spec.emission.value_or(0);
  facts.layer = spec.layer.value_or(RenderLayer::Solid);
  facts.tint = spec.tint.value_or(Tint::None);
  const auto waterlogged = properties.find("waterlogged");
  facts.waterlogged = spec.waterlogged.value_or(false) ||
                      (waterlogged != properties.end() && waterlogged->second == "true");
  if (!facts.air) {
    const ShapeTemplate& shape = blockData().shapes.at(spec.shape.value_or("cube"));
    facts.cross = shape.cross;
    facts.boxes = boxesOf(shape, properties, spec.textures);
    if (facts.tint != Tint::None) markTintedFaces(facts.boxes);
    facts.coveredFaces = facts.layer == RenderLayer::Solid && !facts.cross && !facts.fluid
                             ? coveredFacesOf(facts.boxes)
                             : 0;
  }
  const bool solid = facts.layer == RenderLayer::Solid && !facts.cross && !facts.fluid;
  facts.fullOpaqueCube = solid && isFullCube(facts.boxes);
  // What stands in water dims light as water does.
  facts.opacity = spec.opacity.value_or(facts.fullOpaqueCube ? 15 : facts.waterlogged ? 1 : 0);
  return facts;
}

/// What an unknown block looks like: a cube of the checker texture.
BlockFacts unknownBlock() {
  FactsPatch spec;
  spec.textures["all"] = "missing";
  BlockFacts facts = factsFrom(spec, {});
  facts.known = false;
  return facts;
}

void collectTextures(const BlockDefinition& definition, std::set<std::string>& names) {
  bool laidDown = false;
  std::vector<const FactsPatch*> patches{&definition.base};
  for (const auto& [when, patch] : definition.variants) patches.push_back(&patch);
  for (const FactsPatch* patch : patches) {
    laidDown |= !blockData().shapes.at(patch->shape.value_or("cube")).stand.empty();
  }
  if (definition.base.air.value_or(false)) return;
  for (const FactsPatch* patch : patches) {
    for (const auto& [part, texture] : patch->textures) {
      names.insert(texture);
      if (laidDown) names.insert(texture + "@90");
    }
  }
}

}  // namespace

glm::ivec3 normalOf(FaceDirection direction) {
  constexpr glm::ivec3 kNormals[] = {{0, -1, 0}, {0, 1, 0},  {0, 0, -1},
                                     {0, 0, 1},  {-1, 0, 0}, {1, 0, 0}};
  return kNormals[int(direction)];
}

struct BlockTable::Impl {
  std::vector<std::string> textureNames;
};

BlockTable::BlockTable() : impl_(std::make_unique<Impl>()) {
  std::set<std::string> names{"missing"};
  for (const auto& [name, definition] : blockData().blocks) collectTextures(definition, names);
  impl_->textureNames.assign(names.begin(), names.end());
}

BlockTable::~BlockTable() = default;

BlockFacts BlockTable::factsOf(const BlockState& state) const {
  const BlockDefinition* definition = definitionOf(state.name);
  if (!definition) return unknownBlock();
  const BlockProperties properties = wholeProperties(state);
  FactsPatch spec = definition->base;
  for (const auto& [when, patch] : definition->variants) {
    if (when.holds(properties)) apply(spec, patch);
  }
  return factsFrom(spec, properties);
}

const std::vector<std::string>& BlockTable::textureNames() const { return impl_->textureNames; }

}  // namespace orris
