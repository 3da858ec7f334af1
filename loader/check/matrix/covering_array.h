// Few rows in which every pair of values of every two factors occurs: an error that two options
// make together shows in at least one of them.
#pragma once

#include <functional>
#include <vector>

namespace orris {

/// Rows of a covering array of strength 2 for factors with `levels[i]` values each; row[i] is a
/// value of factor i, from 0. Deterministic. The rows that cover most new pairs come first; no
/// further ones are made once `stop` says so.
std::vector<std::vector<int>> pairwiseRows(
    const std::vector<int>& levels, const std::function<bool()>& stop = [] { return false; });

}  // namespace orris
