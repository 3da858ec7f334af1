// The pictures of a renderer through the C interface.
#include <algorithm>
#include <vector>

#include <orris/api/renderer.h>
#include <orris/gl/functions.h>

namespace orris::api {
namespace {

OrrisRenderer& drawnRenderer(OrrisRenderer* handle) {
  OrrisRenderer& renderer = live(handle);
  if (!renderer.drawn) fail(ORRIS_ERROR_ORDER, "no frame of this size was drawn");
  return renderer;
}

}  // namespace
}  // namespace orris::api

using namespace orris::api;

OrrisStatus orris_renderer_output(OrrisRenderer* handle, uint32_t framebuffer, int32_t x, int32_t y,
                                  int32_t width, int32_t height) {
  namespace gl = orris::gl;
  return guarded([&] {
    OrrisRenderer& renderer = drawnRenderer(handle);
    checkSize(width, height);
    const Current current(*renderer.context);
    if (framebuffer != 0 && gl::IsFramebuffer(framebuffer) == GL_FALSE)
      fail(ORRIS_ERROR_ARGUMENT,
           std::to_string(framebuffer) + " is no framebuffer of the current context");
    orris::FrameRenderer& frames = renderer.session->renderer();
    gl::BindFramebuffer(GL_READ_FRAMEBUFFER, frames.screenFramebuffer());
    gl::BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    const glm::ivec2 size = frames.size();
    const bool same = size == glm::ivec2(width, height);
    gl::BlitFramebuffer(0, 0, size.x, size.y, x, y, x + width, y + height, GL_COLOR_BUFFER_BIT,
                        same ? GL_NEAREST : GL_LINEAR);
    orris::Diagnostics diagnostics;
    orris::api::addGlErrors(*renderer.context, diagnostics);
    if (!diagnostics.empty()) fail(ORRIS_ERROR_ARGUMENT, diagnostics.front().message);
  });
}

OrrisStatus orris_renderer_read(OrrisRenderer* handle, void* rgba, size_t bytes) {
  namespace gl = orris::gl;
  return guarded([&] {
    OrrisRenderer& renderer = drawnRenderer(handle);
    refuseNull(rgba, "rgba");
    orris::FrameRenderer& frames = renderer.session->renderer();
    const auto width = static_cast<std::size_t>(frames.size().x),
               height = static_cast<std::size_t>(frames.size().y), row = width * 4;
    if (bytes != row * height)
      fail(ORRIS_ERROR_ARGUMENT,
           "bytes is " + std::to_string(bytes) +
               " and must be width*height*4 = " + std::to_string(row * height));
    const Current current(*renderer.context);
    std::vector<unsigned char> rows(row * height);
    gl::BindFramebuffer(GL_READ_FRAMEBUFFER, frames.screenFramebuffer());
    gl::PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl::ReadPixels(0, 0, frames.size().x, frames.size().y, GL_RGBA, GL_UNSIGNED_BYTE, rows.data());
    for (std::size_t i = 3; i < rows.size(); i += 4) rows[i] = 255;
    // GL's first row is the lowest.
    for (std::size_t y = 0; y < height; ++y)
      std::copy_n(rows.data() + (height - 1 - y) * row, row,
                  static_cast<unsigned char*>(rgba) + y * row);
  });
}

OrrisStatus orris_renderer_texture(OrrisRenderer* handle, const char* name, uint32_t* out) {
  return guarded([&] {
    OrrisRenderer& renderer = drawnRenderer(handle);
    refuseNull(name, "name");
    refuseNull(out, "out");
    const orris::FrameRenderer& frames = renderer.session->renderer();
    const orris::gl::Texture* texture = frames.texture(frames.finalSide(name));
    if (texture == nullptr || texture->id() == 0 || texture->target != GL_TEXTURE_2D)
      fail(ORRIS_ERROR_NOT_FOUND, std::string("no 2-D texture \"") + name +
                                      "\" in the frame; there are: " + frames.bufferNames());
    *out = texture->id();
  });
}
