// One model file of a resource pack, as it stands in JSON.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <orris/core/diagnostic.h>
#include <orris/world/blocks/block_facts.h>
#include <orris/world/resources/resource_stack.h>

namespace orris {

struct FaceTemplate {
  std::string texture;                       ///< a variable, "#side"
  std::optional<std::array<float, 4>> uv{};  ///< u0 v0 u1 v1 in sixteenths; nullopt: from the place
  int rotation = 0;                          ///< degrees, of the texture, clockwise
  std::optional<FaceDirection> cull{};
  int tintIndex = -1;
};

/// About axes through a point: x first, then y, then z.
struct ElementTurn {
  glm::vec3 origin{8};  ///< sixteenths of a block
  glm::vec3 degrees{0};
  bool rescale = false;  ///< stretched so that it covers the block again
};

struct ElementTemplate {
  glm::vec3 from{0}, to{16};  ///< sixteenths of a block, -16..32
  std::optional<ElementTurn> turn{};
  bool shade = true;  ///< the game darkens its sides by their direction
  std::array<std::optional<FaceTemplate>, 6> faces{};  ///< by FaceDirection
};

/// Where an item is seen as its model's "display" says.
enum class DisplayPlace { FirstRight, FirstLeft, ThirdRight, ThirdLeft, Ground, Fixed };
inline constexpr std::size_t kDisplayPlaces = 6;

/// How the model is put there: made larger about its middle, turned about z, then y, then x, and moved.
struct DisplayPose {
  glm::vec3 degrees{0};
  glm::vec3 translation{0};  ///< sixteenths of a block
  glm::vec3 scale{1};
};
using DisplayPoses = std::array<std::optional<DisplayPose>, kDisplayPlaces>;  ///< by DisplayPlace

struct ModelFile {
  std::string place;  ///< for messages
  std::string parent;
  SourceLocation parentAt{};
  std::map<std::string, std::string> textures;  ///< by variable: a texture or "#variable"
  std::optional<std::vector<ElementTemplate>> elements{};
  std::optional<bool> ambientOcclusion{};
  DisplayPoses display{};
};

/// nullopt and warnings: the file is no model. What the game ignores in a model is not read.
std::optional<ModelFile> parseModel(const ResourceFile& file, Diagnostics& diagnostics);

}  // namespace orris
