// Where #include lines most likely belong that a stage lacks.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <orris/check/hints/definition_index.h>

namespace orris {

/// A use of what only files define that the stage does not include.
struct UnknownName {
  std::string name;
  SourceLocation at;
  std::vector<SourceLocation> includedFrom;  ///< the #include lines that lead there
};

struct MissingInclude {
  SourceLocation at;      ///< where the line should stand
  std::string target;     ///< what it should include
  SourceLocation model;   ///< a similar file that does, line 0 when there is none
  std::size_t first = 0;  ///< the first of the names that it makes known
  double share = 1;       ///< how likely beside the likeliest place in the same file: 0 to 1
};

/// Would the program compile with this line, or at least with fewer errors and no new ones?
using IncludeTrial = std::function<bool(const MissingInclude&)>;

/// As few #include lines as make all names known. Each goes into the file whose similar files (those of its
/// folder, files with nearly the same #include lines, files of the same name) include the target,
/// before the name is used. Of the likeliest places the first one where `trial` succeeds, else the
/// likeliest. `reached` are the files of the stage in the order of their text, up to
/// the first use.
std::vector<MissingInclude> findMissingIncludes(DefinitionIndex& index,
                                                const std::vector<std::string>& reached,
                                                const std::vector<UnknownName>& names,
                                                const IncludeTrial& trial);

}  // namespace orris
