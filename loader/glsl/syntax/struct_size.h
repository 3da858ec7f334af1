// Structs within structs whose members double at each level.
#pragma once

#include <orris/core/diagnostic.h>
#include <orris/glsl/tokens/token.h>

namespace orris {

/// Reports the first struct of a stage that has more than limits::kStructMembers members, counted
/// down to the plain ones (an array is one): compilers list each of them.
void checkStructSizes(const TokenStream& stream, Diagnostics& diagnostics);

}  // namespace orris
