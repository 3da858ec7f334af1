// Checks of lang/*.lang: names of what does not exist, texts that are missing or given twice.
#pragma once

#include <span>

#include <orris/core/diagnostic.h>
#include <orris/pack/shader_pack.h>

namespace orris {

/// Keys of every language file: for things that do not exist, and given twice.
void checkLanguageKeys(std::span<const ShaderPack> folders, Diagnostics& diagnostics);

/// What the screens show and /lang/en_us.lang, which is the fallback of every language, lacks.
void checkLanguageCover(std::span<const ShaderPack> folders, Diagnostics& diagnostics);

}  // namespace orris
