// Traces until a limit is reached, with a progress line and checkpoints.
#pragma once

#include <string>

#include "app/output/report.h"
#include <orris/trace/film/trace_run.h>

namespace orris {

/// The first that is reached ends the work; 0: no such limit. Without any: kDefaultSamples.
struct TraceLimits {
  std::uint32_t samples = 0;  ///< a pixel, both halves together; rounded up to even
  double seconds = 0;         ///< of this run
  double noise = 0;           ///< TraceNoise::relative
};
constexpr std::uint32_t kDefaultSamples = 256;

struct TraceJob {
  const TraceScene& scene;
  const TraceCamera& camera;
  TraceSettings settings;
  int threads = 0;
  std::string checkpoint;  ///< file
  std::uint64_t key = 0;
};

/// What one run did.
struct TraceProgress {
  double seconds = 0;
  RayCounts rays;
  std::string stoppedBy = "samples";  ///< or seconds, noise, interrupt
};

/// Ctrl-C ends it as a limit does. The checkpoint is written every half minute and at the end; a
/// failure to write it is reported and ends the work.
TraceProgress traceUntil(TraceFilm& film, const TraceJob& job, const TraceLimits& limits,
                         Report& report);

/// The picture, its halves, and which pixels lie on edges (edgePixels()). false: reported.
bool writeTraced(const std::string& path, const TraceFilm& film, const std::vector<std::uint8_t>& edges,
                 Report& report);

}  // namespace orris
