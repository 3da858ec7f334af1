// Framebuffers over textures, and reading pixels back.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <orris/gl/handle.h>
#include <orris/gl/texture.h>

namespace orris::gl {

struct Framebuffer {
  Handle<deleteFramebuffer> handle;
  int width = 0, height = 0;
  int colors = 0;
  unsigned id() const { return handle.id(); }
};

/// Colour attachments in order, draw buffers 0..n-1 enabled; `depth` may be null. Incomplete: id 0
/// and `error` set.
Framebuffer createFramebuffer(const std::vector<const Texture*>& colors, const Texture* depth,
                              const std::string& label, std::string& error);

/// Reads level 0, all channels as float (integers converted exactly up to 2^24), bottom row first
/// as GL has it; 3-D textures slice after slice; depth as one channel.
std::vector<float> readPixels(const Texture& texture, int& channels);

/// One level, of a 3-D texture one slice of it, as readPixels() gives level 0. Both must exist.
std::vector<float> readLevel(const Texture& texture, int level, int slice, int& channels);

/// One texel of level 0, counted from the bottom left, just as readPixels() gives it.
std::vector<float> readTexel(const Texture& texture, int x, int y, int z = 0);

/// The same of a texture of whole numbers, all bits of them; of any other empty.
std::vector<std::uint32_t> readWords(const Texture& texture, int& channels);

}  // namespace orris::gl
