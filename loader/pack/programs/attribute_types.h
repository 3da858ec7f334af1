// Types that a vertex attribute cannot have.
#pragma once

#include <orris/core/diagnostic.h>
#include <orris/glsl/iris/iris_text.h>

namespace orris {

/// An error for each attribute of a preprocessed vertex stage whose type Iris has no conversion to:
/// it then refuses the program. Iris: SodiumTransformer.replaceMCEntity and replaceMidTexCoord,
/// CommonTransformer.replaceMidBlock.
void checkAttributeTypes(const TokenStream& stream, const IrisProgram& program,
                         Diagnostics& diagnostics);

}  // namespace orris
