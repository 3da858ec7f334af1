#include "app/view/view_window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <utility>

#include "gl/functions.h"

namespace orris {
namespace {

struct KeyCommand {
  int key;
  bool ViewInput::*command;
};
constexpr KeyCommand kKeyCommands[] = {{GLFW_KEY_R, &ViewInput::reload},
                                       {GLFW_KEY_O, &ViewInput::nextProfile},
                                       {GLFW_KEY_F2, &ViewInput::screenshot}};

struct MoveKey {
  int key;
  int FlyKeys::*axis;
  int direction;
};
constexpr MoveKey kMoves[] = {
    {GLFW_KEY_W, &FlyKeys::forward, 1}, {GLFW_KEY_S, &FlyKeys::forward, -1},
    {GLFW_KEY_D, &FlyKeys::right, 1},   {GLFW_KEY_A, &FlyKeys::right, -1},
    {GLFW_KEY_SPACE, &FlyKeys::up, 1},  {GLFW_KEY_LEFT_SHIFT, &FlyKeys::up, -1}};

}  // namespace

ViewWindow::ViewWindow(GLFWwindow* window) : window_(window) {
  glfwSetWindowUserPointer(window_, this);
  glfwSetKeyCallback(window_, onKey);
  glfwSetMouseButtonCallback(window_, onMouseButton);
  glfwSetScrollCallback(window_, onScroll);
}

ViewWindow::~ViewWindow() {
  glfwSetKeyCallback(window_, nullptr);
  glfwSetMouseButtonCallback(window_, nullptr);
  glfwSetScrollCallback(window_, nullptr);
}

void ViewWindow::setRefreshWait(bool wait) { glfwSwapInterval(wait ? 1 : 0); }

ViewInput& ViewWindow::inputOf(GLFWwindow* window) {
  return static_cast<ViewWindow*>(glfwGetWindowUserPointer(window))->input_;
}

void ViewWindow::onKey(GLFWwindow* window, int key, int, int action, int) {
  if (action != GLFW_PRESS) return;
  ViewInput& input = inputOf(window);
  for (const KeyCommand& row : kKeyCommands) {
    if (row.key == key) input.*row.command = true;
  }
  if (key >= GLFW_KEY_1 && key <= GLFW_KEY_9) input.camera = key - GLFW_KEY_1;
  if (key != GLFW_KEY_ESCAPE) return;
  const bool held = glfwGetInputMode(window, GLFW_CURSOR) == GLFW_CURSOR_DISABLED;
  if (held) glfwSetInputMode(window, GLFW_CURSOR, GLFW_CURSOR_NORMAL);
  input.close |= !held;
}

void ViewWindow::onMouseButton(GLFWwindow* window, int, int action, int) {
  if (action == GLFW_PRESS) glfwSetInputMode(window, GLFW_CURSOR, GLFW_CURSOR_DISABLED);
}

void ViewWindow::onScroll(GLFWwindow* window, double, double y) { inputOf(window).scroll += y; }

bool ViewWindow::holdsMouse() const {
  return glfwGetInputMode(window_, GLFW_CURSOR) == GLFW_CURSOR_DISABLED;
}

ViewInput ViewWindow::poll() {
  glfwPollEvents();
  ViewInput input = std::exchange(input_, {});
  for (const MoveKey& move : kMoves) {
    if (glfwGetKey(window_, move.key) == GLFW_PRESS) input.keys.*move.axis += move.direction;
  }
  const double lastX = mouseX_, lastY = mouseY_;
  glfwGetCursorPos(window_, &mouseX_, &mouseY_);
  // The position jumps when the mouse is taken or given back.
  if (std::exchange(heldMouse_, holdsMouse()) && heldMouse_) {
    input.lookX = mouseX_ - lastX;
    input.lookY = mouseY_ - lastY;
  }
  input.close |= glfwWindowShouldClose(window_) == GLFW_TRUE;
  return input;
}

void ViewWindow::size(int& width, int& height) const {
  glfwGetFramebufferSize(window_, &width, &height);
}

void ViewWindow::setTitle(const std::string& title) { glfwSetWindowTitle(window_, title.c_str()); }

void ViewWindow::show(unsigned framebuffer, int width, int height) {
  int windowWidth = 0, windowHeight = 0;
  size(windowWidth, windowHeight);
  gl::Disable(GL_SCISSOR_TEST);
  gl::BlitNamedFramebuffer(framebuffer, 0, 0, 0, width, height, 0, 0, windowWidth, windowHeight,
                           GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glfwSwapBuffers(window_);
}

}  // namespace orris
