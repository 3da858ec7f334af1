// What linkers say without a place, where a check says it with one.
#pragma once

#include <orris/core/diagnostic.h>

namespace orris {

/// Removes the messages of glslang and of the driver that a located diagnostic among `diagnostics`
/// repeats: mismatches of names between stages, outputs at one location, limits of the target.
void dropRepeatedLinkErrors(Diagnostics& diagnostics);

}  // namespace orris
