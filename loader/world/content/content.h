// What a world holds besides its blocks: entities, particles, beams, cracks, texts, a border.
// docs/world-format.md describes each.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include <orris/world/blocks/block_state.h>

namespace orris {

/// Something that the game draws by a model of its own.
struct Entity {
  std::string name;                 ///< by which events find it, "" for none
  std::string kind;                 ///< with namespace: what a pack knows it by
  std::string model;                ///< what it is drawn as; findEntityModel() knows it
  glm::dvec3 position{0};           ///< of the feet, world blocks
  float yaw = 0, pitch = 0;         ///< degrees, as a camera's; all of it turns
  float scale = 1;                  ///< of the model
  bool hidden = false;              ///< all but its armour, items and tag
  bool walking = false;             ///< legs and arms swing with time
  bool hurt = false;                ///< the game's red overlay
  bool glint = false;               ///< what it wears, or the item, is enchanted
  std::string tag;                  ///< text over its head, "" for none
  std::string item;                 ///< dropped or framed, with namespace; "" for none
  float itemTurn = 0;               ///< degrees, of one that is framed: clockwise
  std::optional<glm::dvec3> leash;  ///< where the leash ends, world blocks
  std::string mainHand, offHand;    ///< held items of a model with hands, with namespace; "" for none
  std::vector<std::string> armour;  ///< items that a model with armour wears, with namespace
  std::optional<glm::vec3> dye;     ///< of what takes a dye among its items
};

enum class ParticleKind { Flame, Smoke, Spark };

/// Particles that rise from a place, each again and again.
struct ParticleSource {
  ParticleKind kind = ParticleKind::Smoke;
  glm::dvec3 position{0};  ///< world blocks
  int count = 8;
  float spread = 0.25f;  ///< blocks
};

/// The beam over a beacon, to the sky.
struct BeaconBeam {
  glm::ivec3 at{0};
  glm::vec3 color{1};
};

/// Cracks on a block that is being broken.
struct DamagedBlock {
  glm::ivec3 at{0};
  int stage = 5;  ///< 0..9
};

/// From glyph to glyph of a text, in heights of a capital.
constexpr float kGlyphAdvance = 0.8f;

/// A line of glyphs on a block entity, as on a sign.
struct BlockText {
  std::string text;        ///< capitals, digits and blanks are drawn
  glm::ivec3 at{0};        ///< the block that it belongs to
  glm::dvec3 position{0};  ///< middle of the line, world blocks
  float yaw = 0;           ///< degrees; where the text looks to, as a camera's
  float size = 0.1f;       ///< height of a capital, blocks
  glm::vec3 color{0};
};

/// A stroke of lightning that is seen until a frame.
struct LightningBolt {
  glm::dvec3 at{0};  ///< where it strikes
  int until = 0;     ///< the first frame without it
};

/// The box of the world border: x and z.
struct WorldBorder {
  glm::dvec2 low{0}, high{0};
};

struct WorldContent {
  std::vector<Entity> entities;
  std::vector<ParticleSource> particles;
  std::vector<BeaconBeam> beams;
  std::vector<DamagedBlock> damaged;
  std::vector<BlockText> texts;
  std::vector<LightningBolt> bolts;    ///< those of events that have happened
  std::optional<glm::ivec3> selected;  ///< the block that the player looks at, with an outline
  std::optional<WorldBorder> border;
};

}  // namespace orris
