// Tiles of the atlas whose pictures change with time. Nothing here draws.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include <orris/image/image.h>

namespace orris {

/// The three pictures of one texture, of one size. Of a frame of an animation normal and specular may be
/// empty: they stay as they are.
struct TileImages {
  Image8 albedo, normal, specular;
};

struct AnimationStep {
  int frame = 0;  ///< index in TileAnimation::frames
  int ticks = 1;  ///< for so many twentieths of a second, at least 1
};

struct TileAnimation {
  std::vector<TileImages> frames;
  std::vector<AnimationStep> steps;  ///< again and again; never empty
  bool interpolate = false;          ///< from each step to the next, in every tick
  glm::ivec2 corner{0};              ///< in the atlas, texels; set where the atlas is packed
};
using TileAnimations = std::vector<TileAnimation>;

/// What is seen at a moment: `share` (0..1) of the way from a frame to the next step's.
struct AnimationMoment {
  int frame = 0, next = 0;
  float share = 0;
  bool operator==(const AnimationMoment&) const = default;
};
/// `tick`: since the start, 0 or more.
AnimationMoment momentOf(const TileAnimation& animation, long tick);

/// Colours between two pictures of one size; alpha is that of `from`, as in the game.
Image8 mixed(const Image8& from, const Image8& to, float share);

}  // namespace orris
