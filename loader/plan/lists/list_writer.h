// Collects the quads of draw lists.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>

#include <orris/plan/lists/draw_lists.h>

namespace orris {

/// Corners top left, bottom left, bottom right, top right of the texture, seen from outside.
struct ContentQuad {
  std::array<glm::vec3, 4> corners{};
  std::array<glm::vec2, 4> uv{{{0, 0}, {0, 1}, {1, 1}, {1, 0}}};
  glm::vec4 color{1};
  glm::ivec2 light{240, 240};  ///< block, sky; 0..240
  bool hasNormal = true;       ///< false: (0,0,1), as in the game's formats without one
};

/// The coordinates of a part of a tile: `low` and `high` are 0..1 of the tile.
std::array<glm::vec2, 4> tileUv(const AtlasTile& tile, glm::vec2 low = glm::vec2(0),
                                glm::vec2 high = glm::vec2(1));

class ListWriter {
 public:
  ListWriter(const SceneData& sceneData, const FrameState& frameState)
      : scene(sceneData), state(frameState) {}

  /// What follows until the next call belongs to `draw`, whose range is filled in.
  void begin(ContentDraw draw);
  void quad(const ContentQuad& quad);
  DrawLists take();

  /// A place of the world relative to the camera.
  glm::vec3 local(const glm::dvec3& place) const;
  /// Light in the cell of a place: block, sky; 0..240.
  glm::ivec2 lightAt(const glm::dvec3& place) const;

  const SceneData& scene;
  const FrameState& state;

 private:
  void end();
  DrawLists lists_;
};

// Each adds its kinds, where the scene has them.
void addEntities(ListWriter& writer);
void addLightning(ListWriter& writer);
void addBlockOverlays(ListWriter& writer);  ///< texts, beams, cracks, outline, border
void addParticles(ListWriter& writer);
void addWeather(ListWriter& writer);
void addHands(ListWriter& writer);

/// The faces of an item, a block or a sprite, in a cube 0..1, moved by `place`; `dye`: its colour, where it takes one.
void addItem(ListWriter& writer, const std::string& item, const glm::mat4& place, glm::ivec2 light,
             const std::optional<glm::vec3>& dye = {});
/// A line of glyphs around the origin of `place`, in its xy plane, capitals one unit high; `square` gives all
/// but the corners.
void addGlyphs(ListWriter& writer, std::string_view text, const glm::mat4& place,
               ContentQuad square);
/// In heights of a capital.
float glyphsWidth(std::string_view text);
/// Is the item a translucent block?
bool isTranslucentItem(const SceneData& scene, const std::string& item);

}  // namespace orris
