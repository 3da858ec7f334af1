#include <orris/render/inspect/finite_check.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <orris/render/session/loaded_pack.h>

namespace orris {
namespace {

std::string entryFile(const ShaderPack& pack, const Step& step) {
  if (step.program < 0) return "";
  const ProgramSource& source = pack.programs[std::size_t(step.program)];
  if (!source.stages.empty()) return std::string(entryFileOf(source.stages.back()));
  return source.computes.empty() ? "" : std::string(entryFileOf(source.computes.front().text));
}

std::string nameOf(const BufferSide& side) { return side.name + (side.alt ? " (alt)" : ""); }

}  // namespace

void FiniteCheck::after(const Step& step, int frame) {
  if (!findings_.empty() && findings_.front().frame != frame) return;
  for (const BufferSide& side : renderer_.writesOf(step)) {
    const gl::Texture* texture = renderer_.texture(side);
    const TextureFormat* format =
        texture == nullptr ? nullptr : findFormat(texture->internalFormat);
    // No other format can hold anything else.
    if (format == nullptr || format->formatClass != FormatClass::Float) continue;
    const auto image = renderer_.dump(side);
    Finding found{.frame = frame, .step = step.name, .file = entryFile(renderer_.pack(), step), .side = side};
    for (int y = 0; y < image->height; ++y)
      for (int x = 0; x < image->width; ++x) {
        const float* pixel = image->at(x, y);
        const float* bad = std::find_if(pixel, pixel + image->channels,
                                        [](float value) { return !std::isfinite(value); });
        if (bad == pixel + image->channels || found.pixels++ > 0) continue;
        found.x = x;
        found.y = y;
        found.value = *bad;
      }
    if (found.pixels > 0) findings_.push_back(std::move(found));
  }
}

Diagnostics FiniteCheck::findings() const {
  if (findings_.empty()) return {};
  const Finding& first = findings_.front();
  Diagnostic diagnostic;
  diagnostic.id = "not-finite";
  diagnostic.at.file = first.file;
  diagnostic.message = fmt::format(
      "{} writes {} to {} at pixel {},{} of frame {}; {} pixel{} not finite", first.step,
      std::isnan(first.value) ? "NaN" : first.value > 0 ? "Inf" : "-Inf", nameOf(first.side),
      first.x, first.y, first.frame, first.pixels, first.pixels == 1 ? " is" : "s are");
  for (std::size_t i = 1; i < findings_.size(); ++i)
    diagnostic.notes.push_back(fmt::format("after it {} writes {} such pixel{} to {}",
                                           findings_[i].step, findings_[i].pixels,
                                           findings_[i].pixels == 1 ? "" : "s",
                                           nameOf(findings_[i].side)));
  diagnostic.hint = fmt::format("orris render --probe {},{} shows the pixel after every pass",
                                first.x, first.y);
  return {diagnostic};
}

}  // namespace orris
