// What `orris view` draws to: a window, or nothing that anybody sees; and what it opens beside it.
#pragma once

#include <string>
#include <vector>

#include "app/view/files/open_editor.h"
#include "app/view/surface/view_event.h"

namespace orris {

/// Sizes are pixels of the framebuffer. Needs its context to be current.
class ViewSurface {
 public:
  virtual ~ViewSurface() = default;

  /// What happened since the last call.
  virtual std::vector<ViewEvent> poll() = 0;
  /// 0 while minimised.
  virtual void size(int& width, int& height) const = 0;
  virtual void resize(int width, int height) = 0;
  /// Pixels for one of a display of usual density.
  virtual float scale() const { return 1; }
  virtual void setTitle(const std::string&) {}
  /// The mouse does not leave, and cannot be seen.
  virtual void holdMouse(bool) {}
  virtual void setFullScreen(bool) {}
  /// What is drawn to before show().
  virtual unsigned framebuffer() = 0;
  virtual void show() = 0;
  /// The user's editor at a place of a pack. A problem in words, or "".
  virtual std::string openEditor(const std::string& packPath, const SourceLocation& at) {
    return openInEditor(packPath, at);
  }
};

}  // namespace orris
