#include <orris/chart/study/tune.h>

#include <limits>

namespace orris {
namespace {

/// What is known of each setting; `attempted` that could not be drawn are NaN.
std::vector<Tried> triedOf(const Study& study, const ChartData& chart,
                           const std::vector<bool>& attempted) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  std::vector<Tried> tried(study.settings().size());
  for (std::size_t i = 0; i < tried.size(); ++i)
    if (attempted[i]) tried[i] = CostError{kNone, kNone};
  for (const ChartPoint& point : chart.points) {
    const auto index = std::size_t(point.setting - study.settings().data());
    if (attempted[index]) tried[index] = CostError{point.milliseconds.value, point.error.value};
  }
  return tried;
}

}  // namespace

Tuned tune(Study& study, const TuneGoal& goal) {
  std::vector<bool> attempted(study.settings().size());
  Tuned result;
  result.tried.resize(attempted.size());
  for (;;) {
    const std::vector<std::size_t> next = nextToTry(study.settings(), result.tried, goal);
    if (next.empty()) break;
    study.measure(next);
    for (const std::size_t index : next) attempted[index] = true;
    result.chart = study.chart();
    result.tried = triedOf(study, result.chart, attempted);
    result.ended = study.timeLeft();
    if (!result.ended) break;
  }
  return result;
}

}  // namespace orris
