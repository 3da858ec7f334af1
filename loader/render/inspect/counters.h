// What a pack counts in its images, read back.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <orris/core/diagnostic.h>
#include <orris/render/frame_renderer.h>

namespace orris {

/// By image (isCounter()), after the last frame.
std::map<std::string, std::vector<long long>> readCounters(const FrameRenderer& renderer);

/// A warning `pack-counter` for each `warn.*` line of the pack whose number is not 0.
Diagnostics counterWarnings(const FrameRenderer& renderer);

}  // namespace orris
