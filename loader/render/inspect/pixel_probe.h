// The value of one pixel after every step of a frame that wrote it.
#pragma once

#include <string>
#include <vector>

#include <orris/render/frame_renderer.h>

namespace orris {

struct ProbeValue {
  std::string step;  ///< "composite3"
  BufferSide side;
  int x = 0, y = 0;  ///< the texel, top row first as in dump()
  std::vector<float> value;
};

/// Give its after() to FrameRenderer::watchSteps(). Shadow maps and 3-D images have no pixel of the
/// screen and are left out; what a program stores to an image is listed where it changed the value.
class PixelProbe {
 public:
  /// `x`, `y`: pixel of the screen, from its top left.
  PixelProbe(const FrameRenderer& renderer, int x, int y) : renderer_(renderer), x_(x), y_(y) {}

  void after(const Step& step);
  /// Of the frame, in its order.
  const std::vector<ProbeValue>& values() const { return values_; }
  void clear() { values_.clear(); }

 private:
  const FrameRenderer& renderer_;
  int x_, y_;
  std::vector<ProbeValue> values_;
};

/// Is it drawn to by the step itself, and not an image that one of its programs has?
bool isDrawnBy(const Step& step, const BufferSide& side);

}  // namespace orris
