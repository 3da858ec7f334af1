#include "app/drawing/frame_probe.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include <orris/pack/files/text.h>
#include <orris/render/inspect/buffer_view.h>

namespace orris {
namespace {

/// As many digits as give the same float back.
std::string exact(float value) { return fmt::format("{:.9g}", value); }

/// JSON has no NaN.
nlohmann::json exactJson(float value) {
  return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(exact(value));
}

}  // namespace

std::optional<std::pair<std::string, std::string>> splitDumpName(const std::string& name) {
  const std::size_t at = name.find('@');
  if (at == std::string::npos) return std::nullopt;
  return std::pair{name.substr(0, at), name.substr(at + 1)};
}

std::optional<std::pair<int, int>> parsePixel(const std::string& text) {
  constexpr long long kLargest = 1 << 15;
  const auto parts = splitAt(text, ',');
  if (parts.size() != 2) return std::nullopt;
  const auto x = parseInteger(parts[0]), y = parseInteger(parts[1]);
  if (!x || !y || *x < 0 || *y < 0 || *x > kLargest || *y > kLargest) return std::nullopt;
  return std::pair{int(*x), int(*y)};
}

FrameProbe::FrameProbe(const RenderOutputs& outputs, FrameRenderer& renderer)
    : outputs_(outputs), renderer_(renderer) {
  if (const auto pixel = parsePixel(outputs.probe))
    pixel_.emplace(renderer, pixel->first, pixel->second);
  if (outputs.checkFinite) finite_.emplace(renderer);
  for (const auto& [text, path] : outputs.shows) {
    std::string problem;
    shows_[text] = {*parseShown(text, problem), {}};
  }
  const bool dumps = std::ranges::any_of(
      outputs.dumps, [](const auto& dump) { return splitDumpName(dump.first).has_value(); });
  const bool shows = std::ranges::any_of(
      shows_, [](const auto& one) { return !one.second.asked.what.step.empty(); });
  if (pixel_ || finite_ || dumps || shows) renderer.watchSteps([this](const Step& step) { after(step); });
}

FrameProbe::~FrameProbe() { renderer_.watchSteps({}); }

void FrameProbe::begin(int frame, bool last) {
  frame_ = frame;
  last_ = last;
}

void FrameProbe::after(const Step& step) {
  if (finite_) finite_->after(step, frame_);
  if (!last_) return;
  if (pixel_) pixel_->after(step);
  for (const auto& [name, path] : outputs_.dumps) {
    const auto parts = splitDumpName(name);
    if (!parts || parts->second != step.name) continue;
    if (auto image = renderer_.dump(sideAfter(renderer_, step, parts->first)))
      dumps_[name] = std::move(*image);
  }
  for (auto& [text, show] : shows_)
    if (isAsked(renderer_, step, show.asked.what))
      show.view = viewBuffer(renderer_, &step, show.asked.what);
}

const std::map<std::string, FrameProbe::Show>& FrameProbe::shows() {
  for (auto& [text, show] : shows_)
    if (show.asked.what.step.empty()) show.view = viewBuffer(renderer_, nullptr, show.asked.what);
  return shows_;
}

std::string FrameProbe::text() const {
  if (!pixel_) return "";
  std::size_t widest = 0;
  for (const ProbeValue& value : pixel_->values()) widest = std::max(widest, value.step.size());
  std::string text = fmt::format("pixel {}, in the last frame:\n", outputs_.probe);
  for (const ProbeValue& value : pixel_->values()) {
    std::vector<std::string> numbers;
    for (const float number : value.value) numbers.push_back(exact(number));
    text += fmt::format("  {:{}}  {:16} {}\n", value.step, widest,
                        value.side.name + (value.side.alt ? " alt" : ""),
                        fmt::join(numbers, " "));
  }
  return text;
}

nlohmann::json FrameProbe::json() const {
  nlohmann::json chain = nlohmann::json::array();
  if (!pixel_) return chain;
  for (const ProbeValue& value : pixel_->values()) {
    nlohmann::json numbers = nlohmann::json::array();
    for (const float number : value.value) numbers.push_back(exactJson(number));
    chain.push_back({{"step", value.step},
                     {"buffer", value.side.name},
                     {"side", value.side.alt ? "alt" : "main"},
                     {"x", value.x},
                     {"y", value.y},
                     {"value", numbers}});
  }
  return chain;
}

}  // namespace orris
