#include <orris/gl/framebuffer.h>

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

#include <orris/gl/functions.h>

namespace orris::gl {
namespace {

// Why a driver refuses, in words; drivers differ in the status they give for a format.
std::string reasonOf(GLenum status, const std::vector<const Texture*>& colors) {
  for (const Texture* texture : colors) {
    const TextureFormat* format = findFormat(texture->internalFormat);
    if (format != nullptr && !format->renderable) {
      return fmt::format("{} cannot be drawn to", format->name);
    }
  }
  switch (status) {
    case GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT:
      return "an attachment cannot be drawn to";
    case GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT:
      return "it has no attachment";
    case GL_FRAMEBUFFER_UNSUPPORTED:
      return "the driver does not support these formats together";
    case GL_FRAMEBUFFER_INCOMPLETE_LAYER_TARGETS:
      return "2D and 3D attachments are mixed";
    default:
      return fmt::format("status {:#06x}", status);
  }
}

std::string describe(const std::vector<const Texture*>& colors, const Texture* depth) {
  std::string text;
  for (const Texture* texture : colors) {
    const TextureFormat* format = findFormat(texture->internalFormat);
    text += fmt::format("{}{} {}x{}", text.empty() ? "" : ", ",
                        format != nullptr ? format->name : "unknown format", texture->width,
                        texture->height);
  }
  if (depth != nullptr) {
    text += fmt::format("{}depth {}x{}", text.empty() ? "" : ", ", depth->width, depth->height);
  }
  return text;
}

void attach(Framebuffer& framebuffer, GLenum point, const Texture& texture) {
  const bool first = framebuffer.width == 0;
  framebuffer.width = first ? texture.width : std::min(framebuffer.width, texture.width);
  framebuffer.height = first ? texture.height : std::min(framebuffer.height, texture.height);
  NamedFramebufferTexture(framebuffer.id(), point, texture.id(), 0);
}

// How the texels of a format come back without loss.
struct Transfer {
  GLenum format, type;
  int channels;
  FormatClass formatClass;
};

Transfer transferOf(const Texture& texture) {
  const TextureFormat* format = findFormat(texture.internalFormat);
  if (format == nullptr && texture.integer) return {GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, 1, FormatClass::Uint};
  if (format == nullptr) return {GL_DEPTH_COMPONENT, GL_FLOAT, 1, FormatClass::Float};
  return {format->pixelFormat, format->pixelType, format->channels, format->formatClass};
}

/// A part of a level.
struct TexelBox {
  int level = 0, x = 0, y = 0, z = 0, width = 1, height = 1, depth = 1;
};

template <typename Texel>
std::vector<float> readAs(const Texture& texture, GLenum format, GLenum type, size_t count,
                          const std::optional<TexelBox>& box) {
  std::vector<Texel> texels(count);
  const auto bytes = GLsizei(count * sizeof(Texel));
  if (box) {
    GetTextureSubImage(texture.id(), box->level, box->x, box->y, box->z, box->width, box->height,
                       box->depth, format, type, bytes, texels.data());
  } else {
    GetTextureImage(texture.id(), 0, format, type, bytes, texels.data());
  }
  if constexpr (std::is_same_v<Texel, float>) {
    return texels;
  } else {
    return {texels.begin(), texels.end()};
  }
}

/// As OpenGL has it since 4.2. NVIDIA's driver converts to floats as before: 0 reads as .0039.
template <typename Texel>
std::vector<float> readSigned(const Texture& texture, const Transfer& transfer, size_t count,
                              const std::optional<TexelBox>& box) {
  std::vector<float> values = readAs<Texel>(texture, transfer.format, transfer.type, count, box);
  for (float& value : values)
    value = std::max(value / float(std::numeric_limits<Texel>::max()), -1.0f);
  return values;
}

std::vector<float> readPart(const Texture& texture, size_t texels,
                            const std::optional<TexelBox>& box) {
  const Transfer transfer = transferOf(texture);
  const size_t count = texels * size_t(transfer.channels);
  PixelStorei(GL_PACK_ALIGNMENT, 1);
  // Mesa packs a stencil as bytes whatever type is asked for.
  if (transfer.format == GL_STENCIL_INDEX)
    return readAs<GLubyte>(texture, transfer.format, GL_UNSIGNED_BYTE, count, box);
  switch (transfer.formatClass) {
    case FormatClass::Int:
      return readAs<GLint>(texture, transfer.format, GL_INT, count, box);
    case FormatClass::Uint:
      return readAs<GLuint>(texture, transfer.format, GL_UNSIGNED_INT, count, box);
    case FormatClass::Snorm:
      return transfer.type == GL_BYTE ? readSigned<GLbyte>(texture, transfer, count, box)
                                      : readSigned<GLshort>(texture, transfer, count, box);
    default:
      return readAs<float>(texture, transfer.format, GL_FLOAT, count, box);
  }
}

}  // namespace

Framebuffer createFramebuffer(const std::vector<const Texture*>& colors, const Texture* depth,
                              const std::string& label, std::string& error) {
  Framebuffer framebuffer;
  GLuint id = 0;
  CreateFramebuffers(1, &id);
  framebuffer.handle = Handle<deleteFramebuffer>(id);
  framebuffer.colors = int(colors.size());
  if (!label.empty()) ObjectLabel(GL_FRAMEBUFFER, id, GLsizei(label.size()), label.data());
  std::vector<GLenum> drawBuffers;
  for (const Texture* texture : colors) {
    const GLenum point = GL_COLOR_ATTACHMENT0 + GLenum(drawBuffers.size());
    drawBuffers.push_back(point);
    attach(framebuffer, point, *texture);
  }
  if (depth != nullptr) {
    const bool stencil = depth->internalFormat == GL_DEPTH24_STENCIL8;
    attach(framebuffer, stencil ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT, *depth);
  }
  if (drawBuffers.empty()) drawBuffers.push_back(GL_NONE);
  NamedFramebufferDrawBuffers(id, GLsizei(drawBuffers.size()), drawBuffers.data());
  NamedFramebufferReadBuffer(id, drawBuffers.front());
  const GLenum status = CheckNamedFramebufferStatus(id, GL_FRAMEBUFFER);
  if (status == GL_FRAMEBUFFER_COMPLETE) return framebuffer;
  error = fmt::format("framebuffer \"{}\" ({}) is incomplete: {}", label, describe(colors, depth),
                      reasonOf(status, colors));
  return {};
}

std::vector<float> readPixels(const Texture& texture, int& channels) {
  channels = transferOf(texture).channels;
  return readPart(texture, size_t(texture.width) * size_t(texture.height) * size_t(texture.depth),
                  std::nullopt);
}

std::vector<float> readLevel(const Texture& texture, int level, int slice, int& channels) {
  channels = transferOf(texture).channels;
  const TexelBox box{.level = level,
                     .z = slice,
                     .width = std::max(texture.width >> level, 1),
                     .height = std::max(texture.height >> level, 1)};
  return readPart(texture, size_t(box.width) * size_t(box.height), box);
}

std::vector<float> readTexel(const Texture& texture, int x, int y, int z) {
  return readPart(texture, 1, TexelBox{.x = x, .y = y, .z = z});
}

std::vector<std::uint32_t> readWords(const Texture& texture, int& channels) {
  const Transfer transfer = transferOf(texture);
  const bool isSigned = transfer.formatClass == FormatClass::Int;
  if (!isSigned && transfer.formatClass != FormatClass::Uint) return {};
  channels = transfer.channels;
  std::vector<std::uint32_t> words(size_t(texture.width) * size_t(texture.height) *
                                   size_t(texture.depth) * size_t(channels));
  GetTextureImage(texture.id(), 0, transfer.format, isSigned ? GL_INT : GL_UNSIGNED_INT,
                  GLsizei(words.size() * sizeof(std::uint32_t)), words.data());
  return words;
}

}  // namespace orris::gl
