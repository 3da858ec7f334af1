// What an error has to do with what GLSL lacks beside other languages, or with a macro that stands where a name was meant.
#pragma once

#include <vector>

#include <orris/check/hints/definition_index.h>
#include <orris/core/diagnostic.h>
#include <orris/glsl/compile/validate.h>

namespace orris {

/// Adds hints to the errors of `stages` that have none: default values of parameters, comparisons and logic of vectors,
/// % of floats, names that a macro of the stage replaces by nothing.
void explainLanguage(DefinitionIndex& index, const std::vector<const StageText*>& stages,
                     Diagnostics& found);

}  // namespace orris
