// Dear ImGui over the picture: events in, drawing out, and what can be clicked by name.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "app/view/script/script_player.h"
#include "app/view/surface/view_controls.h"
#include "app/view/surface/view_event.h"

namespace orris {

/// Needs its context to be current; one at a time.
class Interface {
 public:
  explicit Interface(float scale);
  ~Interface();
  Interface(const Interface&) = delete;
  Interface& operator=(const Interface&) = delete;

  /// false: this driver cannot draw it.
  bool usable() const { return usable_; }
  /// Starts a frame; sizes are pixels.
  void begin(const std::vector<ViewEvent>& events, int width, int height, double seconds);
  /// Which of the events were meant for it.
  InputTaken taken() const;
  /// Where the mouse is, in pixels.
  std::pair<double, double> mouse() const;
  /// Draws what was built since begin().
  void end(unsigned framebuffer);

  /// Names what was built last, for scripts.
  void name(const std::string& item);
  const std::map<std::string, ScreenItem>& items() const { return shown_; }

 private:
  void feed(const ViewEvent& event);
  bool usable_ = false;
  bool justPressed_[3] = {};  ///< buttons pressed and let go within one frame count as pressed
  bool held_[3] = {};
  std::map<std::string, ScreenItem> building_, shown_;
};

}  // namespace orris
