// Where an #include most likely belongs that a stage lacks.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "check/definition_index.h"

namespace orris {

struct MissingInclude {
  SourceLocation at;     ///< where the line should stand
  std::string target;    ///< what it should include
  SourceLocation model;  ///< a similar file that does, line 0 when there is none
};

/// `reached` are the files of the stage, `error` the use of what only `definer` defines: the line
/// must stand before it and before the #includes that lead to it. A file with nearly the same
/// #include lines shows the place; without one it is the first gap among those of the user, or the
/// end of them.
std::optional<MissingInclude> findMissingInclude(DefinitionIndex& index,
                                                 const std::vector<std::string>& reached,
                                                 const Diagnostic& error,
                                                 const std::string& definer);

}  // namespace orris
