#include <orris/chart/page/pareto.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace orris {

std::vector<bool> paretoFront(const std::vector<CostError>& points) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (std::isfinite(points[i].cost) && std::isfinite(points[i].error)) order.push_back(i);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return points[a].cost != points[b].cost ? points[a].cost < points[b].cost
                                            : points[a].error < points[b].error;
  });
  std::vector<bool> front(points.size(), false);
  double best = std::numeric_limits<double>::infinity();
  const CostError* last = nullptr;
  for (const std::size_t i : order) {
    const CostError& point = points[i];
    const bool tie = last != nullptr && point.cost == last->cost && point.error == last->error;
    if (point.error >= best && !tie) continue;
    front[i] = true;
    best = point.error;
    last = &point;
  }
  return front;
}

}  // namespace orris
