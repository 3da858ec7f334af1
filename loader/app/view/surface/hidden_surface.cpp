#include "app/view/surface/hidden_surface.h"

#include <algorithm>

namespace orris {

void HiddenSurface::size(int& width, int& height) const {
  width = texture_.width;
  height = texture_.height;
}

void HiddenSurface::resize(int width, int height) {
  const TextureFormat& format = *findFormat("RGBA8");
  texture_ = gl::createTexture(2, format, std::max(width, 1), std::max(height, 1), 1, 1, "window");
  std::string error;
  framebuffer_ = gl::createFramebuffer({&texture_}, nullptr, "window", error);
}

}  // namespace orris
