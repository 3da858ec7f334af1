// A file that is read twice into one stage: a compiler takes its second copy for second definitions.
#pragma once

#include <vector>

#include <orris/core/diagnostic.h>
#include <orris/glsl/compile/validate.h>

namespace orris {

/// Says so in the errors that follow from it and have no hint yet, and names the first #include.
void explainDoubleIncludes(const std::vector<const StageText*>& stages, Diagnostics& found);

}  // namespace orris
