// The step of our extension STENCIL_SHADOW_VOLUMES: state around the volumes, and the light.
#include <glm/gtc/matrix_transform.hpp>

#include "frame/celestial.h"
#include "frame/frame_renderer.h"
#include "frame/loaded_pack.h"
#include "frame/pass_state.h"
#include "gl/functions.h"

namespace orris {
namespace {

EyePyramid eyePyramid(const FrameState& state) {
  EyePyramid eye;
  eye[0] = state.cameraPosition;
  const glm::dmat4 toPlayer =
      glm::dmat4(state.gbufferModelViewInverse) * glm::dmat4(state.gbufferProjectionInverse);
  for (std::size_t i = 1; i < eye.size(); ++i) {
    const glm::dvec4 corner = toPlayer * glm::dvec4(i & 1 ? 1 : -1, i & 2 ? 1 : -1, -1, 1);
    eye[i] = state.cameraPosition + glm::dvec3(corner) / corner.w;
  }
  return eye;
}

void setVolumeState() {
  gl::Disable(GL_BLEND);
  gl::Disable(GL_ALPHA_TEST);
  gl::Disable(GL_CULL_FACE);
  gl::FrontFace(GL_CCW);
  gl::ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  gl::DepthMask(GL_FALSE);
  gl::Enable(GL_DEPTH_TEST);
  gl::Enable(GL_DEPTH_CLAMP);
  gl::Enable(GL_STENCIL_TEST);
  gl::StencilFunc(GL_ALWAYS, 0, 0xff);
  gl::StencilMask(0xff);
}

void unsetVolumeState() {
  gl::Disable(GL_STENCIL_TEST);
  gl::Disable(GL_DEPTH_CLAMP);
  gl::DepthMask(GL_TRUE);
  gl::DepthFunc(GL_LEQUAL);
  gl::ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

}  // namespace

int FrameRenderer::facesAtEye() const {
  return loaded_->volumes ? loaded_->volumes->facesAtEye() : 0;
}

int FrameRenderer::silhouetteBuilds() const {
  return loaded_->volumes ? loaded_->volumes->builds() : 0;
}

void FrameRenderer::drawShadowVolumes(const Step& step, const FrameState& state) {
  std::string error;
  gl::BindFramebuffer(GL_FRAMEBUFFER, loaded_->targets->framebuffer(step, error).id());
  gl::Viewport(0, 0, options_.width, options_.height);
  setVolumeState();
  ShadowVolumes& volumes = *loaded_->volumes;
  DrawState draw;
  const glm::vec3 offset(glm::dvec3(volumes.origin()) - state.cameraPosition);
  draw.modelView = glm::translate(state.gbufferModelView, offset);
  draw.projection = state.gbufferProjection;
  draw.textureMatrix = glm::mat4(1);
  loadMatrices(draw.modelView, draw.projection, false);
  const GpuProgram& program = programOf(step);
  useProgram(program, step, state, draw);
  const auto method = pack_->properties.settings.find("shadowvolume.method");
  volumes.draw(
      program.program,
      glm::vec4(shadowLightDirection(state.skyAngle, pack_->directives.sunPathRotation), 0),
      eyePyramid(state),
      method == pack_->properties.settings.end() ? VolumeMethod::Auto
                                                 : volumeMethodOf(method->second));
  SamplerBinder::unbind(program);
  unsetVolumeState();
}

}  // namespace orris
