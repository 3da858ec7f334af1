#include <orris/render/inspect/buffer_view.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include <orris/gl/framebuffer.h>
#include <orris/pack/files/text.h>

namespace orris {
namespace {

constexpr std::string_view kStorage = "bufferObject.";

BufferView viewStorage(const FrameRenderer& renderer, int number, const BufferRequest& request) {
  BufferView view{.side = {request.buffer, false}, .bytes = renderer.storageBytes(number)};
  view.offset = std::min(request.offset, view.bytes) / sizeof(std::uint32_t) * sizeof(std::uint32_t);
  view.words = renderer.storageWords(number, view.offset, kViewWords);
  return view;
}

ImageF topRowFirst(const std::vector<float>& pixels, int width, int height, int channels) {
  ImageF image(width, height, channels);
  const std::size_t row = std::size_t(width) * std::size_t(channels);
  for (int y = 0; y < height; ++y)
    std::copy_n(pixels.begin() + std::ptrdiff_t(std::size_t(height - 1 - y) * row), row,
                image.at(0, y));
  return image;
}

BufferSide sideOf(const FrameRenderer& renderer, const Step* step, const BufferRequest& request) {
  if (request.side != BufferRequest::Side::Written)
    return {request.buffer, request.side == BufferRequest::Side::Alt};
  return step == nullptr ? renderer.finalSide(request.buffer)
                         : sideAfter(renderer, *step, request.buffer);
}

}  // namespace

BufferSide sideAfter(const FrameRenderer& renderer, const Step& step, const std::string& buffer) {
  for (const BufferSide& side : renderer.writesOf(step))
    if (side.name == buffer) return side;
  const auto name = parseBufferName(buffer, false);
  using Kind = BufferName::Kind;
  if (!name || (name->kind != Kind::Color && name->kind != Kind::ShadowColor))
    return {buffer, false};
  const std::uint32_t flipped = name->kind == Kind::Color ? step.flipped : step.shadowFlipped;
  return {buffer, (flipped >> name->index & 1u) != 0};
}

std::optional<int> storageNumber(const std::string& buffer) {
  if (!buffer.starts_with(kStorage)) return std::nullopt;
  const auto number = parseInteger(buffer.substr(kStorage.size()));
  if (!number || *number < 0 || *number > 1000) return std::nullopt;
  return int(*number);
}

std::optional<BufferView> viewBuffer(const FrameRenderer& renderer, const Step* step,
                                     const BufferRequest& request) {
  if (const auto number = storageNumber(request.buffer)) {
    if (renderer.storageBytes(*number) == 0) return std::nullopt;
    return viewStorage(renderer, *number, request);
  }
  const BufferSide side = sideOf(renderer, step, request);
  const gl::Texture* texture = renderer.texture(side);
  if (texture == nullptr) return std::nullopt;
  BufferView view{.side = side, .levels = gl::levelsOf(*texture)};
  view.level = std::clamp(request.level, 0, view.levels - 1);
  view.slices = std::max(texture->depth >> view.level, 1);
  view.slice = std::clamp(request.slice, 0, view.slices - 1);
  int channels = 0;
  const std::vector<float> pixels = gl::readLevel(*texture, view.level, view.slice, channels);
  view.pixels = topRowFirst(pixels, std::max(texture->width >> view.level, 1),
                            std::max(texture->height >> view.level, 1), channels);
  return view;
}

bool isAsked(const FrameRenderer& renderer, const Step& step, const BufferRequest& request) {
  if (step.name != request.step) return false;
  const std::vector<Step>& frame = renderer.schedule().frame;
  const auto last = std::find_if(frame.rbegin(), frame.rend(),
                                 [&](const Step& one) { return one.name == request.step; });
  return last != frame.rend() && &*last == &step;
}

std::vector<std::string> viewableBuffers(const FrameRenderer& renderer) {
  std::vector<std::string> names = splitBlanks(renderer.bufferNames());
  names.emplace_back("screen");
  for (const int number : renderer.storageNumbers())
    names.push_back(fmt::format("{}{}", kStorage, number));
  return names;
}

std::string problemOf(const FrameRenderer& renderer, const BufferRequest& request) {
  const std::vector<std::string> buffers = viewableBuffers(renderer);
  if (std::ranges::find(buffers, request.buffer) == buffers.end())
    return fmt::format("there is no buffer {} in this frame: it has {}", request.buffer,
                       fmt::join(buffers, ", "));
  const std::vector<Step>& frame = renderer.schedule().frame;
  if (request.step.empty() || std::ranges::find(frame, request.step, &Step::name) != frame.end())
    return "";
  std::vector<std::string> names;
  for (const Step& step : frame)
    if (std::ranges::find(names, step.name) == names.end()) names.push_back(step.name);
  return fmt::format("there is no pass {} in this frame: it has {}", request.step,
                     fmt::join(names, ", "));
}

}  // namespace orris
