// Which settings are worth their cost.
#pragma once

#include <cstddef>
#include <vector>

namespace orris {

struct CostError {
  double cost = 0, error = 0;
};

/// For each point: no other is better in one and at least as good in the other. Equal points stand
/// or fall together; a point with a NaN or an infinity is never on the front.
std::vector<bool> paretoFront(const std::vector<CostError>& points);

}  // namespace orris
