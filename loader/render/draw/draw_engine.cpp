// What a FrameRenderer draws of an engine's geometry.
#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

#include <orris/gl/clear_stack.h>
#include <orris/gl/functions.h>
#include <orris/render/scene/engine_geometry.h>
#include <orris/render/frame_renderer.h>
#include <orris/render/session/loaded_pack.h>
#include <orris/render/draw/pass_state.h>

namespace orris {
namespace {

bool isBlocks(Geometry geometry) { return findContentKind(geometry) == nullptr; }

}  // namespace

int EnginePass::attributeLocation(std::string_view name) const {
  for (const gl::ActiveVariable& attribute : parts_.program.program.attributes)
    if (attribute.name == name) return attribute.location;
  return -1;
}

void EnginePass::begin(const glm::dvec3& origin, const EngineTextures& textures,
                       const EngineIds& ids) {
  DrawState& draw = parts_.draw;
  const glm::vec3 offset = isHand(geometry()) ? glm::vec3(0) : glm::vec3(origin - camera());
  // The game moves chunks by a uniform, and all else by the matrix.
  draw.chunkOffset = isBlocks(geometry()) ? offset : glm::vec3(0);
  draw.modelView = isBlocks(geometry()) ? view_ : glm::translate(view_, offset);
  draw.gtextureSize = textures.albedo != 0 ? textures.size : glm::ivec2(1);
  draw.gtextureId = static_cast<int>(textures.albedo);
  draw.atlasSize = isHand(geometry()) || textures.albedo == 0 ? glm::ivec2(0) : textures.size;
  draw.entityId = ids.entity;
  draw.itemId = ids.item;
  draw.blockEntityId = ids.blockEntity;
  draw.entityColor = ids.entityColor;
  loadModelView(glm::translate(draw.modelView, draw.chunkOffset));
  uploadUniforms(parts_.program.drawUniforms, parts_.state, draw, parts_.custom);
  if (parts_.binder.setEngineTextures(textures)) parts_.binder.bind(parts_.program, parts_.step);
}

void EnginePass::bindVertices(const VertexPlace& place) const {
  orris::bindVertices(parts_.program.program, place);
  setOverlay(parts_.program.program, parts_.draw.entityColor.a > 0);
  if (isBlocks(geometry()) && geometry() != Geometry::BlockEntity && !isShadow())
    setChunkFade(parts_.program.program);
}

void EnginePass::drawQuads(unsigned first, unsigned quads) const {
  parts_.scene.reserveQuads(quads);
  parts_.scene.bindIndices();
  parts_.scene.drawQuads({first, quads}, patches());
}

void EnginePass::drawTriangles(unsigned first, unsigned count, unsigned indexBuffer,
                               unsigned indexType, std::size_t indexOffset) const {
  if (patches()) gl::PatchParameteri(GL_PATCH_VERTICES, 3);
  const unsigned mode = patches() ? GL_PATCHES : GL_TRIANGLES;
  gl::BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indexBuffer);
  gl::clearStack();
  if (indexBuffer == 0)
    return gl::DrawArrays(mode, static_cast<int>(first), static_cast<int>(count));
  gl::DrawElementsBaseVertex(mode, static_cast<int>(count), indexType,
                             reinterpret_cast<const void*>(indexOffset), static_cast<int>(first));
}

void FrameRenderer::drawEngine(const Step& step, const GpuProgram& program, const FrameState& state,
                               DrawState& draw) {
  const bool shadow = step.kind == Step::Kind::DrawShadow;
  if (isBlocks(step.geometry)) {
    draw.modelView = shadow ? state.shadowModelView : state.gbufferModelView;
    draw.projection = shadow ? shadowProjectionOf(state) : state.gbufferProjection;
  } else {
    setContentMatrices(step, state, draw);
  }
  loadMatrices(draw, true);
  loaded_->binder->setEngineTextures(EngineTextures());
  useProgram(program, step, state, draw);
  EnginePass pass({step, program, state, loaded_->custom, *loaded_->scene, *loaded_->binder, draw});
  engine_->draw(pass);
  unbindVertices(program.program);
  SamplerBinder::unbind(program);
  loaded_->binder->setEngineTextures(std::nullopt);
}

}  // namespace orris
