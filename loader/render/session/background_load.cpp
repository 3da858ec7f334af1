#include <orris/render/session/background_load.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include <orris/pack/rebuild.h>

namespace orris {

namespace {

void settle(const AutoChoices& guess, const ShaderPack* before, BackgroundLoad::Result& result) {
  if (!result.pack || guess.all().empty()) return;
  auto pack = rebuildShaderPack(*result.pack, guess.applied(result.request),
                                {.earlier = before != nullptr ? before : result.pack.get()},
                                result.settledProblems);
  if (pack && !hasErrors(result.settledProblems))
    result.settled = std::make_shared<const ShaderPack>(std::move(*pack));
}

}  // namespace

BackgroundLoad::BackgroundLoad(LoadRequest request, PackLoader load, AutoChoices guess,
                               std::shared_ptr<const ShaderPack> before)
    : result_(std::async(std::launch::async, [request = std::move(request), load = std::move(load),
                                              guess = std::move(guess),
                                              before = std::move(before)]() mutable {
        Result result;
        result.pack = load(request, result.problems);
        if (hasErrors(result.problems)) result.pack = nullptr;
        result.request = std::move(request);
        settle(guess, before.get(), result);
        return result;
      })) {}

bool BackgroundLoad::readyWithin(double seconds) const {
  // No time of a clock is as far away as infinity.
  constexpr double kMost = 1e6;
  const std::chrono::duration<double> time(std::min(seconds, kMost));
  return result_.wait_for(time) == std::future_status::ready;
}

}  // namespace orris
