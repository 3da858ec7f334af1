// Pixels whose middle lies on an edge: a rasteriser, which rounds corners to parts of a pixel, may show
// one surface there and a ray meet the other. Neither is wrong.
#pragma once

#include <cstdint>
#include <vector>

#include <orris/trace/path_tracer.h>

namespace orris {

/// Corners are rounded to 1/256 of a pixel (GL's least is 1/16, what drivers have 1/256).
inline constexpr double kEdgeReach = 1.0 / 256;

/// By pixel, row by row from the top left: 1 where rays that pass kEdgeReach from the middle, along
/// both diagonals, meet other surfaces than the one through it.
std::vector<std::uint8_t> edgePixels(const TraceScene& scene, const TraceCamera& camera);

}  // namespace orris
