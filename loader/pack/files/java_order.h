// The order in which Iris goes over the files of a pack: that of a Java hash table. It decides what
// several definitions of one option come to.
#pragma once

#include <string>
#include <vector>

namespace orris {

/// Pack paths in that order; those that share a bucket stay in the order given. Iris: IncludeGraph
/// (a HashMap of AbsolutePackPath).
std::vector<std::string> inJavaHashOrder(std::vector<std::string> paths);

}  // namespace orris
