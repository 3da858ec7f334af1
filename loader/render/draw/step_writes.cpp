// What each step of a frame reads, and what it leaves its results in.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include <orris/pack/files/text.h>
#include <orris/render/frame_renderer.h>
#include <orris/render/session/loaded_pack.h>

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

/// The buffers of the frame that a texture can be; of two names of one texture the first.
std::map<const gl::Texture*, BufferSide> sidesByTexture(const FrameRenderer& renderer) {
  std::map<const gl::Texture*, BufferSide> sides;
  for (const std::string& name : splitBlanks(renderer.bufferNames()))
    for (const bool alt : {false, true})
      if (const gl::Texture* texture = renderer.texture({name, alt}); texture != nullptr)
        sides.emplace(texture, BufferSide{name, alt});
  return sides;
}

}  // namespace

std::vector<const GpuProgram*> FrameRenderer::programsOf(const Step& step) const {
  std::vector<const GpuProgram*> programs;
  if (step.program < 0) return programs;
  if (const auto drawn = loaded_->programs.find(step.program); drawn != loaded_->programs.end())
    programs.push_back(drawn->second.get());
  for (const auto& [key, program] : loaded_->computes)
    if (key.first == step.program && step.kind == Step::Kind::Compute)
      programs.push_back(program.get());
  return programs;
}

std::vector<BufferSide> FrameRenderer::readsOf(const Step& step) const {
  using Kind = Step::Kind;
  if (step.kind == Kind::CopyDepth || step.kind == Kind::SampleCenterDepth)
    return {{"depthtex0", false}};
  if (step.kind == Kind::CopyShadowDepth) return {{"shadowtex0", false}};
  std::vector<BufferSide> reads;
  // Without a final program the picture is a copy.
  if (step.kind == Kind::Present && step.program < 0)
    return {{"colortex0", (step.flipped & 1u) != 0}};
  const auto sides = sidesByTexture(*this);
  for (const GpuProgram* program : programsOf(step)) {
    for (const SamplerBinding& sampler : program->samplers) {
      const auto side = sides.find(loaded_->binder->textureOf(sampler, step));
      addOnce(reads, side == sides.end() ? BufferSide{sampler.name, false} : side->second);
    }
    for (const SamplerBinding& image : program->images) addOnce(reads, sideOfImage(image, step));
  }
  return reads;
}

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
  for (const GpuProgram* program : programsOf(step))
    for (const SamplerBinding& image : program->images) addOnce(sides, sideOfImage(image, step));
  return sides;
}

}  // namespace orris
