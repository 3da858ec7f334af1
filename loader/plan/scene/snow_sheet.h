// The texture of falling snow.
#pragma once

#include <orris/image/image.h>

namespace orris {

inline constexpr float kSnowSheetBlocks = 4.0f / 3;  ///< side of what the sheet covers: a texel is 1/48 block

/// Transparent but for the flakes. As the game's sheet of 64 texels a block, it has a hundredth of its texels
/// covered: up to 21 columns of it lie behind one another.
Image8 snowSheet();

}  // namespace orris
