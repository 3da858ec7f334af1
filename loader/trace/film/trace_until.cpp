#include <orris/trace/film/trace_until.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include <orris/trace/film/checkpoint.h>

namespace orris {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kPassSeconds = 0.5;
constexpr double kCheckpointSeconds = 30;

double since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

struct HalfLimits {
  std::uint32_t half = 0;  ///< samples of each half
  double seconds = 0, noise = 0;
};

HalfLimits resolve(const TraceLimits& limits) {
  const bool none = limits.samples == 0 && limits.seconds == 0 && limits.noise == 0;
  const std::uint32_t samples = none                  ? kDefaultSamples
                                : limits.samples == 0 ? 1u << 30
                                                      : limits.samples;
  return {(samples + 1) / 2, limits.seconds, limits.noise};
}

double shareDone(const TraceFilm& film, const HalfLimits& limits, double seconds, double noise) {
  double share = double(film.samples) / limits.half;
  if (limits.seconds > 0) share = std::max(share, seconds / limits.seconds);
  if (limits.noise > 0 && noise > 0) share = std::max(share, std::pow(limits.noise / noise, 2));
  return std::min(share, 1.0);
}

const char* reachedLimit(const TraceFilm& film, const HalfLimits& limits, double seconds, double noise) {
  if (film.samples >= limits.half) return "samples";
  if (limits.seconds > 0 && seconds >= limits.seconds) return "seconds";
  if (limits.noise > 0 && film.samples > 1 && noise <= limits.noise) return "noise";
  return nullptr;
}

}  // namespace

TraceProgress traceUntil(TraceFilm& film, const TraceJob& job, const TraceLimits& asked, const TraceHooks& hooks,
                         Diagnostics& diagnostics) {
  const HalfLimits limits = resolve(asked);
  TraceProgress done;
  const Clock::time_point start = Clock::now();
  double saved = 0;
  std::uint32_t pass = 1;
  for (;;) {
    const double noise = limits.noise > 0 ? film.noise().relative : 0;
    done.seconds = since(start);
    const char* reached = reachedLimit(film, limits, done.seconds, noise);
    if (!reached && hooks.stop && hooks.stop()) reached = "interrupt";
    if (reached) {
      done.stoppedBy = reached;
      break;
    }
    pass = std::min(pass, limits.half - film.samples);
    done.rays += addSamples(film, job.scene, job.camera, job.settings, pass, job.threads);
    const double now = since(start), took = now - done.seconds;
    if (took < kPassSeconds / 2) pass *= 2;
    if (took > kPassSeconds * 2) pass = std::max(1u, pass / 2);
    if (hooks.progress) hooks.progress(shareDone(film, limits, now, noise));
    if (now - saved < kCheckpointSeconds) continue;
    saved = now;
    if (!writeCheckpoint(job.checkpoint, film, job.key, diagnostics)) return done;
  }
  writeCheckpoint(job.checkpoint, film, job.key, diagnostics);
  return done;
}

}  // namespace orris
