// Which conditional directive of a file is missing, too many or misspelt: the stack of open #if
// blocks tells only where nothing was left to close, or what was still open at the end.
#pragma once

#include <string>
#include <vector>

#include "glsl/source_map.h"

namespace orris {

struct UnbalancedConditional {
  enum class Kind { Unclosed, Stray, Misspelt };
  Kind kind = Kind::Unclosed;
  Origin at;                   ///< the #if without #endif, the #endif without #if, or the slip
  std::string directive;       ///< its name
  std::string meant;           ///< of a misspelt one
  Origin place;                ///< the line that its partner most likely belongs behind, or before
  std::vector<Origin> others;  ///< directives that may be the one instead
};

/// At most one for each file whose own conditionals do not pair, judged by indentation, by the braces
/// around them and by include guards.
std::vector<UnbalancedConditional> findUnbalancedConditionals(const FlatSource& source);

}  // namespace orris
