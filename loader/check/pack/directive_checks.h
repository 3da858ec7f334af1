// Checks of directives in shader text that no host reads because their names are misspelt.
#pragma once

#include <span>

#include <orris/core/diagnostic.h>
#include <orris/pack/shader_pack.h>

namespace orris {

/// Constants that nothing uses and comments before a number list, one slip away from a directive.
void checkDirectiveNames(std::span<const ShaderPack> folders, Diagnostics& diagnostics);

}  // namespace orris
