#include <orris/chart/study/tune_search.h>

#include <algorithm>
#include <cmath>

namespace orris {
namespace {

constexpr std::size_t kFew = 12;

bool isPoint(const Tried& tried) {
  return tried && std::isfinite(tried->cost) && std::isfinite(tried->error);
}

/// The point that comes first in the order `better`, among those that `allowed` lets through.
template <class Allowed, class Better>
std::optional<std::size_t> firstOf(const std::vector<Tried>& tried, const Allowed& allowed,
                                   const Better& better) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < tried.size(); ++i) {
    if (!isPoint(tried[i]) || !allowed(*tried[i])) continue;
    if (!best || better(*tried[i], *tried[*best])) best = i;
  }
  return best;
}

bool cheaper(const CostError& a, const CostError& b) {
  return a.cost != b.cost ? a.cost < b.cost : a.error < b.error;
}
bool moreAccurate(const CostError& a, const CostError& b) {
  return a.error != b.error ? a.error < b.error : a.cost < b.cost;
}

/// Those on the front, by cost.
std::vector<std::size_t> frontByCost(const std::vector<Tried>& tried) {
  std::vector<CostError> points;
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < tried.size(); ++i) {
    if (!isPoint(tried[i])) continue;
    points.push_back(*tried[i]);
    indices.push_back(i);
  }
  const std::vector<bool> front = paretoFront(points);
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < indices.size(); ++i)
    if (front[i]) result.push_back(indices[i]);
  std::sort(result.begin(), result.end(),
            [&](std::size_t a, std::size_t b) { return cheaper(*tried[a], *tried[b]); });
  return result;
}

std::vector<std::size_t> allUntried(const std::vector<Tried>& tried) {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < tried.size(); ++i)
    if (!tried[i]) result.push_back(i);
  return result;
}

}  // namespace

bool TuneGoal::reachedBy(const CostError& point) const {
  return error ? point.error <= *error : point.cost <= milliseconds;
}

std::optional<std::size_t> bestOf(const std::vector<Tried>& tried, const TuneGoal& goal) {
  return firstOf(
      tried, [&](const CostError& point) { return goal.reachedBy(point); },
      goal.error ? cheaper : moreAccurate);
}

std::optional<std::size_t> nearestTo(const std::vector<Tried>& tried, const TuneGoal& goal) {
  return firstOf(
      tried, [](const CostError&) { return true; }, goal.error ? moreAccurate : cheaper);
}

int differences(const Setting& a, const Setting& b) {
  int count = int(a.profile != b.profile) + int(a.size != b.size);
  for (const auto& [name, value] : a.values) {
    const auto other = b.values.find(name);
    count += int(other == b.values.end() || other->second != value);
  }
  return count;
}

std::vector<std::size_t> nextToTry(const std::vector<Setting>& settings,
                                   const std::vector<Tried>& tried, const TuneGoal& goal) {
  if (settings.size() <= kFew) return allUntried(tried);
  std::vector<std::size_t> centres = {0};
  if (const auto nearest = bestOf(tried, goal) ? bestOf(tried, goal) : nearestTo(tried, goal)) {
    const std::vector<std::size_t> front = frontByCost(tried);
    const auto at = std::find(front.begin(), front.end(), *nearest);
    const auto from = at == front.begin() ? at : at - 1;
    const auto to = front.end() - at > 1 ? at + 2 : front.end();
    centres.assign(from, to);
  }
  std::vector<std::size_t> next;
  for (std::size_t i = 0; i < settings.size(); ++i) {
    if (tried[i]) continue;
    const bool near = std::any_of(centres.begin(), centres.end(), [&](std::size_t centre) {
      return differences(settings[i], settings[centre]) <= 1;
    });
    if (near) next.push_back(i);
  }
  return next;
}

}  // namespace orris
