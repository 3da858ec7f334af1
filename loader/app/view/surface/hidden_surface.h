// A surface without a display: a texture in place of a window.
#pragma once

#include "app/view/surface/view_surface.h"
#include <orris/gl/framebuffer.h>
#include <orris/gl/texture.h>

namespace orris {

class HiddenSurface : public ViewSurface {
 public:
  HiddenSurface(int width, int height) { resize(width, height); }

  std::vector<ViewEvent> poll() override { return {}; }
  void size(int& width, int& height) const override;
  void resize(int width, int height) override;
  unsigned framebuffer() override { return framebuffer_.id(); }
  void show() override {}

 private:
  gl::Texture texture_;
  gl::Framebuffer framebuffer_;
};

}  // namespace orris
