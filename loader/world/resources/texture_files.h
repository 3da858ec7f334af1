// Textures of resource packs: colours, the LabPBR maps beside them, and animations.
#pragma once

#include <optional>
#include <vector>

#include <orris/core/limits.h>
#include <orris/image/image.h>
#include <orris/world/atlas/block_atlas.h>
#include <orris/world/resources/resource_stack.h>

namespace orris {

struct PackTexture {
  TileImages images;                        ///< of an animation its first moment
  std::optional<TileAnimation> animation{};  ///< its corner is not known yet
};

/// Of all frames of a world's animated textures.
inline constexpr std::size_t kMostFrameTexels = limits::kAtlasTexels / 8;

/// What the animations of a world may take.
struct AnimationBudget {
  std::size_t texels = kMostFrameTexels;  ///< that are left
  int refused = 0;                                ///< textures that stand still, as more are not left
};

/// "name.png" with "name_n.png" and "name_s.png"; maps that no pack has are flat and dull. nullopt: no pack has the
/// texture, or (warnings) it cannot be used.
std::optional<PackTexture> readTexture(const ResourceStack& resources, const ResourceName& name,
                                       AnimationBudget& budget, Diagnostics& diagnostics);

/// A picture of at most limits::kTextureTexels, as RGBA. nullopt as above.
std::optional<Image8> readPicture(const ResourceStack& resources, const ResourceName& name,
                                  Diagnostics& diagnostics);

}  // namespace orris
