#include "app/commands/trace_loop.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>

#include "app/output/progress.h"
#include <orris/image/image.h>
#include <orris/trace/film/checkpoint.h>

namespace orris {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kPassSeconds = 0.5;
constexpr double kCheckpointSeconds = 30;

std::atomic<bool> traceInterrupted{false};

/// Ctrl-C asks to stop; a second one ends the program as always.
class InterruptGuard {
 public:
  InterruptGuard() {
    traceInterrupted = false;
    before_ = std::signal(SIGINT, [](int) {
      traceInterrupted = true;
      std::signal(SIGINT, SIG_DFL);
    });
  }
  ~InterruptGuard() { std::signal(SIGINT, before_); }
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

 private:
  void (*before_)(int) = SIG_DFL;
};

double since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

struct Limits {
  std::uint32_t half = 0;  ///< samples of each half
  double seconds = 0, noise = 0;
};

Limits resolve(const TraceLimits& limits) {
  const bool none = limits.samples == 0 && limits.seconds == 0 && limits.noise == 0;
  const std::uint32_t samples = none                  ? kDefaultSamples
                                : limits.samples == 0 ? 1u << 30
                                                      : limits.samples;
  return {(samples + 1) / 2, limits.seconds, limits.noise};
}

/// Share of the work that is done, 0..1, by the limit that is nearest.
double shareDone(const TraceFilm& film, const Limits& limits, double seconds, double noise) {
  double share = double(film.samples) / limits.half;
  if (limits.seconds > 0) share = std::max(share, seconds / limits.seconds);
  if (limits.noise > 0 && noise > 0) share = std::max(share, std::pow(limits.noise / noise, 2));
  return std::min(share, 1.0);
}

const char* reachedLimit(const TraceFilm& film, const Limits& limits, double seconds,
                         double noise) {
  if (film.samples >= limits.half) return "samples";
  if (limits.seconds > 0 && seconds >= limits.seconds) return "seconds";
  if (limits.noise > 0 && film.samples > 1 && noise <= limits.noise) return "noise";
  return traceInterrupted ? "interrupt" : nullptr;
}

bool save(const TraceJob& job, const TraceFilm& film, Report& report) {
  Diagnostics diagnostics;
  const bool written = writeCheckpoint(job.checkpoint, film, job.key, diagnostics);
  report.add(diagnostics);
  return written;
}

}  // namespace

TraceProgress traceUntil(TraceFilm& film, const TraceJob& job, const TraceLimits& asked,
                         Report& report) {
  const Limits limits = resolve(asked);
  const InterruptGuard guard;
  Progress bar("tracing %", 100, report.output());
  TraceProgress done;
  const Clock::time_point start = Clock::now();
  double saved = 0;
  std::uint32_t pass = 1;
  for (;;) {
    const double noise = limits.noise > 0 ? film.noise().relative : 0;
    done.seconds = since(start);
    if (const char* reached = reachedLimit(film, limits, done.seconds, noise)) {
      done.stoppedBy = reached;
      break;
    }
    pass = std::min(pass, limits.half - film.samples);
    done.rays += addSamples(film, job.scene, job.camera, job.settings, pass, job.threads);
    const double now = since(start), took = now - done.seconds;
    if (took < kPassSeconds / 2) pass *= 2;
    if (took > kPassSeconds * 2) pass = std::max(1u, pass / 2);
    bar.advanceTo(int(100 * shareDone(film, limits, now, noise)));
    if (now - saved < kCheckpointSeconds) continue;
    saved = now;
    if (!save(job, film, report)) return done;
  }
  save(job, film, report);
  return done;
}

bool writeTraced(const std::string& path, const TraceFilm& film,
                 const std::vector<std::uint8_t>& edges, Report& report) {
  static const std::vector<std::string> kChannels = {
      "R",       "G",        "B",        "first.R",  "first.G",
      "first.B", "second.R", "second.G", "second.B", "undecided.V"};
  const ImageF halves = film.image();
  ImageF image(film.width, film.height, int(kChannels.size()));
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto from = halves.pixels.begin() + std::ptrdiff_t(i * 9);
    const auto to = image.pixels.begin() + std::ptrdiff_t(i * kChannels.size());
    *std::copy(from, from + 9, to) = float(edges[i]);
  }
  Diagnostics diagnostics;
  const bool written = writeImage(path, image, kChannels, diagnostics);
  report.add(diagnostics);
  return written;
}

}  // namespace orris
