// Checks of shaders.properties as a file.
#pragma once

#include <span>

#include <orris/core/diagnostic.h>
#include <orris/pack/shader_pack.h>

namespace orris {

/// Keys given twice with different values: the last one counts.
void checkPropertiesTwice(std::span<const ShaderPack> folders, Diagnostics& diagnostics);

/// Lines of screens, sliders and profiles that are keys of their own, as the line before lost its
/// backslash.
void checkStrayLines(std::span<const ShaderPack> folders, Diagnostics& diagnostics);

}  // namespace orris
