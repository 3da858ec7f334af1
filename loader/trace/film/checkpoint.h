// A film in a file, so that tracing can go on later, elsewhere, or in parts.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <orris/core/diagnostic.h>
#include <orris/trace/film/trace_film.h>
#include <orris/trace/path_tracer.h>

namespace orris {

/// Of the sources of the path tracer and of the formulas that it shares with the pack.
extern const std::uint64_t kTracerCode;

/// A number that differs when a picture would: made from scene, light, camera, settings and the tracer's code. Films of
/// equal keys may be continued and merged.
std::uint64_t traceKey(const TraceScene& scene, const TraceCamera& camera, const TraceSettings& settings,
                       std::uint64_t code = kTracerCode);

/// Written beside `path` and renamed. false and a diagnostic on failure.
bool writeCheckpoint(const std::string& path, const TraceFilm& film, std::uint64_t key,
                     Diagnostics& diagnostics);

/// nullopt and a diagnostic when the file is none, is damaged, or belongs to another picture.
std::optional<TraceFilm> readCheckpoint(const std::string& path, std::uint64_t key,
                                        Diagnostics& diagnostics);

/// The whole picture from all of its shards, each once, with as many samples each; `names` are
/// theirs, for messages.
std::optional<TraceFilm> mergeShards(const std::vector<TraceFilm>& shards,
                                     const std::vector<std::string>& names,
                                     Diagnostics& diagnostics);

}  // namespace orris
