// An item of texels: its texture, as thick as one of sixteen texels.
#pragma once

#include <string>
#include <vector>

#include <orris/image/image.h>
#include <orris/world/resources/block_model.h>

namespace orris {

/// Front, back and the edges between texels that are there and those that are not, in a cube 0..1 around z = 0.5. Of a
/// texture of more than 64 texels a side, front and back alone. `frames`: its pictures, of one size; an edge that one of
/// them has is there.
std::vector<ModelFace> flatItemFaces(const std::string& texture, const std::vector<const Image8*>& frames);

}  // namespace orris
