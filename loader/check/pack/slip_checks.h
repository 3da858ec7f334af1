// Names that no reader takes and that are a slip away from one that would be: hosts ignore them.
#pragma once

#include <span>

#include <orris/core/diagnostic.h>
#include <orris/pack/shader_pack.h>

namespace orris {

/// Options in the conditions of "program.*.enabled" in shaders.properties.
void checkPropertyNames(std::span<const ShaderPack> folders, Diagnostics& diagnostics);

/// Conditions that ask for a macro which Iris never defines.
void checkMacroNames(std::span<const ShaderPack> folders, Diagnostics& diagnostics);

}  // namespace orris
