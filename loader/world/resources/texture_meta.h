// The .mcmeta beside a texture of a resource pack: its animation.
#pragma once

#include <optional>
#include <vector>

#include <orris/world/atlas/tile_animation.h>
#include <orris/world/resources/resource_stack.h>

namespace orris {

/// Frames lie in a grid, counted along rows; a step's frame is such a number.
struct TextureMeta {
  int width = 0, height = 0;  ///< of a frame, texels
  std::vector<AnimationStep> steps;
  bool interpolate = false;
};

/// Of a picture of that size; every frame of the result lies in it. nullopt: there is no animation, or (warnings) it
/// cannot be used.
std::optional<TextureMeta> parseTextureMeta(const ResourceFile& file, glm::ivec2 size,
                                            Diagnostics& diagnostics);

}  // namespace orris
