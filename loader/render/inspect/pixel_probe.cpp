#include <orris/render/inspect/pixel_probe.h>

#include <algorithm>
#include <cstring>

#include <orris/gl/framebuffer.h>
#include <orris/plan/schedule/program_uses.h>

namespace orris {
namespace {

/// Has the buffer a texel for each part of the screen?
bool showsTheScreen(const std::string& name, const gl::Texture& texture,
                    const Schedule& schedule) {
  if (name == "screen") return true;
  const auto buffer = parseBufferName(name, false);
  using Kind = BufferName::Kind;
  if (buffer)
    return buffer->kind == Kind::Color || buffer->kind == Kind::Depth ||
           buffer->kind == Kind::Stencil;
  return texture.depth == 1 && texture.width == schedule.width &&
         texture.height == schedule.height;
}

/// By bits: a NaN equals itself.
bool sameBits(const std::vector<float>& a, const std::vector<float>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

}  // namespace

bool isDrawnBy(const Step& step, const BufferSide& side) {
  const auto buffer = parseBufferName(side.name, false);
  if (!buffer) return step.kind == Step::Kind::Present && side.name == "screen";
  const bool color = buffer->kind == BufferName::Kind::Color ||
                     buffer->kind == BufferName::Kind::ShadowColor;
  return !color || std::ranges::find(step.writes, buffer->index) != step.writes.end();
}

void PixelProbe::after(const Step& step) {
  const Schedule& schedule = renderer_.schedule();
  for (const BufferSide& side : renderer_.writesOf(step)) {
    const gl::Texture* texture = renderer_.texture(side);
    if (texture == nullptr || !showsTheScreen(side.name, *texture, schedule)) continue;
    const int x = int((x_ + 0.5) * texture->width / schedule.width);
    const int y = int((y_ + 0.5) * texture->height / schedule.height);
    if (x < 0 || y < 0 || x >= texture->width || y >= texture->height) continue;
    ProbeValue found{step.name, side, x, y,
                     gl::readTexel(*texture, x, texture->height - 1 - y)};
    if (!isDrawnBy(step, side)) {
      const auto last = std::find_if(values_.rbegin(), values_.rend(),
                                     [&](const ProbeValue& value) { return value.side == side; });
      if (last != values_.rend() && sameBits(last->value, found.value)) continue;
    }
    values_.push_back(std::move(found));
  }
}

}  // namespace orris
