// Flying through a world with keys and mouse.
#pragma once

#include <orris/world/world.h>

namespace orris {

/// Directions are -1, 0 or 1: which keys are down.
struct FlyKeys {
  int forward = 0;  ///< level, whatever the pitch, as in the game
  int right = 0;
  int up = 0;
};

/// Keeps a camera moving; speed is in blocks a second.
class FlyCamera {
 public:
  explicit FlyCamera(const Camera& camera) : camera_(camera) {}

  const Camera& camera() const { return camera_; }
  double speed() const { return speed_; }
  /// Jumps to a named camera; the speed stays.
  void set(const Camera& camera) { camera_ = camera; }

  /// Turns by a mouse movement in pixels, right and down positive; pitch stops at straight up and
  /// down, yaw stays within -180 and 180.
  void look(double dx, double dy);
  /// Moves for `seconds`; diagonal movement is not faster.
  void move(const FlyKeys& keys, double seconds);
  /// Scroll steps, up positive: each multiplies the speed, within limits.
  void scroll(double steps);

 private:
  Camera camera_;
  double speed_ = 8;
};

}  // namespace orris
