// Traces until a limit is reached, with checkpoints.
#pragma once

#include <functional>
#include <string>

#include <orris/core/diagnostic.h>
#include <orris/trace/film/trace_run.h>

namespace orris {

/// The first that is reached ends the work; 0: no such limit. Without any: kDefaultSamples.
struct TraceLimits {
  std::uint32_t samples = 0;  ///< a pixel, both halves together; rounded up to even
  double seconds = 0;         ///< of this call
  double noise = 0;           ///< TraceNoise::relative
};
constexpr std::uint32_t kDefaultSamples = 256;

struct TraceJob {
  const TraceScene& scene;
  const TraceCamera& camera;
  TraceSettings settings;
  int threads = 0;  ///< 0: as many as the machine has
  std::string checkpoint;  ///< file
  std::uint64_t key = 0;   ///< traceKey()
};

/// What the owner of the work sees and says while it goes on; each may be empty.
struct TraceHooks {
  std::function<void(double share)> progress;  ///< 0 to 1, by the limit that is nearest
  std::function<bool()> stop;                  ///< true ends the work as a limit does
};

/// What one call did.
struct TraceProgress {
  double seconds = 0;
  RayCounts rays;
  std::string stoppedBy = "samples";  ///< or seconds, noise, interrupt
};

/// The checkpoint is written every half minute and at the end; a failure to write it is a diagnostic and ends
/// the work.
TraceProgress traceUntil(TraceFilm& film, const TraceJob& job, const TraceLimits& limits, const TraceHooks& hooks,
                         Diagnostics& diagnostics);

}  // namespace orris
