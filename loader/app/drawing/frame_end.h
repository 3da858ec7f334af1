// How many frames `orris render` draws: --frames.
#pragma once

#include <optional>
#include <string>

#include <orris/image/picture_settling.h>
#include <orris/render/session/render_session.h>

namespace CLI {
class App;
}  // namespace CLI

namespace orris {

struct FramesWanted {
  bool untilSettled = true;
  int most = 256;  ///< where not until it settled: exactly so many
};

void addSettlingFramesFlag(CLI::App& command, FramesWanted& frames);

/// Which frame is the last. Until the picture settled: a power of two after the last event of the world, 32 or more.
class FrameEnd {
 public:
  FrameEnd(const FramesWanted& wanted, const World& world);

  /// Of a frame that is not drawn yet, counted from 0.
  bool isLast(int frame) const { return settled_ || frame + 1 >= wanted_.most; }
  /// After each frame; looks at a few of the pictures.
  void drawn(int frame, const FrameRenderer& renderer);
  /// nullopt where nobody asked whether it settles.
  std::optional<bool> settled() const;

 private:
  FramesWanted wanted_;
  int start_ = 0;  ///< the frame of the last event
  bool settled_ = false;
  PictureSettling settling_;
};

}  // namespace orris
