// Which step of a frame is the first to write what is no finite number.
#pragma once

#include <string>
#include <vector>

#include <orris/core/diagnostic.h>
#include <orris/render/frame_renderer.h>

namespace orris {

/// Give its after() to FrameRenderer::watchSteps(). It reads back all that each step writes, until the
/// first frame with a finding is over.
class FiniteCheck {
 public:
  explicit FiniteCheck(const FrameRenderer& renderer) : renderer_(renderer) {}

  /// `frame`: number of the frame being drawn, from 0.
  void after(const Step& step, int frame);
  /// An error `not-finite` that names step, buffer, pixel and value; none where all was finite.
  Diagnostics findings() const;

 private:
  struct Finding {
    int frame = 0;
    std::string step, file;
    BufferSide side;
    int x = 0, y = 0;  ///< top row first
    int pixels = 0;    ///< so many are not finite
    float value = 0;
  };
  const FrameRenderer& renderer_;
  std::vector<Finding> findings_;  ///< of one frame, each step and buffer once
};

}  // namespace orris
