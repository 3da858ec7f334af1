// The step of our extension STENCIL_SHADOW_VOLUMES: state around the volumes, and the light.
#include <glm/gtc/matrix_transform.hpp>

#include <orris/gl/functions.h>
#include <orris/plan/frame/celestial.h>
#include <orris/render/frame_renderer.h>
#include <orris/render/session/loaded_pack.h>
#include <orris/render/draw/pass_state.h>

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

/// What volumes are relative to. In steps of a section, as each writes their vertices again.
glm::ivec3 baseOf(const FrameState& state) {
  return glm::ivec3(glm::round(state.cameraPosition / 16.0)) * 16;
}

/// Takes what is relative to baseOf().
glm::mat4 volumeView(const FrameState& state) {
  return glm::translate(state.gbufferModelView, glm::vec3(glm::dvec3(baseOf(state)) - state.cameraPosition));
}

void setVolumeState() {
  gl::Disable(GL_BLEND);
  unsetAlphaTest();
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
  return (loaded_->volumes ? loaded_->volumes->builds() : 0) +
         (loaded_->lampVolumes ? loaded_->lampVolumes->builds() : 0);
}

VolumeMethod FrameRenderer::volumeMethod() const {
  const auto method = pack_->properties.settings.find("shadowvolume.method");
  return method == pack_->properties.settings.end() ? VolumeMethod::Auto
                                                    : volumeMethodOf(method->second);
}

const gl::Program& FrameRenderer::useVolumeProgram(const Step& step, const FrameState& state,
                                                   const glm::mat4& modelView) {
  DrawState draw;
  draw.modelView = modelView;
  draw.projection = state.gbufferProjection;
  draw.textureMatrix = glm::mat4(1);
  loadMatrices(draw, false);
  const GpuProgram& program = programOf(step);
  useProgram(program, step, state, draw);
  return program.program;
}

void FrameRenderer::drawLampVolumes(const Step& step, const FrameState& state) {
  gl::BindFramebuffer(GL_FRAMEBUFFER, loaded_->targets->lampFramebuffer().id());
  const glm::mat4 modelView = volumeView(state);
  const gl::Program& program = useVolumeProgram(step, state, modelView);
  loaded_->lampVolumes->draw(program, {state.gbufferProjection * modelView, baseOf(state), eyePyramid(state),
                                       options_.width, options_.height, volumeMethod()});
}

void FrameRenderer::drawShadowVolumes(const Step& step, const FrameState& state) {
  gl::Viewport(0, 0, options_.width, options_.height);
  if (schedule_.lampShadows) {
    const std::uint32_t none = 0;
    gl::ClearTexImage(loaded_->targets->lampShadows().id(), 0, GL_RED_INTEGER, GL_UNSIGNED_INT,
                      &none);
  }
  setVolumeState();
  if (loaded_->lampVolumes) drawLampVolumes(step, state);
  if (loaded_->volumes) {
    std::string error;
    gl::BindFramebuffer(GL_FRAMEBUFFER, loaded_->targets->framebuffer(step, error).id());
    const gl::Program& program = useVolumeProgram(step, state, volumeView(state));
    const glm::vec3 light = shadowLightDirection(state.skyAngle, pack_->directives.sunPathRotation);
    loaded_->volumes->draw(program, glm::vec4(light, 0), eyePyramid(state), baseOf(state), volumeMethod());
  }
  SamplerBinder::unbind(programOf(step));
  unsetVolumeState();
}

}  // namespace orris
