// The window of `orris view`.
#pragma once

#include "app/view/surface/view_surface.h"

struct GLFWwindow;

namespace orris {

class ViewWindow final : public ViewSurface {
 public:
  /// `waitForRefresh`: show() waits for the screen, where the driver can.
  ViewWindow(GLFWwindow* window, bool waitForRefresh);
  ~ViewWindow() override;
  ViewWindow(const ViewWindow&) = delete;
  ViewWindow& operator=(const ViewWindow&) = delete;

  std::vector<ViewEvent> poll() override;
  void size(int& width, int& height) const override;
  void resize(int width, int height) override;
  float scale() const override;
  void setTitle(const std::string& title) override;
  void holdMouse(bool hold) override;
  void setFullScreen(bool on) override;
  unsigned framebuffer() override { return 0; }
  void show() override;

 private:
  static void add(GLFWwindow* window, const ViewEvent& event);
  static void onKey(GLFWwindow* window, int key, int code, int action, int modifiers);
  static void onText(GLFWwindow* window, unsigned character);
  static void onMove(GLFWwindow* window, double x, double y);
  static void onMouseButton(GLFWwindow* window, int button, int action, int modifiers);
  static void onScroll(GLFWwindow* window, double x, double y);

  GLFWwindow* window_;
  std::vector<ViewEvent> events_;
  struct {
    int x = 0, y = 0, width = 0, height = 0;
  } windowed_;  ///< place and size to come back to from the full screen
};

}  // namespace orris
