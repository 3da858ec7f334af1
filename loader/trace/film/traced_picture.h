// A traced picture as a file, and its checkpoint beside it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <orris/trace/film/trace_until.h>
#include <orris/trace/reference_scene.h>

namespace orris {

/// The file that a picture's work goes on from.
std::string checkpointOf(const std::string& picture);

/// The picture, its halves, and which pixels lie on edges (edgePixels()). false: see diagnostics.
bool writeTraced(const std::string& path, const TraceFilm& film, const std::vector<std::uint8_t>& edges,
                 Diagnostics& diagnostics);

/// What errors on a scene are measured against: the file where it is of the same scene, camera and settings;
/// else traced now and written there. false: see diagnostics; work that was stopped goes on with the next call.
bool provideTraced(const std::string& path, const ReferenceScene& view, const TraceSettings& settings,
                   const TraceLimits& limits, const TraceHooks& hooks, Diagnostics& diagnostics);

}  // namespace orris
