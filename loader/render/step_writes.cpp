// What each step of a frame leaves its results in.
#include <fmt/format.h>

#include <algorithm>

#include "render/frame_renderer.h"
#include "render/loaded_pack.h"

namespace orris {
namespace {

bool inShadowMap(const Step& step) {
  return step.group == ProgramGroup::Shadow || step.group == ProgramGroup::ShadowComp;
}

void addOnce(std::vector<BufferSide>& sides, BufferSide side) {
  if (std::ranges::find(sides, side) == sides.end()) sides.push_back(std::move(side));
}

/// Names of one image differ ("colorimg1", "gaux..."): a render target has its own.
BufferSide sideOfImage(const SamplerBinding& image, const Step& step) {
  if (!image.buffer || !image.buffer->image) return {image.name, false};
  const bool shadow = image.buffer->kind == BufferName::Kind::ShadowColor;
  const std::uint32_t flipped = shadow ? step.shadowFlipped : step.flipped;
  return {fmt::format("{}{}", shadow ? "shadowcolor" : "colortex", image.buffer->index),
          (flipped >> image.buffer->index & 1u) != 0};
}

}  // namespace

std::vector<BufferSide> FrameRenderer::writesOf(const Step& step) const {
  using Kind = Step::Kind;
  if (step.kind == Kind::CopyDepth) return {{fmt::format("depthtex{}", step.index), false}};
  if (step.kind == Kind::CopyShadowDepth) return {{"shadowtex1", false}};
  if (step.kind == Kind::ShadowVolumes) return {{"stenciltex0", false}};
  const bool draws = step.kind == Kind::Draw || step.kind == Kind::DrawShadow;
  const bool runs = draws || step.kind == Kind::Fullscreen || step.kind == Kind::Compute ||
                    step.kind == Kind::Present;
  if (!runs) return {};
  std::vector<BufferSide> sides;
  if (step.kind == Kind::Present) {
    sides.push_back({"screen", false});
  } else {
    const char* kind = inShadowMap(step) ? "shadowcolor" : "colortex";
    for (const int buffer : step.writes)
      addOnce(sides, {fmt::format("{}{}", kind, buffer), step.writesAlt(buffer)});
  }
  if (draws) addOnce(sides, {inShadowMap(step) ? "shadowtex0" : "depthtex0", false});
  if (step.program < 0) return sides;
  const auto addImages = [&](const GpuProgram& program) {
    for (const SamplerBinding& image : program.images) addOnce(sides, sideOfImage(image, step));
  };
  if (const auto drawn = loaded_->programs.find(step.program); drawn != loaded_->programs.end())
    addImages(*drawn->second);
  for (const auto& [key, program] : loaded_->computes)
    if (key.first == step.program && step.kind == Kind::Compute) addImages(*program);
  return sides;
}

}  // namespace orris
