#include "app/view/surface/view_window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <utility>

namespace orris {

ViewWindow::ViewWindow(GLFWwindow* window, bool waitForRefresh) : window_(window) {
  glfwSwapInterval(waitForRefresh ? 1 : 0);
  glfwSetWindowUserPointer(window_, this);
  glfwSetKeyCallback(window_, onKey);
  glfwSetCharCallback(window_, onText);
  glfwSetCursorPosCallback(window_, onMove);
  glfwSetMouseButtonCallback(window_, onMouseButton);
  glfwSetScrollCallback(window_, onScroll);
}

ViewWindow::~ViewWindow() {
  glfwSetKeyCallback(window_, nullptr);
  glfwSetCharCallback(window_, nullptr);
  glfwSetCursorPosCallback(window_, nullptr);
  glfwSetMouseButtonCallback(window_, nullptr);
  glfwSetScrollCallback(window_, nullptr);
}

void ViewWindow::add(GLFWwindow* window, const ViewEvent& event) {
  static_cast<ViewWindow*>(glfwGetWindowUserPointer(window))->events_.push_back(event);
}

void ViewWindow::onKey(GLFWwindow* window, int key, int, int action, int) {
  if (action == GLFW_REPEAT) return;
  add(window, {.kind = ViewEvent::Kind::Key, .code = key, .pressed = action == GLFW_PRESS});
}

void ViewWindow::onText(GLFWwindow* window, unsigned character) {
  add(window, {.kind = ViewEvent::Kind::Text, .code = int(character)});
}

void ViewWindow::onMove(GLFWwindow* window, double x, double y) {
  int pixels = 0, units = 0, ignored = 0;
  glfwGetFramebufferSize(window, &pixels, &ignored);
  glfwGetWindowSize(window, &units, &ignored);
  const double ratio = double(pixels) / std::max(units, 1);
  add(window, {.kind = ViewEvent::Kind::Move, .x = x * ratio, .y = y * ratio});
}

void ViewWindow::onMouseButton(GLFWwindow* window, int button, int action, int) {
  add(window,
      {.kind = ViewEvent::Kind::Button, .code = button, .pressed = action == GLFW_PRESS});
}

void ViewWindow::onScroll(GLFWwindow* window, double x, double y) {
  add(window, {.kind = ViewEvent::Kind::Scroll, .x = x, .y = y});
}

std::vector<ViewEvent> ViewWindow::poll() {
  glfwPollEvents();
  if (glfwWindowShouldClose(window_) == GLFW_TRUE)
    events_.push_back({.kind = ViewEvent::Kind::Close});
  return std::exchange(events_, {});
}

void ViewWindow::size(int& width, int& height) const {
  glfwGetFramebufferSize(window_, &width, &height);
}

void ViewWindow::resize(int width, int height) { glfwSetWindowSize(window_, width, height); }

float ViewWindow::scale() const {
  float x = 1, y = 1;
  glfwGetWindowContentScale(window_, &x, &y);
  return std::max({x, y, 1.0f});
}

void ViewWindow::setTitle(const std::string& title) { glfwSetWindowTitle(window_, title.c_str()); }

void ViewWindow::holdMouse(bool hold) {
  glfwSetInputMode(window_, GLFW_CURSOR, hold ? GLFW_CURSOR_DISABLED : GLFW_CURSOR_NORMAL);
}

void ViewWindow::setFullScreen(bool on) {
  GLFWmonitor* monitor = glfwGetPrimaryMonitor();
  const GLFWvidmode* mode = monitor == nullptr ? nullptr : glfwGetVideoMode(monitor);
  if (mode == nullptr) return;
  if (on) {
    glfwGetWindowPos(window_, &windowed_.x, &windowed_.y);
    glfwGetWindowSize(window_, &windowed_.width, &windowed_.height);
    glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
  } else if (windowed_.width > 0) {
    glfwSetWindowMonitor(window_, nullptr, windowed_.x, windowed_.y, windowed_.width,
                         windowed_.height, GLFW_DONT_CARE);
  }
}

void ViewWindow::show() { glfwSwapBuffers(window_); }

}  // namespace orris
