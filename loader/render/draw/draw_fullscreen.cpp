// What a FrameRenderer does for whole pictures: passes over the screen, compute passes, the last picture.
#include <orris/gl/functions.h>
#include <orris/render/draw/pass_state.h>
#include <orris/render/frame_renderer.h>
#include <orris/render/scene/vertex_layout.h>
#include <orris/render/session/loaded_pack.h>

#include <algorithm>
#include <string>

namespace orris {
namespace {

void drawQuad(const GpuScene& scene, const GpuProgram& program) {
  scene.bindShapes();
  bindVertices(program.program);
  scene.drawQuads(scene.fullscreen, program.patches);
  unbindVertices(program.program);
  SamplerBinder::unbind(program);
}

/// Of a viewport: a pack may scale by any number.
int viewportPixels(float length) {
  constexpr float kMost = 32'767;  // all that GL promises
  return static_cast<int>(std::clamp(length, -kMost, kMost));
}

}  // namespace

void FrameRenderer::drawFullscreen(const Step& step, const FrameState& state) {
  buildMipmaps(step);
  const ProgramSource& source = pack_->programs[step.program];
  std::string error;
  const gl::Framebuffer& framebuffer = loaded_->targets->framebuffer(step, error);
  gl::BindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
  const auto [scale, x, y] = source.scale;
  const auto w = static_cast<float>(framebuffer.width), h = static_cast<float>(framebuffer.height);
  gl::Viewport(viewportPixels(w * x), viewportPixels(h * y), std::max(viewportPixels(w * scale), 0),
               std::max(viewportPixels(h * scale), 0));
  DrawState draw;
  setFullscreenState(&source, draw);
  const GpuProgram& program = programOf(step);
  useProgram(program, step, state, draw);
  const std::uint32_t outputs = loaded_->outputs.at(&program);
  maskBuffers(step, outputs);
  drawQuad(*loaded_->scene, program);
  unmaskBuffers(step, outputs);
}

void FrameRenderer::present(const Step& step, const FrameState& state) {
  const gl::Framebuffer& screen = loaded_->targets->screenFramebuffer();
  if (step.program < 0) {
    RenderTarget* source = loaded_->targets->find(false, 0);
    loaded_->blit(source->side((step.flipped & 1u) != 0), screen);
    return;
  }
  buildMipmaps(step);
  gl::BindFramebuffer(GL_FRAMEBUFFER, screen.id());
  gl::Viewport(0, 0, options_.width, options_.height);
  DrawState draw;
  setFullscreenState(&pack_->programs[step.program], draw);
  const GpuProgram& program = programOf(step);
  useProgram(program, step, state, draw);
  drawQuad(*loaded_->scene, program);
}

void FrameRenderer::buildMipmaps(const Step& step) {
  const bool shadow = step.group == ProgramGroup::ShadowComp;
  for (int buffer : step.mipmaps) {
    RenderTarget* target = loaded_->targets->find(shadow, buffer);
    if (target == nullptr) continue;
    const bool alt = ((shadow ? step.shadowFlipped : step.flipped) >> buffer & 1u) != 0;
    gl::generateMipmaps(target->side(alt));
    target->mipmapped[alt && target->plan.needsAlt ? 1 : 0] = true;
  }
}

void FrameRenderer::dispatch(const Step& step, const FrameState& state) {
  const ProgramSource& source = pack_->programs[step.program];
  glm::vec2 size(options_.width, options_.height);
  if (step.group == ProgramGroup::Shadow)
    size = glm::vec2(static_cast<float>(schedule_.shadowResolution));
  if (step.group == ProgramGroup::Setup) size = glm::vec2(1);
  DrawState draw;
  draw.fullscreen = true;
  for (size_t i = 0; i < source.computes.size(); ++i) {
    const ComputeSource& compute = source.computes[i];
    GpuProgram& program = *loaded_->computes.at({step.program, static_cast<int>(i)});
    if (!program.program.linked) continue;
    note(compute.name, &compute.text);
    useProgram(program, step, state, draw);
    gl::MemoryBarrier(GL_ALL_BARRIER_BITS);
    if (const auto it = pack_->properties.indirect.find(compute.name);
        it != pack_->properties.indirect.end()) {
      const unsigned counts = loaded_->resources->buffer(it->second.first);
      gl::BindBuffer(GL_DISPATCH_INDIRECT_BUFFER, counts);
      bindSharedBlocks(program, counts, static_cast<std::size_t>(it->second.second));
      gl::DispatchComputeIndirect(static_cast<GLintptr>(it->second.second));
    } else {
      const auto groups = groupCounts(compute, program.program.computeLocalSize, size);
      bindSharedBlocks(program, std::size_t{groups[0]} * groups[1] * groups[2]);
      gl::DispatchCompute(groups[0], groups[1], groups[2]);
    }
    SamplerBinder::unbind(program);
  }
  gl::MemoryBarrier(GL_ALL_BARRIER_BITS);
}

}  // namespace orris
