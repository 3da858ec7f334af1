// One setting, loaded and kept, so that settings can be measured in turns.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <orris/render/session/render_session.h>

namespace orris {

/// What times frames: passing time, or the processor time of all threads, which other programs on a
/// busy machine do not add to and which says nothing about a graphics card.
enum class FrameClock { Wall, Processor };
/// What the clock shows.
double millisecondsOf(FrameClock clock);

/// A few frames in a row.
struct Visit {
  std::vector<double> frames;                          ///< milliseconds of each
  std::vector<std::pair<std::string, double>> passes;  ///< milliseconds a frame, in frame order
  double mean() const;
};

/// Draws a world, its events included.
class SettingSession {
 public:
  /// nullptr when the pack cannot be rendered; see diagnostics.
  static std::unique_ptr<SettingSession> open(gl::Context& context, SessionRequest request,
                                              World world, Diagnostics& diagnostics);

  void draw(Diagnostics& diagnostics) { session_->renderFrame(diagnostics); }
  /// From now on clouds, water and all that moves with time stand still, so that frames differ by their
  /// noise only.
  void stopClock() { session_->setFrameTime(kStill); }
  /// Draws one frame more than it times: the first finds the processor's caches full of another
  /// setting's pictures.
  Visit visit(int frames, FrameClock clock, Diagnostics& diagnostics);
  /// Three channels, linear: the screen decoded from sRGB, or a buffer as it is. nullopt when there is
  /// no such buffer, or it is not as large as the screen.
  std::optional<ImageF> picture(const std::string& buffer) const;
  const FrameRenderer& renderer() const { return session_->renderer(); }
  /// For options that are AUTO; "" where none is.
  std::string chosen() const { return session_->autoChoices().text(); }

 private:
  /// Not 0: packs divide by the time of a frame.
  static constexpr float kStill = 1e-6f;  // seconds
  explicit SettingSession(std::unique_ptr<RenderSession> session) : session_(std::move(session)) {}
  std::unique_ptr<RenderSession> session_;
};

/// In which order `count` sessions take their turns in one round: there and back, so that a steady
/// drift of the machine is the same for all. With two: A B B A.
std::vector<std::size_t> turns(std::size_t count);

/// Bytes that this machine can still give without swapping; nullopt where it does not say.
std::optional<std::size_t> availableMemory();

}  // namespace orris
