// Samples for a whole picture on several threads.
#pragma once

#include <orris/trace/film/trace_film.h>
#include <orris/trace/path_tracer.h>

namespace orris {

/// Adds `samples` to each half of every pixel of the film's shard. The result depends on scene, camera,
/// settings and the numbers of the samples alone: not on the threads, nor on how samples are divided
/// into calls. Takes the calling thread too; 0 threads: as many as the machine has.
RayCounts addSamples(TraceFilm& film, const TraceScene& scene, const TraceCamera& camera,
                     const TraceSettings& settings, std::uint32_t samples, int threads);

/// Scene and camera to a film: `samples` in each half.
TraceFilm trace(const TraceScene& scene, const TraceCamera& camera, const TraceSettings& settings,
                std::uint32_t samples, int threads = 0);

}  // namespace orris
