// Checks of options: lists that do not fit, options that nothing uses, options nobody can reach.
#pragma once

#include <span>

#include "core/diagnostic.h"
#include "pack/shader_pack.h"

namespace orris {

/// Lists: a value given twice, a default that is missing, lines that differ in their lists.
void checkOptionLists(std::span<const ShaderPack> folders, Diagnostics& diagnostics);

/// Options that no shader text and no properties file mentions outside their own definition.
void checkOptionUse(std::span<const ShaderPack> folders, Diagnostics& diagnostics);

/// Options on no screen, in a pack whose screens do not show all the rest with `*`.
void checkHiddenOptions(std::span<const ShaderPack> folders, Diagnostics& diagnostics);

}  // namespace orris
