// Which of many settings to measure next, and which to take.
#pragma once

#include <optional>
#include <vector>

#include <orris/chart/measure/setting.h>
#include <orris/chart/page/pareto.h>

namespace orris {

/// The cheapest within an error, or else the most accurate within a time.
struct TuneGoal {
  std::optional<double> error;
  double milliseconds = 0;  ///< used without an error
  bool reachedBy(const CostError& point) const;
};

/// One of the settings: nothing before it was tried, or what came of it, NaN when it cannot be drawn.
using Tried = std::optional<CostError>;

/// Index of the setting to take; nullopt when none tried reaches the goal.
std::optional<std::size_t> bestOf(const std::vector<Tried>& tried, const TuneGoal& goal);
/// What comes nearest where nothing reaches the goal: the most accurate, or the cheapest.
std::optional<std::size_t> nearestTo(const std::vector<Tried>& tried, const TuneGoal& goal);

/// In how many axes two settings of the same axes differ.
int differences(const Setting& a, const Setting& b);

/// Settings worth measuring now; none: the search is over. Few settings are all tried. Of many, the
/// first and all that differ from it in one axis; then those that differ in one axis from the best so
/// far, or from one of its neighbours on the Pareto front.
std::vector<std::size_t> nextToTry(const std::vector<Setting>& settings,
                                   const std::vector<Tried>& tried, const TuneGoal& goal);

}  // namespace orris
