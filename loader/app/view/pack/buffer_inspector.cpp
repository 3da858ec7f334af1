#include "app/view/pack/buffer_inspector.h"

#include <nlohmann/json.hpp>
#include <utility>

#include <orris/gl/functions.h>

namespace orris {
namespace {

int buffersCopied = 0;

}  // namespace

int BufferInspector::copies() { return buffersCopied; }

void BufferInspector::after(const FrameRenderer& renderer, const Step& step) {
  if (isAsked(renderer, step, asked_.what)) take(viewBuffer(renderer, &step, asked_.what));
}

void BufferInspector::take(std::optional<BufferView> view) {
  if (view) ++buffersCopied;
  taken_ = std::move(view);
}

void BufferInspector::endFrame(const FrameRenderer& renderer) {
  if (asked_.what.step.empty()) take(viewBuffer(renderer, nullptr, asked_.what));
  view_ = std::exchange(taken_, std::nullopt);
  problem_ = view_ ? "" : problemOf(renderer, asked_.what);
  // The pass was left out, for this driver or by this frame.
  if (!view_ && problem_.empty()) problem_ = "nothing of this side after this pass";
  if (view_ && !view_->pixels.pixels.empty()) {
    paint();
  } else {
    texture_ = {};
  }
}

void BufferInspector::paint() {
  const ImageF& pixels = view_->pixels;
  facts_ = valueFacts(pixels);
  range_ = paintedRange(pixels, asked_.how);
  ValuePaint paint = asked_.how;
  paint.range = range_;
  const Image8 image = paintValues(pixels, paint);
  if (texture_.width != image.width || texture_.height != image.height || texture_.id() == 0) {
    texture_ = gl::createTexture(2, *findFormat("RGBA8"), image.width, image.height, 1, 1,
                                 "shown buffer");
    gl::setParameters(texture_, {.linear = false});
  }
  gl::upload(texture_, GL_RGB, GL_UNSIGNED_BYTE, image.pixels.data());
}

nlohmann::json BufferInspector::state() const {
  nlohmann::json json = view_ ? toJson(*view_, asked_.how) : nlohmann::json::object();
  json["asked"] = shownText(asked_);
  json["problem"] = problem_;
  return json;
}

}  // namespace orris
