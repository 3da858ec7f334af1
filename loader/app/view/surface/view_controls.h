// From events to what the user wants of the view: flying, looking, commands.
#pragma once

#include <set>
#include <vector>

#include "app/view/surface/fly_camera.h"
#include "app/view/surface/view_event.h"
#include "app/view/surface/key_bindings.h"

namespace orris {

/// What the user did since the last frame.
struct ViewInput {
  FlyKeys keys;
  double lookX = 0, lookY = 0;  ///< mouse movement in pixels while the view holds the mouse
  double scroll = 0;
  int camera = -1;  ///< named camera asked for, from 0
  std::vector<ViewCommand> commands;
  bool close = false;
};

/// Which events are meant for what is drawn over the picture.
struct InputTaken {
  bool keys = false, mouse = false;
};

class ViewControls {
 public:
  ViewInput take(const std::vector<ViewEvent>& events, const InputTaken& taken);
  /// Does the view hold the mouse, to look around?
  bool holdsMouse() const { return holdsMouse_; }
  void giveMouseBack() { holdsMouse_ = false; }

 private:
  void takeKey(const ViewEvent& event, ViewInput& input);
  std::set<int> down_;
  double x_ = 0, y_ = 0;
  bool holdsMouse_ = false;
};

}  // namespace orris
