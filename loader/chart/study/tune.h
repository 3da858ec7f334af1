// The search for the cheapest setting within an error, or the most accurate within a time.
#pragma once

#include <vector>

#include <orris/chart/study/study.h>
#include <orris/chart/study/tune_search.h>

namespace orris {

struct Tuned {
  ChartData chart;           ///< of what was measured; holds as Study::chart() does
  std::vector<Tried> tried;  ///< of each setting of the study: for bestOf() and nearestTo()
  bool ended = true;         ///< false: the budget did
};

/// Measures settings of `study` until none is left that could be better.
Tuned tune(Study& study, const TuneGoal& goal);

}  // namespace orris
