// Texts that a save holds, of names and signs.
#pragma once

#include <orris/world/files/nbt.h>

#include <string>

namespace orris {

/// A text as glyphs are drawn from it: ASCII, one line, without blanks at its ends, at most
/// limits::kWorldTextGlyphs characters; what is not ASCII is a blank. A plain string, JSON (1.8 to
/// 1.21.4) or tags (since). What it translates or looks up is left out.
std::string drawnText(const NbtTag& tag);

}  // namespace orris
