// Two option sets of a pack over the same frames: A, which runs, and B, which was put aside.
#pragma once

#include <array>
#include <chrono>
#include <deque>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>

#include "app/view/surface/view_surface.h"
#include <orris/gl/framebuffer.h>
#include <orris/gl/texture.h>
#include <orris/image/image.h>
#include <orris/render/session/render_session.h>

namespace orris {

enum class CompareMode { Side, Wipe, Flicker, Difference };
inline constexpr std::array<const char*, 4> kCompareModes = {"side", "wipe", "flicker", "difference"};

/// Exists only while sets are compared: without it no frame is drawn twice. Needs its context to be current.
class SetComparison {
 public:
  /// B is what `running` is now: files, values, world. nullptr and diagnostics where it cannot be drawn.
  static std::unique_ptr<SetComparison> create(gl::Context& context, RenderSession& running, unsigned seed,
                                               Diagnostics& diagnostics);

  /// Before `running` draws its next frame: draws that frame with B.
  void drawOther(RenderSession& running, Diagnostics& diagnostics);
  /// After it.
  void endFrame(FrameRenderer& running);
  /// Puts both into the surface.
  void show(FrameRenderer& running, ViewSurface& surface);

  CompareMode mode = CompareMode::Side;
  float wipe = 0.5f;    ///< part of the width that is A's
  bool showsB = false;  ///< while flickering
  /// Seconds of a frame of A and of B: medians of the last 32, the driver waited for.
  std::pair<double, double> costs() const;
  /// Values of A and B where they differ.
  std::map<std::string, std::pair<std::string, std::string>> differingValues(const ShaderPack& a) const;
  const OptionValues& valuesOfB() const { return other_->asked().values; }
  nlohmann::json state(const ShaderPack& a) const;

 private:
  using Clock = std::chrono::steady_clock;
  explicit SetComparison(std::unique_ptr<RenderSession> other) : other_(std::move(other)) {}
  void paintDifference(const FrameRenderer& running);

  std::unique_ptr<RenderSession> other_;
  std::deque<double> secondsA_, secondsB_;
  Clock::time_point began_;
  gl::Texture picture_;  ///< of the difference
  gl::Framebuffer pictureFramebuffer_;
  std::size_t differing_ = 0;  ///< pixels, in the last picture of the difference
  int largest_ = 0;            ///< difference of a channel, of 255
};

}  // namespace orris
