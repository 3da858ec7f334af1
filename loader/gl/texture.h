// A texture that knows its target, format and size.
#pragma once

#include <string>

#include <orris/gl/handle.h>
#include <orris/image/texel_format.h>

namespace orris::gl {

struct Texture {
  Handle<deleteTexture> handle;
  unsigned target = 0;  ///< GL_TEXTURE_2D, ...
  unsigned internalFormat = 0;
  int width = 0, height = 1, depth = 1;
  bool integer = false;
  unsigned id() const { return handle.id(); }
};

struct TextureParameters {
  bool linear = true;
  bool repeat = false;
  bool mipmaps = false;  ///< trilinear minification (nearest-mipmap when not linear)
  bool compare = false;  ///< GL_LEQUAL comparison
};

/// Storage of one level (or all levels with `levels`), contents zero. Target from the number
/// of dimensions: 1, 2, 3. `label` is the object label ("colortex4 alt").
Texture createTexture(int dimensions, const TextureFormat& format, int width, int height, int depth,
                      int levels, const std::string& label);
Texture createDepthTexture(int width, int height, int levels, const std::string& label);
/// Depth of 24 bits with a stencil of 8.
Texture createDepthStencilTexture(int width, int height, const std::string& label);
/// The stencil of a texture of createDepthStencilTexture as integers, which must outlive it.
Texture createStencilView(const Texture& depthStencil, const std::string& label);
void setParameters(const Texture& texture, const TextureParameters& parameters);
/// Whole level 0; `pixels` tightly packed, rows without padding.
void upload(const Texture& texture, unsigned pixelFormat, unsigned pixelType, const void* pixels);
void generateMipmaps(const Texture& texture);
/// So many levels have storage.
int levelsOf(const Texture& texture);

}  // namespace orris::gl
