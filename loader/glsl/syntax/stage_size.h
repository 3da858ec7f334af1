// Short texts of which a compiler makes very much.
#pragma once

#include <orris/core/diagnostic.h>
#include <orris/glsl/tokens/token.h>

namespace orris {

/// Reports, as stage-too-large, what of a stage a driver would take gigabytes for, the first of each kind:
/// - a function that main() reaches, by its tokens with the functions that it calls in place of the calls, as
///   drivers put them: more than limits::kInlinedTokens
/// - an array with more than limits::kArrayElements elements, unless it is shared or of a struct or buffer; a length
///   that is no number, nor made of constants that are, is not looked at
/// - a switch with more than limits::kSwitchCases cases
void checkStageSize(const TokenStream& stream, Diagnostics& diagnostics);

}  // namespace orris
