// Which conditional directive of a file is missing, too many or misspelt: the stack of open #if
// blocks tells only where nothing was left to close, or what was still open at the end.
#pragma once

#include <string>
#include <vector>

#include <orris/core/diagnostic.h>
#include <orris/glsl/tokens/source_map.h>

namespace orris {

/// One way to make the conditionals of a file pair.
struct ConditionalRepair {
  Origin place;             ///< the line that the missing directive would stand behind, or before
  Origin partner;           ///< the directive that it would pair with
  std::string directive{};  ///< the partner's name
};

struct UnbalancedConditional {
  enum class Kind { Unclosed, Stray, Misspelt };
  Kind kind = Kind::Unclosed;
  Origin at;                   ///< the #if without #endif, the #endif without #if, or the slip
  std::string directive;       ///< its name
  std::string meant;           ///< of a misspelt one
  Origin place;                ///< the line that its partner most likely belongs behind, or before
  std::vector<Origin> others;  ///< directives that may be the one instead
  /// All likely ones, the likeliest first; empty for a misspelt one.
  std::vector<ConditionalRepair> repairs;
  std::vector<std::string> stages;  ///< macros of its conditionals that tell stages apart
};

/// At most one for each file whose own conditionals do not pair, judged by indentation, by the braces
/// around them and by include guards.
std::vector<UnbalancedConditional> findUnbalancedConditionals(const FlatSource& source);

/// What to report of one that is not misspelt, all places in `file`, and how to read the rest as meant.
Diagnostic describeUnbalanced(const UnbalancedConditional& found, const std::string& file);

}  // namespace orris
