// Pixels of a FrameRenderer on their way back: the screen and any buffer.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <orris/render/frame_renderer.h>
#include <orris/render/session/loaded_pack.h>

namespace orris {

namespace {

ImageF flipped(const std::vector<float>& pixels, int width, int height, int channels) {
  ImageF image(width, height, channels);
  const size_t row = static_cast<size_t>(width) * channels;
  for (int y = 0; y < height; ++y)
    std::copy_n(pixels.begin() + static_cast<std::ptrdiff_t>((height - 1 - y) * row), row,
                image.at(0, y));
  return image;
}

ImageF read(const gl::Texture& texture) {
  int channels = 0;
  const std::vector<float> pixels = gl::readPixels(texture, channels);
  return flipped(pixels, texture.width, texture.height * texture.depth, channels);
}

/// Its colours, each value by itself.
template <class Picture, class Convert>
Picture colorsOf(const ImageF& image, const Convert& convert) {
  Picture result(image.width, image.height, 3);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (int c = 0; c < 3; ++c) result.at(x, y)[c] = convert(image.at(x, y)[c]);
  return result;
}

float fromSrgb(float v) {
  return v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f);
}

std::uint8_t toByte(float v) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(v, 0.0f, 1.0f) * 255));
}

}  // namespace

Image8 FrameRenderer::screenshot() const {
  return colorsOf<Image8>(read(loaded_->targets->screen()), toByte);
}

ImageF FrameRenderer::screenshotLinear() const {
  return colorsOf<ImageF>(read(loaded_->targets->screen()), fromSrgb);
}

const gl::Texture* FrameRenderer::texture(const BufferSide& side) const {
  const gl::Texture* texture = nullptr;
  if (side.name == "screen") return &loaded_->targets->screen();
  if (const auto buffer = parseBufferName(side.name, false)) {
    const int i = buffer->index;
    if (buffer->kind == BufferName::Kind::Depth) texture = &loaded_->targets->depth(i);
    if (buffer->kind == BufferName::Kind::Stencil)
      texture = i == 0 ? &loaded_->targets->stencil() : &loaded_->targets->lampShadows();
    if (buffer->kind == BufferName::Kind::ShadowDepth) texture = &loaded_->targets->shadowDepth(i);
    const bool shadow = buffer->kind == BufferName::Kind::ShadowColor;
    if (shadow || buffer->kind == BufferName::Kind::Color)
      if (RenderTarget* target = loaded_->targets->find(shadow, i); target != nullptr)
        texture = &target->side(side.alt);
  } else if (const ImageResource* image = loaded_->resources->image(side.name); image != nullptr) {
    texture = &image->texture;
  }
  return texture == nullptr || texture->id() == 0 ? nullptr : texture;
}

BufferSide FrameRenderer::finalSide(const std::string& name) const {
  const auto buffer = parseBufferName(name, false);
  if (!buffer) return {name, false};
  const bool shadow = buffer->kind == BufferName::Kind::ShadowColor;
  if (!shadow && buffer->kind != BufferName::Kind::Color) return {name, false};
  const std::uint32_t flipped = shadow ? schedule_.finalShadowFlipped : schedule_.finalFlipped;
  return {name, (flipped >> buffer->index & 1u) != 0};
}

std::optional<ImageF> FrameRenderer::dump(const BufferSide& side) const {
  const gl::Texture* buffer = texture(side);
  if (buffer == nullptr) return std::nullopt;
  return read(*buffer);
}

std::optional<ImageF> FrameRenderer::dump(const std::string& name) const {
  return dump(finalSide(name));
}

std::vector<std::uint32_t> FrameRenderer::dumpWords(const std::string& image) const {
  const ImageResource* resource = loaded_->resources->image(image);
  int channels = 0;
  return resource == nullptr ? std::vector<std::uint32_t>()
                             : gl::readWords(resource->texture, channels);
}

std::vector<int> FrameRenderer::storageNumbers() const {
  std::vector<int> numbers;
  for (const auto& [index, buffer] : loaded_->resources->buffers()) numbers.push_back(index);
  return numbers;
}

std::size_t FrameRenderer::storageBytes(int index) const {
  const auto& all = loaded_->resources->buffers();
  const auto found = all.find(index);
  return found == all.end() ? 0 : found->second.size;
}

std::vector<std::uint32_t> FrameRenderer::storageWords(int index, std::size_t offset,
                                                       std::size_t words) const {
  const std::size_t bytes = storageBytes(index);
  if (offset >= bytes) return {};
  std::vector<std::uint32_t> read(std::min(words, (bytes - offset) / sizeof(std::uint32_t)));
  if (!read.empty())
    gl::read(loaded_->resources->buffers().at(index), offset, read.size() * sizeof(std::uint32_t),
             read.data());
  return read;
}

std::string FrameRenderer::bufferNames() const {
  std::string names;
  for (const TargetPlan& plan : schedule_.colortex) names += fmt::format("colortex{} ", plan.index);
  for (const TargetPlan& plan : schedule_.shadowcolor)
    names += fmt::format("shadowcolor{} ", plan.index);
  for (int i = 0; i < 3; ++i)
    if (loaded_->targets->depth(i).id() != 0) names += fmt::format("depthtex{} ", i);
  if (loaded_->targets->stencil().id() != 0) names += "stenciltex0 ";
  if (loaded_->targets->lampShadows().id() != 0) names += "stenciltex1 ";
  for (int i = 0; i < 2; ++i)
    if (loaded_->targets->shadowDepth(i).id() != 0) names += fmt::format("shadowtex{} ", i);
  for (const ImageResource& image : loaded_->resources->images()) names += image.plan.name + " ";
  if (!names.empty()) names.pop_back();
  return names;
}

}  // namespace orris
