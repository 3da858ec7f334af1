// The window of a process that draws nothing itself: it shows the pictures of another process and sends it
// what the user does.
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/view/apart/window_link.h"
#include "app/view/surface/view_window.h"
#include <orris/gl/context.h>
#include <orris/gl/framebuffer.h>
#include <orris/gl/texture.h>

namespace orris {

struct WindowRequest {
  int width = 1, height = 1;
  gl::ContextProfile profile = gl::ContextProfile::Auto;
  bool waitForRefresh = false;
  std::string packPath;  ///< whose files an editor may be opened for
};

class ShownWindow {
 public:
  ShownWindow(WindowRequest request, const WindowLink& link) : request_(std::move(request)), link_(link) {}

  /// Opens the window, unless it is open. false, with diagnostics: it cannot be.
  bool open(Diagnostics& diagnostics);
  /// Is the window's own driver a software rasteriser? Then the other process draws as fast, by EGL.
  bool drawsElsewhere() const;
  /// To draw with here, where the other process shall not; nullptr where it does or no window is open.
  std::unique_ptr<gl::Context> takeContext();
  /// Takes the orders that came and sends what happened; to be called some hundred times a second.
  void attend();

 private:
  void obey(const WindowOrder& order);
  void show(int width, int height);
  void edit(const WindowOrder& order);
  void sendSize();
  void flush();

  WindowRequest request_;
  const WindowLink& link_;
  std::unique_ptr<gl::Context> context_;
  std::unique_ptr<ViewWindow> window_;
  gl::Texture picture_;
  gl::Framebuffer framebuffer_;  ///< of the picture
  int width_ = 0, height_ = 0;   ///< of the window, as last sent
  bool mayEdit_ = false;         ///< since the last editor the user has pressed something
  std::deque<WindowNews> unsent_;
};

}  // namespace orris
