// What glslang's linker says without a place, where a check says it with one.
#pragma once

#include "core/diagnostic.h"

namespace orris {

/// Removes the messages of glslang that a located diagnostic among `diagnostics` repeats: mismatches
/// of names between stages, and outputs at one location.
void dropRepeatedLinkErrors(Diagnostics& diagnostics);

}  // namespace orris
