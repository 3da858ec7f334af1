// Textures of resource packs: colours, the LabPBR maps beside them, and the frame of an animation.
#pragma once

#include <optional>
#include <vector>

#include "image/image.h"
#include "world/atlas/block_atlas.h"
#include "world/resources/resource_stack.h"

namespace orris {

/// "name.png" with "name_n.png" and "name_s.png"; maps that no pack has are flat and dull. Of an animation the first
/// frame. nullopt: no pack has the texture, or (warnings) it cannot be used.
std::optional<TileImages> readTexture(const ResourceStack& resources, const ResourceName& name,
                                      Diagnostics& diagnostics);

/// A picture of at most limits::kTextureTexels, as RGBA. nullopt as above.
std::optional<Image8> readPicture(const ResourceStack& resources, const ResourceName& name,
                                  Diagnostics& diagnostics);

}  // namespace orris
