// What an error in the text that Iris sends has to do with its version, or with core GLSL: the version
// or extension that has a feature, and what stands for a name that core GLSL lacks.
#pragma once

#include <vector>

#include <orris/core/diagnostic.h>
#include <orris/glsl/compile/validate.h>

namespace orris {

/// Adds hints, and notes on drivers that are less strict, to the errors of `stages` that have none.
/// Only for text made by Iris (glsl/iris/iris_text.h).
void explainVersions(const std::vector<const StageText*>& stages, const SourceLines& lines,
                     Diagnostics& found);

}  // namespace orris
