// Preprocessor directives that are misspelt.
#pragma once

#include <string_view>

namespace orris {

/// The directive that `word` is a slip of: letters exchanged, one missing or one too many; "" when there
/// is none, and for a word that is a directive itself.
std::string_view directiveMeant(std::string_view word);

}  // namespace orris
