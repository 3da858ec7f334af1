#include <orris/chart/measure/combine.h>

#include <algorithm>
#include <cmath>

namespace orris {
namespace {

using Results = std::vector<const SettingResult*>;

template <class Of>
double meanOver(const Results& cameras, const Of& of) {
  double sum = 0;
  for (const SettingResult* result : cameras) sum += of(*result);
  return sum / static_cast<double>(cameras.size());
}

template <class Of>
double rmsOver(const Results& cameras, const Of& of) {
  return std::sqrt(meanOver(cameras, [&](const SettingResult& result) {
    const double value = of(result);
    return value * value;
  }));
}

template <class Of>
Interval rmsInterval(const Results& cameras, const Of& of) {
  return {rmsOver(cameras, [&](const SettingResult& result) { return of(result).low; }),
          rmsOver(cameras, [&](const SettingResult& result) { return of(result).high; })};
}

template <class Of>
std::size_t leastOver(const Results& cameras, const Of& of) {
  std::size_t least = of(*cameras.front());
  for (const SettingResult* result : cameras) least = std::min(least, of(*result));
  return least;
}

AccumulatedError combineRun(const Results& cameras, std::size_t run) {
  const auto of = [run](const SettingResult& result) -> const AccumulatedError& {
    return result.error->accumulated[run];
  };
  return {of(*cameras.front()).frames,
          rmsOver(cameras, [&](const SettingResult& result) { return of(result).error; }),
          rmsInterval(cameras, [&](const SettingResult& result) { return of(result).interval; })};
}

ErrorSummary combineErrors(const Results& cameras) {
  const auto mean = [&](double ErrorSummary::*value) {
    return meanOver(cameras, [&](const SettingResult& r) { return (*r.error).*value; });
  };
  const auto rms = [&](double ErrorSummary::*value) {
    return rmsOver(cameras, [&](const SettingResult& r) { return (*r.error).*value; });
  };
  ErrorSummary error;
  error.frames = cameras.front()->error->frames;
  error.signedBias = mean(&ErrorSummary::signedBias);
  error.bias = rms(&ErrorSummary::bias);
  error.biasInterval =
      rmsInterval(cameras, [](const SettingResult& r) { return r.error->biasInterval; });
  error.noise = rms(&ErrorSummary::noise);
  error.relMse = mean(&ErrorSummary::relMse);
  error.relMseMedian = mean(&ErrorSummary::relMseMedian);
  error.relMseTrimmed = mean(&ErrorSummary::relMseTrimmed);
  for (const SettingResult* result : cameras) error.notFinite += result->error->notFinite;
  const std::size_t runs =
      leastOver(cameras, [](const SettingResult& r) { return r.error->accumulated.size(); });
  for (std::size_t run = 0; run < runs; ++run)
    error.accumulated.push_back(combineRun(cameras, run));
  return error;
}

/// Each pass once, with the mean of the cameras' medians; where a camera has no such pass it is 0.
std::vector<PassTimes> combinePasses(const Results& cameras) {
  std::vector<PassTimes> passes;
  for (const SettingResult* result : cameras) {
    for (const PassTimes& pass : result->passes) {
      auto found = std::find_if(passes.begin(), passes.end(),
                                [&](const PassTimes& known) { return known.name == pass.name; });
      if (found == passes.end()) found = passes.insert(passes.end(), {pass.name, {0}});
      found->times.front() += median(pass.times) / static_cast<double>(cameras.size());
    }
  }
  return passes;
}

}  // namespace

SettingResult combine(const std::vector<const SettingResult*>& cameras) {
  if (cameras.size() == 1) return *cameras.front();
  SettingResult result;
  result.label = cameras.front()->label;
  for (const SettingResult* camera : cameras)
    if (result.chosen.find(camera->chosen) == std::string::npos)
      result.chosen += (result.chosen.empty() ? "" : " or ") + camera->chosen;
  const bool errors = std::all_of(cameras.begin(), cameras.end(),
                                  [](const SettingResult* r) { return r->error.has_value(); });
  if (errors) result.error = combineErrors(cameras);
  result.ssim = meanOver(cameras, [](const SettingResult& r) { return r.ssim; });
  const std::size_t pairs =
      leastOver(cameras, [](const SettingResult& r) { return r.pairs.size(); });
  for (std::size_t i = 0; i < pairs; ++i) {
    result.pairs.push_back(
        {meanOver(cameras, [i](const SettingResult& r) { return r.pairs[i].own; }),
         meanOver(cameras, [i](const SettingResult& r) { return r.pairs[i].baseline; })});
  }
  for (const SettingResult* camera : cameras)
    result.frames.insert(result.frames.end(), camera->frames.begin(), camera->frames.end());
  result.passes = combinePasses(cameras);
  return result;
}

}  // namespace orris
