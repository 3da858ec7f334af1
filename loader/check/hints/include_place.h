// At which line of a file an #include most likely belongs that it lacks.
#pragma once

#include <string>
#include <vector>

#include <orris/check/hints/definition_index.h>
#include <orris/core/diagnostic.h>

namespace orris {

/// How much two files include the same: 0 to 1, more for files of the same name in other folders.
double likeness(DefinitionIndex& index, const std::string& file, const std::string& other);

struct IncludePlace {
  int line = 0;
  SourceLocation
      model;         ///< the likest file that includes the target, line 0 when none shows a place
  bool gap = false;  ///< a blank line
  double share = 1;  ///< how likely beside the likeliest: 0 to 1
};

/// Where `file` should include `target`, the likeliest first and at most `most`: where the files that
/// include it have it, each with its likeness as its vote, and where a gap shows that a line is
/// out. All before the line `before`, if that is not 0.
std::vector<IncludePlace> placesByModels(DefinitionIndex& index, const std::string& file,
                                         const std::string& target, int before, std::size_t most);

/// Where a line was taken out, else the first blank line behind an #include and before `before`, else
/// the line behind the last one.
int placeBehindIncludes(DefinitionIndex& index, const std::string& file, int before);

}  // namespace orris
