// Names that Iris keeps to itself.
#pragma once

#include <orris/core/diagnostic.h>
#include <orris/glsl/tokens/token.h>

namespace orris {

/// An error for each name of a preprocessed stage that begins as those of Iris's own code do: it
/// refuses a program that has one, wherever it stands. Iris: TransformPatcher.
void checkReservedNames(const TokenStream& stream, Diagnostics& diagnostics);

}  // namespace orris
