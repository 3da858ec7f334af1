#include <orris/chart/page/chart_data.h>

#include <algorithm>

#include <orris/chart/page/pareto.h>

namespace orris {
namespace {

Estimate withoutInterval(double value) { return {value, {value, value}}; }

Estimate accumulatedError(const SettingResult& result, int frames) {
  const AccumulatedError& run = result.error->after(frames);
  return {run.error, run.interval};
}
Estimate bias(const SettingResult& result, int) {
  return {result.error->bias, result.error->biasInterval};
}
Estimate noise(const SettingResult& result, int) { return withoutInterval(result.error->noise); }
Estimate relMse(const SettingResult& result, int) { return withoutInterval(result.error->relMse); }
Estimate unlikeness(const SettingResult& result, int) { return withoutInterval(1 - result.ssim); }

void markPublished(ChartPoint& point, const std::vector<PublishedMark>& marks) {
  for (const PublishedMark& mark : marks) {
    if (!includes(*point.setting, mark.setting)) continue;
    point.published = true;
    if (mark.ratio) point.publishedRatio = mark.ratio;
  }
}

ChartPoint makePoint(const ChartRequest& request, const Setting& setting,
                     const SettingResult& result, double baseline) {
  ChartPoint point;
  point.setting = &setting;
  point.result = &result;
  point.cost = pairedCost(result.pairs);
  const Interval& ratio = point.cost.ratioInterval;
  point.milliseconds = {point.cost.ratio * baseline, {ratio.low * baseline, ratio.high * baseline}};
  point.p95 = quantile(result.frames, 0.95);
  point.error = request.metric->of(result, request.accumulated);
  for (const PassTimes& pass : result.passes)
    point.passes.emplace_back(pass.name, median(pass.times));
  markPublished(point, request.marks);
  return point;
}

}  // namespace

const std::vector<ErrorMetric>& errorMetrics() {
  static const std::vector<ErrorMetric> kMetrics = {
      {"error", "relative error, rms", accumulatedError},
      {"bias", "relative bias, rms", bias},
      {"noise", "relative noise of one frame, rms", noise},
      {"relmse", "relMSE of one frame", relMse},
      {"ssim", "1 - SSIM of one frame as displayed", unlikeness},
  };
  return kMetrics;
}

const ErrorMetric* findErrorMetric(const std::string& name) {
  const auto& all = errorMetrics();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const auto& metric) { return metric.name == name; });
  return found == all.end() ? nullptr : &*found;
}

ChartData makeChart(ChartRequest request, const std::vector<Setting>& settings,
                    const std::vector<const SettingResult*>& results) {
  ChartData data;
  data.request = std::move(request);
  if (results.empty()) return data;
  const double baseline = pairedCost(results.front()->pairs).median;
  std::vector<CostError> costs;
  for (std::size_t i = 0; i < settings.size(); ++i) {
    if (results[i]->pairs.empty() || !results[i]->error) continue;
    data.points.push_back(makePoint(data.request, settings[i], *results[i], baseline));
    costs.push_back({data.points.back().milliseconds.value, data.points.back().error.value});
  }
  const std::vector<bool> front = paretoFront(costs);
  for (std::size_t i = 0; i < front.size(); ++i) data.points[i].front = front[i];
  if (data.request.again != nullptr && !data.request.again->pairs.empty())
    data.again = pairedCost(data.request.again->pairs);
  return data;
}

}  // namespace orris
