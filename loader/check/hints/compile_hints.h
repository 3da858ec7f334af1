// What a compiler's message about an unknown name means for a pack: a misspelling, a contract name
// that was not declared, or an #include that is missing.
#pragma once

#include <vector>

#include <orris/check/hints/definition_index.h>
#include <orris/check/hints/missing_include.h>
#include <orris/core/diagnostic.h>
#include <orris/glsl/compile/validate.h>

namespace orris {

/// The name that `message` calls unknown, "" for other messages.
std::string unknownName(const std::string& message);

/// Adds hints to the errors of one program, and located companions: name-misspelt at the declaration
/// that was meant, include-probably-missing where the line should stand, if it can be where `trial`
/// succeeds.
void explainUnknownNames(DefinitionIndex& index, const std::vector<const StageText*>& stages,
                         const IncludeTrial& trial, Diagnostics& found);

}  // namespace orris
