// The reference for shadows of one light: for each pixel whether the light reaches what it shows, by a ray to the light.
#pragma once

#include <functional>

#include <orris/image/image.h>
#include <orris/trace/path_tracer.h>

namespace orris {

/// Does anything stop the light on its way to a surface? `from`: just before the surface, world blocks. `light`: w 0 and
/// the direction to it, or w 1 and its place in world blocks.
using LightStopped =
    std::function<bool(const TraceQuad& on, const glm::dvec3& from, const glm::dvec4& light)>;

/// By what stops the path tracer's rays to the sun: blocks as they are drawn, with the holes of their textures.
/// Translucent ones stop nothing, whatever they leave of the light; nor does the block that the light stands in.
LightStopped stoppedByBlocks(const TraceScene& scene);

/// Faces whose cosine with the light is smaller count as turned away: the normals of the frame have
/// eight bits, so there rounding decides.
constexpr double kGrazing = 0.01;

/// A frame of the same view. Whether a texel of a cutout is a hole two texture units may answer
/// differently, where its alpha is close to the test's: then the frame shows another surface than the
/// pixel's ray meets first, and light is judged there.
struct ShownFrame {
  ImageF depth;          ///< its depth buffer
  long long others = 0;  ///< counts such pixels
};

/// One channel: 1 lit, also where no block is seen; 0 in shadow or turned away. Where the answer
/// changes within the pixel, or within what a frame can know of its middle, lit is 0.75 and dark
/// 0.25. `light`: w 0 and the direction to it, or w 1 and its place in world blocks. What is seen through water is judged, not
/// the water; leaves and plants that turn away are lit through.
ImageF shadowMask(const TraceScene& scene, const TraceCamera& camera, const LightStopped& stopped,
                  const glm::dvec4& light, ShownFrame* shown = nullptr);

}  // namespace orris
