#include "app/view/pack/set_comparison.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include <orris/gl/functions.h>
#include <orris/image/value_picture.h>
#include <orris/pack/programs/folder_build.h>

namespace orris {
namespace {

constexpr std::size_t kFrames = 32;

void keep(std::deque<double>& history, double value) {
  history.push_back(value);
  if (history.size() > kFrames) history.pop_front();
}

double medianOf(const std::deque<double>& history) {
  if (history.empty()) return 0;
  std::deque<double> sorted = history;
  const auto middle = sorted.begin() + std::ptrdiff_t(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  return *middle;
}

struct Area {
  int left = 0, bottom = 0, right = 0, top = 0;
};

void copyArea(unsigned from, const Area& source, unsigned to, const Area& target) {
  gl::BlitNamedFramebuffer(from, to, source.left, source.bottom, source.right, source.top, target.left,
                           target.bottom, target.right, target.top, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

/// Largest difference of a channel at each pixel, from 0 to 1.
ImageF differenceOf(const Image8& a, const Image8& b) {
  ImageF difference(a.width, a.height, 1);
  for (std::size_t i = 0; i < difference.pixels.size(); ++i) {
    int most = 0;
    for (int c = 0; c < a.channels; ++c) {
      const std::size_t at = i * std::size_t(a.channels) + std::size_t(c);
      most = std::max(most, std::abs(int(a.pixels[at]) - int(b.pixels[at])));
    }
    difference.pixels[i] = float(most) / 255;
  }
  return difference;
}

}  // namespace

std::unique_ptr<SetComparison> SetComparison::create(gl::Context& context, RenderSession& running,
                                                     unsigned seed, Diagnostics& diagnostics) {
  SessionRequest request;
  request.openPack = [files = running.asked().source](Diagnostics&) { return files; };
  request.load = running.loadRequest();
  request.load.live.clear();
  request.renderer = {.width = running.renderer().size().x, .height = running.renderer().size().y};
  request.camera = running.camera();
  request.seed = seed;
  auto other = RenderSession::create(context, std::move(request), running.scene().world, diagnostics);
  if (!other) return nullptr;
  return std::unique_ptr<SetComparison>(new SetComparison(std::move(other)));
}

void SetComparison::drawOther(RenderSession& running, Diagnostics& diagnostics) {
  FrameRenderer& renderer = other_->renderer();
  const glm::ivec2 size = running.renderer().size();
  renderer.resize(size.x, size.y, diagnostics);
  other_->follow(running);
  gl::Finish();
  const Clock::time_point began = Clock::now();
  other_->renderFrame(diagnostics);
  gl::Finish();
  began_ = Clock::now();
  keep(secondsB_, std::chrono::duration<double>(began_ - began).count());
}

void SetComparison::endFrame(FrameRenderer& running) {
  gl::Finish();
  keep(secondsA_, std::chrono::duration<double>(Clock::now() - began_).count());
  if (mode == CompareMode::Difference) paintDifference(running);
}

void SetComparison::paintDifference(const FrameRenderer& running) {
  const Image8 a = running.screenshot(), b = other_->renderer().screenshot();
  if (a.pixels.size() != b.pixels.size()) return;
  const ImageF difference = differenceOf(a, b);
  const float most = *std::ranges::max_element(difference.pixels);
  largest_ = int(most * 255 + 0.5f);
  differing_ = std::size_t(std::ranges::count_if(difference.pixels, [](float value) { return value > 0; }));
  const Image8 painted = paintValues(
      difference, {.channel = 0, .range = std::pair(0.0f, std::max(most, 1.0f / 255)), .falseColor = true});
  if (picture_.width != painted.width || picture_.height != painted.height || picture_.id() == 0) {
    std::string error;
    picture_ = gl::createTexture(2, *findFormat("RGBA8"), painted.width, painted.height, 1, 1, "difference");
    pictureFramebuffer_ = gl::createFramebuffer({&picture_}, nullptr, "difference", error);
  }
  gl::upload(picture_, GL_RGB, GL_UNSIGNED_BYTE, painted.pixels.data());
}

void SetComparison::show(FrameRenderer& running, ViewSurface& surface) {
  int width = 0, height = 0;
  surface.size(width, height);
  const unsigned to = surface.framebuffer(), a = running.screenFramebuffer(),
                 b = other_->renderer().screenFramebuffer();
  const glm::ivec2 size = running.size();
  const Area whole{0, 0, size.x, size.y}, all{0, 0, width, height};
  switch (mode) {
    case CompareMode::Side: {
      const float black[4] = {0, 0, 0, 1};
      gl::ClearNamedFramebufferfv(to, GL_COLOR, 0, black);
      const int middle = width / 2, low = height / 4, high = low + (height + 1) / 2;
      copyArea(a, whole, to, {0, low, middle, high});
      return copyArea(b, whole, to, {middle, low, width, high});
    }
    case CompareMode::Wipe: {
      const int at = std::clamp(int(wipe * float(width) + 0.5f), 0, width);
      const int from = std::clamp(int(wipe * float(size.x) + 0.5f), 0, size.x);
      if (at > 0) copyArea(a, {0, 0, from, size.y}, to, {0, 0, at, height});
      if (at < width) copyArea(b, {from, 0, size.x, size.y}, to, {at, 0, width, height});
      return;
    }
    case CompareMode::Flicker:
      return copyArea(showsB ? b : a, whole, to, all);
    case CompareMode::Difference:
      // The first row of the picture is its highest.
      if (picture_.id() != 0) copyArea(pictureFramebuffer_.id(), whole, to, {0, height, width, 0});
      return;
  }
}

std::pair<double, double> SetComparison::costs() const { return {medianOf(secondsA_), medianOf(secondsB_)}; }

std::map<std::string, std::pair<std::string, std::string>> SetComparison::differingValues(
    const ShaderPack& a) const {
  std::map<std::string, std::pair<std::string, std::string>> values;
  const OptionSet& options = a.options;
  for (const std::string& name : differingOptions(options, a.values, valuesOfB()))
    values[name] = {options.value(a.values, name), options.value(valuesOfB(), name)};
  return values;
}

nlohmann::json SetComparison::state(const ShaderPack& a) const {
  nlohmann::json values = nlohmann::json::object();
  for (const auto& [name, pair] : differingValues(a)) values[name] = {pair.first, pair.second};
  const auto [first, second] = costs();
  nlohmann::json json = {{"mode", kCompareModes[std::size_t(mode)]},
                         {"wipe", wipe},
                         {"shows", mode != CompareMode::Flicker ? "both" : showsB ? "B" : "A"},
                         {"secondsA", first},
                         {"secondsB", second},
                         {"values", values}};
  if (mode == CompareMode::Difference) {
    json["differing"] = differing_;
    json["largest"] = largest_;
  }
  return json;
}

}  // namespace orris
