// Checks of the expressions in shaders.properties.
#pragma once

#include <orris/check/pack/pack_checks.h>

namespace orris {

/// Custom uniforms and variables that do not parse, name what does not exist or depend on themselves:
/// what the renderer would say of them when it starts.
void checkCustomUniforms(const FolderInput& input, Diagnostics& diagnostics);

}  // namespace orris
