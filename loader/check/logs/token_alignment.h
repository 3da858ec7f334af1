// Which token of one text is which of another, when the other was printed anew and edited.
#pragma once

#include <string_view>
#include <vector>

namespace orris {

/// For each token of `from` the index of its counterpart in `to`, or -1. Rising. Matches runs of
/// tokens that occur once in both first, then what lies between; n log n.
std::vector<int> alignTokens(const std::vector<std::string_view>& from,
                             const std::vector<std::string_view>& to);

}  // namespace orris
