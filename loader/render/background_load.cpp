#include "render/background_load.h"

#include <chrono>
#include <utility>

namespace orris {

BackgroundLoad::BackgroundLoad(LoadRequest request, PackLoader load)
    : result_(std::async(std::launch::async, [request = std::move(request),
                                              load = std::move(load)]() mutable {
        Result result;
        result.pack = load(request, result.problems);
        if (hasErrors(result.problems)) result.pack = nullptr;
        result.request = std::move(request);
        return result;
      })) {}

bool BackgroundLoad::ready() const {
  return result_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

}  // namespace orris
