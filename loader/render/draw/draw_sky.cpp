// What a FrameRenderer draws far away: sky, stars, sun, moon and clouds.
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include <orris/gl/functions.h>
#include <orris/plan/frame/celestial.h>
#include <orris/plan/frame/clouds.h>
#include <orris/render/frame_renderer.h>
#include <orris/render/session/loaded_pack.h>
#include <orris/render/draw/pass_state.h>
#include <orris/render/scene/vertex_layout.h>

namespace orris {

void FrameRenderer::drawSky(const Step& step, const GpuProgram& program, const FrameState& state,
                            DrawState& draw) {
  const GpuScene& scene = *loaded_->scene;
  const bool turning = step.geometry == Geometry::Stars || step.geometry == Geometry::SunMoon;
  const float night =
      std::clamp(1 - (std::cos(state.skyAngle * 6.2831853f) * 2 + 0.25f), 0.0f, 1.0f);
  const float starlight = night * night * 0.5f;
  if (step.geometry == Geometry::Stars && starlight <= 0) return;
  draw.modelView = state.gbufferModelView;
  if (turning) {
    const auto turn = [](float degrees, glm::vec3 axis) {
      return glm::rotate(glm::mat4(1), glm::radians(degrees), axis);
    };
    draw.modelView = draw.modelView * turn(-90, {0, 1, 0}) *
                     turn(pack_->directives.sunPathRotation, {0, 0, 1}) *
                     turn(360 * state.skyAngle, {1, 0, 0});
  }
  draw.projection = state.gbufferProjection;
  draw.atlasSize = glm::ivec2(0);
  loadMatrices(draw, true);
  setFog(state, draw.renderStage);
  useProgram(program, step, state, draw);
  scene.bindShapes();
  bindVertices(program.program);
  if (step.geometry == Geometry::Sky) {
    setConstantColor(program.program, glm::vec4(state.environment.fogColor, 1));
    scene.drawQuads(scene.horizon, program.patches);
    setConstantColor(program.program, glm::vec4(state.environment.skyColor, 1));
    scene.drawQuads(scene.skyDisc, program.patches);
  } else if (step.geometry == Geometry::EndSky) {
    constexpr float kDark = 0x28 / 255.0f;
    setConstantColor(program.program, {kDark, kDark, kDark, 1});
    scene.drawQuads(scene.endCube, program.patches);
  } else if (step.geometry == Geometry::Stars) {
    setConstantColor(program.program, glm::vec4(starlight));
    scene.drawQuads(scene.stars, program.patches);
  } else {
    setConstantColor(program.program, glm::vec4(1, 1, 1, 1 - state.environment.rain));
    // A world without ground below the camera would show the body that the game's ground hides.
    constexpr float kLowest = -0.3f;
    const float sunHeight = sunDirection(state.skyAngle, pack_->directives.sunPathRotation).y;
    if (sunHeight > kLowest && pack_->properties.flag("sun", true))
      scene.drawQuads(scene.sun, program.patches);
    draw.renderStage = 5;  // MC_RENDER_STAGE_MOON
    uploadUniforms(program.drawUniforms, state, draw, loaded_->custom);
    if (-sunHeight > kLowest && pack_->properties.flag("moon", true))
      scene.drawQuads(scene.moon, program.patches);
  }
  setFog(state, 0);
  unbindVertices(program.program);
  SamplerBinder::unbind(program);
}

void FrameRenderer::drawClouds(const Step& step, const GpuProgram& program, const FrameState& state,
                               DrawState& draw) {
  const bool fancy = step.geometry == Geometry::CloudsFancy;
  const CloudLayer& layer = loaded_->scene->clouds(fancy);
  const glm::vec4 color = cloudColor(state);
  draw.modelView = state.gbufferModelView;
  draw.projection = state.gbufferProjection;
  draw.atlasSize = glm::ivec2(0);
  loadMatrices(draw, true);
  useProgram(program, step, state, draw);
  loaded_->scene->bindClouds();
  bindVertices(program.program);
  // As in the game, depth comes first: the boxes must not be seen through one another.
  for (const bool colors : {false, true}) {
    if (!colors && !fancy) continue;
    const auto mask = static_cast<GLboolean>(colors ? GL_TRUE : GL_FALSE);
    gl::ColorMask(mask, mask, mask, mask);
    maskBuffers(step, loaded_->outputs.at(&program));
    for (const glm::vec3& origin : cloudOrigins(state)) {
      draw.chunkOffset = origin;
      loadModelView(glm::translate(draw.modelView, origin));
      uploadUniforms(program.drawUniforms, state, draw, loaded_->custom);
      for (const CloudPart& part : layer.parts) {
        setConstantColor(program.program, {glm::vec3(color) * part.shade, color.a});
        loaded_->scene->drawQuads(part.range, program.patches);
      }
    }
  }
  unbindVertices(program.program);
  SamplerBinder::unbind(program);
}

}  // namespace orris
