// Decimal numbers in #if, which counts in whole numbers.
#pragma once

#include <span>

#include <orris/core/diagnostic.h>
#include <orris/pack/shader_pack.h>

namespace orris {

/// Conditions whose decimal numbers Iris cuts to whole ones. A note where every value that the option
/// or macro beside the number can have gives the same either way, as in `#if SCALE < 1.0`.
void checkDecimals(std::span<const ShaderPack> folders, Diagnostics& diagnostics);

}  // namespace orris
