#include <orris/trace/film/trace_run.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>

namespace orris {
namespace {

// Sets the second half's random numbers apart from the first's.
constexpr std::uint64_t kHalfSeed = 0x5851f42d4c957f2d;

struct Work {
  TraceFilm& film;
  const PathTracer& tracer;
  std::uint64_t seed = 0;
  std::uint32_t samples = 0;
};

/// A row of a tile: a picture smaller than a tile has work for several threads, too.
void sampleRow(const Work& work, int tile, int row, RayCounts& counts) {
  TraceFilm& film = work.film;
  const int left = tile % film.tileColumns() * TraceFilm::kTile;
  const int y = tile / film.tileColumns() * TraceFilm::kTile + row;
  if (y >= film.height) return;
  for (int x = left; x < std::min(left + TraceFilm::kTile, film.width); ++x) {
    const PixelView view = work.tracer.view(x, y, counts);
    const std::size_t pixel = std::size_t(y) * std::size_t(film.width) + std::size_t(x);
    for (std::size_t half = 0; half < 2; ++half) {
      glm::dvec3& sum = film.sums[half][pixel];
      for (std::uint32_t i = film.samples; i < film.samples + work.samples; ++i) {
        SampleRandom random(work.seed + half * kHalfSeed, std::uint32_t(pixel), i);
        sum += glm::dvec3(work.tracer.sample(view, random, counts));
      }
    }
  }
}

}  // namespace

RayCounts addSamples(TraceFilm& film, const TraceScene& scene, const TraceCamera& camera,
                     const TraceSettings& settings, std::uint32_t samples, int threads) {
  const PathTracer tracer(scene, camera, settings);
  const Work work{film, tracer, settings.seed, samples};
  const int rows = film.tileCount() * TraceFilm::kTile;
  std::atomic<int> nextRow{0};
  const auto count =
      std::size_t(threads > 0 ? threads : int(std::max(1u, std::thread::hardware_concurrency())));
  std::vector<RayCounts> counts(count);
  const auto serve = [&](std::size_t who) {
    RayCounts own;
    for (int next = nextRow++; next < rows; next = nextRow++) {
      const int tile = next / TraceFilm::kTile;
      if (film.holdsTile(tile)) sampleRow(work, tile, next % TraceFilm::kTile, own);
    }
    counts[who] = own;
  };
  // An exception that leaves a thread would end the process.
  std::vector<std::exception_ptr> failures(count);
  {
    std::vector<std::jthread> helpers;
    for (std::size_t i = 1; i < count; ++i) {
      helpers.emplace_back([&, i] {
        try {
          serve(i);
        } catch (...) {
          failures[i] = std::current_exception();
        }
      });
    }
    serve(0);
  }
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
  film.samples += samples;
  RayCounts total;
  for (const RayCounts& own : counts) total += own;
  return total;
}

TraceFilm trace(const TraceScene& scene, const TraceCamera& camera, const TraceSettings& settings,
                std::uint32_t samples, int threads) {
  TraceFilm film(camera.width, camera.height, {});
  addSamples(film, scene, camera, settings, samples, threads);
  return film;
}

}  // namespace orris
