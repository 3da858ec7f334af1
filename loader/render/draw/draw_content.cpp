// What a FrameRenderer draws of a frame's lists: entities, hands, particles, weather and the like.
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

#include <orris/render/frame_renderer.h>
#include <orris/render/session/loaded_pack.h>
#include <orris/render/draw/pass_state.h>
#include <orris/render/scene/vertex_layout.h>

namespace orris {
namespace {

// Iris: HandRenderer. The hand has its own field of view, and depth in front of all else.
glm::mat4 handProjection(const FrameState& state) {
  constexpr float kHandDepth = 0.125f, kHandFov = 70;
  const float focal = 1 / std::tan(glm::radians(kHandFov) / 2);
  glm::mat4 projection = state.gbufferProjection;
  projection[0][0] = focal * static_cast<float>(state.height) / static_cast<float>(state.width);
  projection[1][1] = focal;
  return glm::scale(glm::mat4(1), {1, 1, kHandDepth}) * projection;
}

// The game's: it moves along both axes, turned by 10 degrees.
glm::mat4 glintMatrix(const FrameState& state) {
  const double t = double(state.frameTimeCounter);
  const auto u = static_cast<float>(std::fmod(t / 27.5, 1)),
             v = static_cast<float>(std::fmod(t / 7.5, 1));
  const glm::mat4 moved = glm::translate(glm::mat4(1), {-u, v, 0});
  return glm::rotate(moved, glm::radians(10.0f), glm::vec3(0, 0, 1));
}

constexpr float kEverywhere = std::numeric_limits<float>::infinity();

/// Is an entity there, about a block wide, outside of the cube around the eye? Iris: BoxCuller.
bool isBeyond(const glm::vec3& middle, float reach) {
  constexpr float kHalf = 0.5f;
  return std::max({std::abs(middle.x), std::abs(middle.y), std::abs(middle.z)}) > reach + kHalf;
}

}  // namespace

// Iris: ShadowRenderer. Without a multiplier of its own, entities are drawn wherever the shadow map has them.
float FrameRenderer::entityShadowReach(const FrameState& state) const {
  const PackDirectives& directives = pack_->directives;
  const float mul = directives.shadowDistanceRenderMul * directives.entityShadowDistanceMul;
  if (directives.entityShadowDistanceMul == 1 || directives.entityShadowDistanceMul < 0)
    return kEverywhere;
  const float reach = directives.shadowDistance * mul;
  return reach > 0 ? reach : static_cast<float>(state.environment.renderDistance);
}

void FrameRenderer::setDrawIds(const ContentDraw& content, DrawState& draw) const {
  const auto idOf = [](const std::map<std::string, int>& ids, const std::string& name, int other) {
    const auto found = ids.find(name);
    return found == ids.end() ? other : found->second;
  };
  const bool listed = !pack_->entityIds.empty();
  draw.entityId = content.entity.empty() || !listed
                      ? 0
                      : idOf(pack_->entityIds, content.entity, kUnlistedEntity);
  draw.itemId = content.item.empty() ? -1 : idOf(pack_->itemIds, content.item, -1);
  draw.blockEntityId = content.block.name.empty()
                           ? -1
                           : pack_->blockIds.idOf(content.block.name, content.block.properties);
  draw.entityColor = content.entityColor;
}

void FrameRenderer::setContentMatrices(const Step& step, const FrameState& state,
                                       DrawState& draw) const {
  const bool shadow = step.kind == Step::Kind::DrawShadow, hand = isHand(step.geometry);
  draw.modelView = shadow ? state.shadowModelView : hand ? glm::mat4(1) : state.gbufferModelView;
  draw.projection = shadow ? shadowProjectionOf(state)
                    : hand ? handProjection(state)
                           : state.gbufferProjection;
  if (isGlint(step.geometry)) draw.textureMatrix = glintMatrix(state);
}

void FrameRenderer::drawContent(const Step& step, const GpuProgram& program,
                                const FrameState& state, DrawState& draw) {
  setContentMatrices(step, state, draw);
  const gl::Texture& texture = loaded_->scene->sheet(findContentKind(step.geometry)->sheet);
  draw.gtextureSize = {texture.width, texture.height};
  draw.gtextureId = static_cast<int>(texture.id());
  draw.atlasSize =
      isHand(step.geometry) || texture.id() == loaded_->scene->white().id() ? glm::ivec2(0) : draw.gtextureSize;
  loadMatrices(draw, true);
  useProgram(program, step, state, draw);
  loaded_->scene->bindLists();
  bindVertices(program.program);
  const float reach = step.kind == Step::Kind::DrawShadow ? entityShadowReach(state) : kEverywhere;
  for (const ContentDraw& content : lists_->draws) {
    if (content.geometry != step.geometry || isBeyond(content.middle, reach)) continue;
    setDrawIds(content, draw);
    setOverlay(program.program, content.entityColor.a > 0);
    uploadUniforms(program.drawUniforms, state, draw, loaded_->custom);
    loaded_->scene->drawQuads(content.range, program.patches);
  }
  unbindVertices(program.program);
  SamplerBinder::unbind(program);
}

}  // namespace orris
