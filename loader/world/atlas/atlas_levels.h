// Smaller copies of the block atlas, for surfaces far away.
#pragma once

#include <vector>

#include <orris/image/image.h>

namespace orris {

/// Levels in which a tile of 16 texels still covers whole texels.
inline constexpr int kAtlasLevels = 5;

/// The image, and each further level half as wide and high: means of four texels. Colours are
/// averaged as light (power 2.2), as the game does, so that a far surface is as bright as a near
/// one; alpha as it is stored. RGBA.
std::vector<Image8> atlasLevels(const Image8& image, int levels);
/// The same of data: means of the values as they are stored.
std::vector<Image8> dataLevels(const Image8& image, int levels);

}  // namespace orris
