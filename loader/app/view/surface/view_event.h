// What reaches a window, be it from a person or from a script.
#pragma once

namespace orris {

/// Keys have GLFW's numbers; places are pixels of the framebuffer from its top left corner.
struct ViewEvent {
  enum class Kind { Key, Text, Move, Button, Scroll, Close };
  Kind kind = Kind::Key;
  int code = 0;  ///< key, Unicode character, or mouse button (0 left, 1 right, 2 middle)
  bool pressed = false;
  double x = 0, y = 0;  ///< Move: place; Scroll: steps, up positive
};

}  // namespace orris
