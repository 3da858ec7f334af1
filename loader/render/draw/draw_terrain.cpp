// What a FrameRenderer draws of the world's geometry: which draw a step stands for, and the terrain.
#include <orris/gl/functions.h>
#include <orris/plan/frame/frustum.h>
#include <orris/render/draw/pass_state.h>
#include <orris/render/frame_renderer.h>
#include <orris/render/scene/vertex_layout.h>
#include <orris/render/session/loaded_pack.h>

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <string>
#include <utility>
#include <vector>

namespace orris {
namespace {

RenderLayer layerOf(Geometry geometry) {
  return geometry == Geometry::Cutout        ? RenderLayer::Cutout
         : geometry == Geometry::BlockEntity ? RenderLayer::BlockEntity
         : geometry == Geometry::Translucent ? RenderLayer::Translucent
                                             : RenderLayer::Solid;
}

/// How far from the eye the shadow pass draws, blocks.
float shadowReach(const ShaderPack& pack, const FrameState& state) {
  const PackDirectives& directives = pack.directives;
  const float mul = directives.shadowDistanceRenderMul;
  const float reach = mul >= 0 ? directives.shadowDistance * mul
                               : static_cast<float>(state.environment.renderDistance);
  const auto culling = pack.properties.settings.find("shadow.culling");
  // Two names of one mode. Iris: ShaderProperties.
  const bool voxels = culling != pack.properties.settings.end() &&
                      (culling->second == "reversed" || culling->second == "safe_zone");
  return voxels ? std::max(reach, directives.voxelDistance) : reach;
}

/// From the eye to the nearest point of a box about it.
float distanceTo(const glm::vec3& lo, const glm::vec3& hi) {
  return glm::length(glm::clamp(glm::vec3(0), lo, hi));
}

/// Sections of a layer that are seen, `isSeen(section, lo, hi)` with their box about the eye, each with the distance of its middle.
template <class IsSeen>
std::vector<std::pair<float, const MeshSection*>> sectionsOf(const GpuScene& scene,
                                                             RenderLayer layer,
                                                             const glm::dvec3& eye,
                                                             const IsSeen& isSeen) {
  std::vector<std::pair<float, const MeshSection*>> found;
  for (const MeshSection& section : scene.sections()) {
    if (section.layer != layer || section.count == 0) continue;
    const glm::vec3 lo(glm::dvec3(section.origin) - eye), hi = lo + 16.0f;
    if (isSeen(section, lo, hi)) found.emplace_back(glm::length((lo + hi) * 0.5f), &section);
  }
  return found;
}

/// Do lines of sight begin where the camera is, in no block? Not for what is seen in parallel, or by an engine's view from
/// elsewhere; bobbing is not elsewhere.
bool seesFromCamera(const FrameState& state) {
  constexpr float kBobbing = 0.3f;  // blocks
  const bool parallel = state.gbufferProjection[3][3] != 0;
  return !parallel && !state.eyeInBlock && glm::length(glm::vec3(state.gbufferModelView[3])) < kBobbing;
}

}  // namespace

void FrameRenderer::drawGeometry(const Step& step, const FrameState& state) {
  const ProgramSource* source = step.program >= 0 ? &pack_->programs[step.program] : nullptr;
  std::string error;
  const gl::Framebuffer& framebuffer = loaded_->targets->framebuffer(step, error);
  gl::BindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
  const bool shadow = step.kind == Step::Kind::DrawShadow;
  const int size = schedule_.shadowResolution;
  gl::Viewport(0, 0, shadow ? size : options_.width, shadow ? size : options_.height);
  DrawState draw;
  draw.atlasSize = draw.gtextureSize = loaded_->scene->atlasSize();
  draw.gtextureId = static_cast<int>(loaded_->scene->atlas().id());
  draw.forcedDepth =
      (step.geometry == Geometry::BeamGlow && pack_->properties.flag("beacon.beam.depth", false)) ||
      (step.name == "gbuffers_weather" && pack_->properties.flag("rain.depth", false));
  setGeometryState(step, source, draw);
  const GpuProgram& program = programOf(step);
  const std::uint32_t outputs = loaded_->outputs.at(&program);
  maskBuffers(step, outputs);
  if (isSky(step.geometry)) {
    drawSky(step, program, state, draw);
  } else if (isClouds(step.geometry)) {
    drawClouds(step, program, state, draw);
  } else if (engine_ != nullptr) {
    drawEngine(step, program, state, draw);
  } else if (findContentKind(step.geometry) != nullptr) {
    drawContent(step, program, state, draw);
  } else {
    drawTerrain(step, program, state, shadow ? state.shadowModelView : state.gbufferModelView,
                shadow ? shadowProjectionOf(state) : state.gbufferProjection, draw);
  }
  unmaskBuffers(step, outputs);
  unsetAlphaTest();
  gl::Disable(GL_BLEND);
  gl::DepthMask(GL_TRUE);
}

glm::mat4 FrameRenderer::shadowProjectionOf(const FrameState& state) const {
  const auto& fov = pack_->directives.shadowMapFov;
  if (!fov) return state.shadowProjection;
  return glm::perspective(glm::radians(*fov), 1.0f, 0.05f, 256.0f);
}

void FrameRenderer::drawTerrain(const Step& step, const GpuProgram& program,
                                const FrameState& state, const glm::mat4& view,
                                const glm::mat4& projection, DrawState& draw) {
  const bool shadow = step.kind == Step::Kind::DrawShadow;
  draw.modelView = view;
  draw.projection = projection;
  draw.textureMatrix = glm::mat4(1);
  loadMatrices(draw, true);
  useProgram(program, step, state, draw);
  GpuScene& scene = *loaded_->scene;
  std::size_t bound = 0;
  const auto bindPart = [&](std::size_t part) {
    scene.bindTerrain(bound = part);
    bindVertices(program.program);
    if (!shadow && step.geometry != Geometry::BlockEntity) setChunkFade(program.program);
  };
  bindPart(0);
  const Frustum frustum(projection * view);
  const float reach = shadow ? shadowReach(*pack_, state) : 0;
  const VisibleSections* seen = shadow || !seesFromCamera(state) ? nullptr : &scene.seenFrom(state.cameraPosition);
  // The shadow pass keeps everything in reach: packs voxelise from it.
  auto visible = sectionsOf(scene, layerOf(step.geometry), state.cameraPosition,
                            [&](const MeshSection& section, const glm::vec3& lo, const glm::vec3& hi) {
                              if (shadow) return distanceTo(lo, hi) <= reach;
                              return !frustum.outside(lo - 1.0f, hi + 1.0f) && (!seen || seen->contains(section.origin));
                            });
  if (shadow && step.geometry == Geometry::BlockEntity && !pack_->properties.flag("shadowBlockEntities", true))
    std::erase_if(visible, [&](const auto& entry) { return !scene.emits(entry.second->state); });
  const bool sorted = step.geometry == Geometry::Translucent && !shadow;
  if (sorted) {
    loaded_->scene->sortTranslucent(state.cameraPosition);
    std::stable_sort(visible.begin(), visible.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
  }
  for (const auto& [distance, section] : visible) {
    draw.chunkOffset = glm::vec3(glm::dvec3(section->origin) - state.cameraPosition);
    if (section->layer == RenderLayer::BlockEntity)
      draw.blockEntityId = loaded_->scene->blockId(section->state);
    loadModelView(glm::translate(view, draw.chunkOffset));
    uploadUniforms(program.drawUniforms, state, draw, loaded_->custom);
    if (const std::size_t part = scene.terrainPart(*section); part != bound) bindPart(part);
    if (sorted)
      scene.drawSorted(*section, program.patches);
    else
      scene.drawSection(*section, program.patches);
  }
  unbindVertices(program.program);
  SamplerBinder::unbind(program);
}

}  // namespace orris
