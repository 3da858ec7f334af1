// From a shape of the data file and a state's properties to boxes with textures.
#pragma once

#include <orris/world/blocks/block_data.h>

namespace orris {

/// Boxes of one state, turned and mirrored as its properties say. Faces hidden inside the shape are
/// left out (their texture is empty). A laid-down face has its texture name followed by "@90": the
/// atlas turns it by a quarter.
std::vector<ShapeBox> boxesOf(const ShapeTemplate& shape, const BlockProperties& properties,
                              const std::map<std::string, std::string>& textures);

/// Bit 1 << FaceDirection for each side of the unit cube that the boxes cover wholly.
std::uint8_t coveredFacesOf(const std::vector<ShapeBox>& boxes);

}  // namespace orris
