// One buffer of a frame as it stands after a step: pixels of a texture's level, or words of a storage
// buffer. For whoever looks into a frame; nothing is read where nobody asks.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <orris/render/frame_renderer.h>

namespace orris {

/// What to look at.
struct BufferRequest {
  enum class Side { Written, Main, Alt };
  std::string buffer;  ///< as dump() takes it, "screen", or "bufferObject.N"
  std::string step;    ///< after the last step of this name; "": after the frame
  Side side = Side::Written;  ///< Written: where the value is after the step
  int level = 0, slice = 0;
  std::size_t offset = 0;  ///< bytes, of a bufferObject; a multiple of 4
  bool operator==(const BufferRequest&) const = default;
};

struct BufferView {
  BufferSide side;
  int levels = 1, slices = 1;
  int level = 0, slice = 0;  ///< what was read: the nearest that there is
  ImageF pixels;             ///< top row first; empty of a bufferObject
  std::size_t bytes = 0, offset = 0;
  std::vector<std::uint32_t> words;  ///< kViewWords at most
};
inline constexpr std::size_t kViewWords = 1024;

/// Side of a buffer that holds what it is worth after a step.
BufferSide sideAfter(const FrameRenderer& renderer, const Step& step, const std::string& buffer);

/// The number of "bufferObject.N".
std::optional<int> storageNumber(const std::string& buffer);

/// To be called after the step, or after the frame with nullptr. nullopt: the frame has no such buffer.
std::optional<BufferView> viewBuffer(const FrameRenderer& renderer, const Step* step,
                                     const BufferRequest& request);

/// Is `step` the one of the frame that the request names?
bool isAsked(const FrameRenderer& renderer, const Step& step, const BufferRequest& request);

/// What cannot be done of a request and what there is in its place; "" when it can be.
std::string problemOf(const FrameRenderer& renderer, const BufferRequest& request);

/// All that can be looked at: targets, depth, images, the screen, storage buffers.
std::vector<std::string> viewableBuffers(const FrameRenderer& renderer);

}  // namespace orris
