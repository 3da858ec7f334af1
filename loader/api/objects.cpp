// Buffers and textures for programs that have no GL of their own.
#include <algorithm>
#include <cmath>
#include <vector>

#include <orris/api/context.h>
#include <orris/gl/functions.h>

namespace orris::api {
namespace {

int mostLevels(int width, int height) {
  return 1 + static_cast<int>(std::floor(std::log2(std::max(width, height))));
}

}  // namespace
}  // namespace orris::api

using namespace orris::api;

OrrisStatus orris_buffer_create(OrrisContext* handle, const void* data, size_t bytes,
                                uint32_t* out) {
  namespace gl = orris::gl;
  return guarded([&] {
    OrrisContext& context = live(handle);
    refuseNull(out, "out");
    *out = 0;
    if (bytes == 0 || bytes > size_t{1} << 31)
      fail(ORRIS_ERROR_ARGUMENT, "bytes must be 1 to 2^31");
    makeCurrent(context);
    const std::vector<unsigned char> zeros(data == nullptr ? bytes : 0);
    GLuint name = 0;
    gl::CreateBuffers(1, &name);
    gl::NamedBufferData(name, static_cast<GLsizeiptr>(bytes), data == nullptr ? zeros.data() : data,
                        GL_STATIC_DRAW);
    *out = name;
  });
}

OrrisStatus orris_buffer_destroy(OrrisContext* handle, uint32_t buffer) {
  return guarded([&] {
    makeCurrent(live(handle));
    if (orris::gl::IsBuffer(buffer) == GL_FALSE) fail(ORRIS_ERROR_ARGUMENT, "this is no buffer");
    orris::gl::DeleteBuffers(1, &buffer);
  });
}

OrrisStatus orris_texture_create(OrrisContext* handle, int32_t width, int32_t height,
                                 const void* rgba, int32_t levels, uint32_t* out) {
  namespace gl = orris::gl;
  return guarded([&] {
    OrrisContext& context = live(handle);
    refuseNull(out, "out");
    *out = 0;
    refuseNull(rgba, "rgba");
    const int most = context.gl->driver().maxTextureSize;
    if (width < 1 || height < 1 || width > most || height > most)
      fail(ORRIS_ERROR_ARGUMENT, "width and height must be 1 to " + std::to_string(most));
    if (levels < 1 || levels > mostLevels(width, height))
      fail(ORRIS_ERROR_ARGUMENT,
           "levels must be 1 to " + std::to_string(mostLevels(width, height)));
    const Current current(context);  // sets how pixels are read
    GLuint name = 0;
    gl::CreateTextures(GL_TEXTURE_2D, 1, &name);
    gl::TextureStorage2D(name, levels, GL_RGBA8, width, height);
    gl::TextureSubImage2D(name, 0, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
    gl::TextureParameteri(name, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl::TextureParameteri(name, GL_TEXTURE_MIN_FILTER,
                          levels > 1 ? GL_NEAREST_MIPMAP_LINEAR : GL_NEAREST);
    if (levels > 1) gl::GenerateTextureMipmap(name);
    *out = name;
  });
}

OrrisStatus orris_texture_destroy(OrrisContext* handle, uint32_t texture) {
  return guarded([&] {
    makeCurrent(live(handle));
    if (orris::gl::IsTexture(texture) == GL_FALSE) fail(ORRIS_ERROR_ARGUMENT, "this is no texture");
    orris::gl::DeleteTextures(1, &texture);
  });
}
