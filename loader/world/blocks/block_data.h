// blocks.json and shapes.json as values: block, shape and texture definitions after its name lists are expanded.
// The format is described in docs/block-data.md.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <orris/world/blocks/block_facts.h>

namespace orris {

using BlockProperties = std::map<std::string, std::string>;

/// "half=top,open=true|maybe": every property must have one of its values. Empty: always holds.
struct BlockCondition {
  std::vector<std::pair<std::string, std::vector<std::string>>> terms;
  bool holds(const BlockProperties& properties) const;
};

/// A box in 1/16 block. By face: the part of the texture set to use, "" the usual one for that
/// direction, "-" no face.
struct BoxTemplate {
  glm::vec3 from{0}, to{16};
  std::string faces[6];
};

/// Boxes present when a condition holds. With `around`, the boxes are given for north and repeated
/// for each horizontal direction whose property has one of these values.
struct ShapePart {
  BlockCondition when;
  std::vector<std::string> around;
  std::vector<BoxTemplate> boxes;
};

/// `rotate` names the property that turns a shape given for north; `stand` the one that lays down a
/// shape given standing up. `flip` mirrors it top to bottom.
struct ShapeTemplate {
  std::string rotate, stand;
  std::optional<BlockCondition> flip;
  bool cross = false;
  std::vector<ShapePart> parts;
};

/// What a definition or one of its variants says; unset members leave the value as it is.
struct FactsPatch {
  std::optional<std::string> shape;
  std::map<std::string, std::string> textures;  ///< by part: all, side, end, top, bottom, front...
  std::optional<int> emission, opacity;
  std::optional<RenderLayer> layer;
  std::optional<Tint> tint;
  std::optional<bool> air, fluid, cullsSame, waterlogged, blockEntity;
};

struct BlockDefinition {
  BlockProperties defaults;
  FactsPatch base;
  std::vector<std::pair<BlockCondition, FactsPatch>> variants;  ///< later ones win
};

/// A texture: the recipe that draws it and its parameters.
struct TextureDefinition {
  std::string recipe;
  std::vector<glm::u8vec4> colours;
  std::map<std::string, float> numbers;
  std::string base;              ///< texture under the art, "" for none
  std::vector<std::string> art;  ///< rows of colour indices (0-9, a-z), else empty; one fills a row
};

struct BlockData {
  std::map<std::string, BlockDefinition> blocks;  ///< without "minecraft:"
  std::map<std::string, ShapeTemplate> shapes;
  std::map<std::string, TextureDefinition> textures;
};

/// The data file compiled into the library, read once.
const BlockData& blockData();

/// nullptr: the block is unknown.
const BlockDefinition* definitionOf(const std::string& name);

/// The properties of a state, as the game has them: those that it does not name have their default. Of unknown
/// blocks what is named.
BlockProperties wholeProperties(const BlockState& state);

}  // namespace orris
