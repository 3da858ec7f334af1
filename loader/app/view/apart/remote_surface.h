// The surface of a process that is shut in: its pictures go to another process, which owns the window.
#pragma once

#include <memory>

#include "app/view/apart/window_link.h"
#include "app/view/surface/hidden_surface.h"

namespace orris {

class RemoteSurface final : public HiddenSurface {
 public:
  /// Waits for the window; nullptr: it does not open. Both must outlive it.
  static std::unique_ptr<RemoteSurface> open(const WindowLink& link);

  std::vector<ViewEvent> poll() override;
  float scale() const override { return scale_; }
  void setTitle(const std::string& title) override;
  void holdMouse(bool hold) override;
  void setFullScreen(bool on) override;
  /// Returns before the picture can be seen, but never draws over one that the window has not taken.
  void show() override;
  std::string openEditor(const std::string& packPath, const SourceLocation& at) override;

 private:
  RemoteSurface(const WindowLink& link, const WindowNews& size);
  void take(const WindowNews& news);
  /// Until the window has taken the last picture.
  void waitForWindow();

  const WindowLink& link_;
  float scale_ = 1;
  bool showing_ = false;
  std::vector<WindowNews> waiting_;  ///< for poll(): a picture keeps its size while it is drawn
};

}  // namespace orris
