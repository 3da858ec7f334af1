// Checks of block, item, entity and dimension .properties: lines that are lost or have no effect.
#pragma once

#include <span>

#include <orris/core/diagnostic.h>
#include <orris/pack/shader_pack.h>

namespace orris {

/// Keys given twice in a file, names under two keys, misspelt block states.
void checkIdMaps(std::span<const ShaderPack> folders, Diagnostics& diagnostics);

}  // namespace orris
