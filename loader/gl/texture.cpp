#include <orris/gl/texture.h>

#include <algorithm>
#include <cassert>

#include <orris/gl/functions.h>

namespace orris::gl {
namespace {

constexpr GLenum kTargets[] = {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D};

Texture createStorage(GLenum target, unsigned internalFormat, int width, int height, int depth,
                      int levels, const std::string& label) {
  Texture texture;
  GLuint id = 0;
  CreateTextures(target, 1, &id);
  texture.handle = Handle<deleteTexture>(id);
  texture.target = target;
  texture.internalFormat = internalFormat;
  texture.width = width;
  texture.height = target == GL_TEXTURE_1D ? 1 : height;
  texture.depth = target == GL_TEXTURE_3D ? depth : 1;
  switch (target) {
    case GL_TEXTURE_1D:
      TextureStorage1D(id, levels, internalFormat, width);
      break;
    case GL_TEXTURE_2D:
      TextureStorage2D(id, levels, internalFormat, width, height);
      break;
    default:
      TextureStorage3D(id, levels, internalFormat, width, height, depth);
      break;
  }
  if (!label.empty()) ObjectLabel(GL_TEXTURE, id, GLsizei(label.size()), label.data());
  return texture;
}

/// Drivers may hand out memory as others left it.
void clearLevels(const Texture& texture, int levels, GLenum format, GLenum type) {
  for (int level = 0; level < levels; ++level)
    ClearTexImage(texture.id(), level, format, type, nullptr);
}

GLint minFilter(bool linear, bool mipmaps) {
  if (!mipmaps) return linear ? GL_LINEAR : GL_NEAREST;
  return linear ? GL_LINEAR_MIPMAP_LINEAR : GL_NEAREST_MIPMAP_NEAREST;
}

}  // namespace

Texture createTexture(int dimensions, const TextureFormat& format, int width, int height, int depth,
                      int levels, const std::string& label) {
  assert(dimensions >= 1 && dimensions <= 3);
  Texture texture = createStorage(kTargets[dimensions - 1], format.internalFormat, width, height,
                                  depth, levels, label);
  texture.integer = format.isInteger();
  clearLevels(texture, levels, texture.integer ? GL_RGBA_INTEGER : GL_RGBA, GL_UNSIGNED_BYTE);
  setParameters(texture, {});
  return texture;
}

Texture createDepthTexture(int width, int height, int levels, const std::string& label) {
  Texture texture =
      createStorage(GL_TEXTURE_2D, GL_DEPTH_COMPONENT24, width, height, 1, levels, label);
  clearLevels(texture, levels, GL_DEPTH_COMPONENT, GL_FLOAT);
  setParameters(texture, {.linear = false});
  return texture;
}

Texture createDepthStencilTexture(int width, int height, const std::string& label) {
  Texture texture = createStorage(GL_TEXTURE_2D, GL_DEPTH24_STENCIL8, width, height, 1, 1, label);
  clearLevels(texture, 1, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8);
  setParameters(texture, {.linear = false});
  return texture;
}

Texture createStencilView(const Texture& depthStencil, const std::string& label) {
  Texture view;
  GLuint id = 0;
  // A name that was never bound, as glTextureView asks for.
  GenTextures(1, &id);
  TextureView(id, GL_TEXTURE_2D, depthStencil.id(), depthStencil.internalFormat, 0, 1, 0, 1);
  view.handle = Handle<deleteTexture>(id);
  view.target = GL_TEXTURE_2D;
  view.internalFormat = depthStencil.internalFormat;
  view.width = depthStencil.width;
  view.height = depthStencil.height;
  view.integer = true;
  if (!label.empty()) ObjectLabel(GL_TEXTURE, id, GLsizei(label.size()), label.data());
  TextureParameteri(id, GL_DEPTH_STENCIL_TEXTURE_MODE, GL_STENCIL_INDEX);
  setParameters(view, {});
  return view;
}

void setParameters(const Texture& texture, const TextureParameters& parameters) {
  const GLuint id = texture.id();
  // Integer texels cannot be filtered: a linear filter would make the texture incomplete.
  const bool linear = parameters.linear && !texture.integer;
  const GLint wrap = parameters.repeat ? GL_REPEAT : GL_CLAMP_TO_EDGE;
  TextureParameteri(id, GL_TEXTURE_MIN_FILTER, minFilter(linear, parameters.mipmaps));
  TextureParameteri(id, GL_TEXTURE_MAG_FILTER, linear ? GL_LINEAR : GL_NEAREST);
  TextureParameteri(id, GL_TEXTURE_WRAP_S, wrap);
  TextureParameteri(id, GL_TEXTURE_WRAP_T, wrap);
  TextureParameteri(id, GL_TEXTURE_WRAP_R, wrap);
  TextureParameteri(id, GL_TEXTURE_COMPARE_MODE,
                    parameters.compare ? GL_COMPARE_REF_TO_TEXTURE : GL_NONE);
  TextureParameteri(id, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
}

void upload(const Texture& texture, unsigned pixelFormat, unsigned pixelType, const void* pixels) {
  PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  const GLuint id = texture.id();
  switch (texture.target) {
    case GL_TEXTURE_1D:
      TextureSubImage1D(id, 0, 0, texture.width, pixelFormat, pixelType, pixels);
      break;
    case GL_TEXTURE_2D:
      TextureSubImage2D(id, 0, 0, 0, texture.width, texture.height, pixelFormat, pixelType, pixels);
      break;
    default:
      TextureSubImage3D(id, 0, 0, 0, 0, texture.width, texture.height, texture.depth, pixelFormat,
                        pixelType, pixels);
      break;
  }
}

void generateMipmaps(const Texture& texture) { GenerateTextureMipmap(texture.id()); }

int levelsOf(const Texture& texture) {
  GLint levels = 1;
  GetTextureParameteriv(texture.id(), GL_TEXTURE_IMMUTABLE_LEVELS, &levels);
  return std::max(levels, 1);
}

}  // namespace orris::gl
