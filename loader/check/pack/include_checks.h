// Checks of which files of a pack its programs reach.
#pragma once

#include <span>

#include <orris/core/diagnostic.h>
#include <orris/pack/shader_pack.h>

namespace orris {

/// Shader files that no program file of any folder includes, whoever's program it is.
void checkUnusedIncludes(std::span<const ShaderPack> folders, Diagnostics& diagnostics);

}  // namespace orris
