// The buffer that the window shows: read once a frame, and painted into a texture for its panel.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "app/input/shown_buffer.h"
#include <orris/gl/texture.h>

namespace orris {

/// Exists only while a buffer is shown: what it holds and copies costs nothing without it. Needs its
/// context to be current.
class BufferInspector {
 public:
  explicit BufferInspector(ShownBuffer asked) : asked_(std::move(asked)) {}

  void ask(ShownBuffer asked) { asked_ = std::move(asked); }
  const ShownBuffer& asked() const { return asked_; }
  /// Give it to FrameRenderer::watchSteps().
  void after(const FrameRenderer& renderer, const Step& step);
  /// After each frame.
  void endFrame(const FrameRenderer& renderer);

  /// Of the last frame; nullopt and problem(): the frame has no such buffer or pass.
  const std::optional<BufferView>& view() const { return view_; }
  const std::string& problem() const { return problem_; }
  const ValueFacts& facts() const { return facts_; }
  std::pair<float, float> range() const { return range_; }
  /// Painted as asked for; id 0 of a bufferObject.
  const gl::Texture& texture() const { return texture_; }
  nlohmann::json state() const;
  /// Buffers read back by all inspectors of this process.
  static int copies();

 private:
  void take(std::optional<BufferView> view);
  void paint();

  ShownBuffer asked_;
  std::optional<BufferView> view_, taken_;
  std::string problem_;
  ValueFacts facts_;
  std::pair<float, float> range_{0, 1};
  gl::Texture texture_;
};

}  // namespace orris
