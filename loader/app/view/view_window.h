// The window of `orris view`: what the user did, and showing a picture.
#pragma once

#include <string>

#include "app/view/fly_camera.h"

struct GLFWwindow;

namespace orris {

/// What the user did since the last frame.
struct ViewInput {
  FlyKeys keys;
  double lookX = 0, lookY = 0;  ///< mouse movement in pixels while the window holds the mouse
  double scroll = 0;
  int camera = -1;  ///< named camera asked for, from 0
  bool reload = false, nextProfile = false, screenshot = false;
  bool close = false;
};

/// Needs the window's context to be current.
class ViewWindow {
 public:
  explicit ViewWindow(GLFWwindow* window);
  ~ViewWindow();
  ViewWindow(const ViewWindow&) = delete;
  ViewWindow& operator=(const ViewWindow&) = delete;

  /// Waits for the screen's refresh in show(), where the driver can.
  void setRefreshWait(bool wait);
  ViewInput poll();
  /// Size in pixels; 0 while minimised.
  void size(int& width, int& height) const;
  void setTitle(const std::string& title);
  /// Copies a framebuffer's first colour attachment to the whole window and shows it.
  void show(unsigned framebuffer, int width, int height);

 private:
  static ViewInput& inputOf(GLFWwindow* window);
  static void onKey(GLFWwindow* window, int key, int code, int action, int modifiers);
  static void onMouseButton(GLFWwindow* window, int button, int action, int modifiers);
  static void onScroll(GLFWwindow* window, double x, double y);
  bool holdsMouse() const;

  GLFWwindow* window_;
  ViewInput input_;
  double mouseX_ = 0, mouseY_ = 0;
  bool heldMouse_ = false;
};

}  // namespace orris
