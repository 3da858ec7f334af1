#include <orris/render/frame_renderer.h>

#include <fmt/format.h>
#include <malloc.h>
#include <time.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include <orris/core/work_record.h>
#include <orris/gl/functions.h>
#include <orris/pack/options/live_options.h>
#include <orris/plan/schedule/builtin_program.h>
#include <orris/plan/frame/frustum.h>
#include <orris/render/session/loaded_pack.h>
#include <orris/render/draw/pass_state.h>
#include <orris/render/scene/vertex_layout.h>

namespace orris {
namespace {

using Clock = std::chrono::steady_clock;

// The driver is waited for after each step of so many frames: what kills or stalls it mostly does so at
// once, and then the step is known. Later frames are drawn as fast as can be.
constexpr int kExactFrames = 2;

/// Of all threads.
double processorSeconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

RenderLayer layerOf(Geometry geometry) {
  return geometry == Geometry::Cutout        ? RenderLayer::Cutout
         : geometry == Geometry::BlockEntity ? RenderLayer::BlockEntity
         : geometry == Geometry::Translucent ? RenderLayer::Translucent
                                             : RenderLayer::Solid;
}

}  // namespace

FrameRenderer::FrameRenderer(gl::Context& context, const RendererOptions& options)
    : context_(context), options_(options) {
  if (!gl::isCoreProfile()) return;
  unsigned id = 0;
  gl::CreateVertexArrays(1, &id);
  vertexArray_ = gl::Handle<gl::deleteVertexArray>(id);
}
FrameRenderer::~FrameRenderer() = default;

bool FrameRenderer::setPack(std::shared_ptr<const ShaderPack> pack, const SceneData& scene,
                            LoadReport& report, Diagnostics& diagnostics) {
  Diagnostics problems;
  Schedule schedule =
      buildSchedule(*pack, options_.width, options_.height, scene.contents(), problems);
  auto loaded = std::make_unique<Loaded>(*pack, schedule, scene, options_,
                                         loaded_.get(), ahead_.built, report, problems);
  const bool failed = hasErrors(problems);
  diagnostics.insert(diagnostics.end(), problems.begin(), problems.end());
  if (failed) return false;
  firstFrame_ |= loaded->freshTargets;
  framesOfPack_ = 0;
  pack_ = std::move(pack);
  schedule_ = std::move(schedule);
  loaded_ = std::move(loaded);
  loaded_->makeBinder(pack_->directives);
  for (const std::string& option : pack_->live)
    setLive(option, pack_->options.value(pack_->values, option));
  // Compiling leaves tens of megabytes in small pieces, which stay with the process unless they are asked for.
  malloc_trim(0);
  return true;
}

// A program keeps its uniforms: nothing is left to do for each frame.
void FrameRenderer::setLive(const std::string& option, const std::string& value) {
  const std::string name = std::string(kLivePrefix) + option;
  const double number = liveNumber(value);
  for (const auto& [key, program] : loaded_->byText) {
    const unsigned id = program->program.id();
    for (const gl::ActiveVariable& uniform : program->program.uniforms) {
      if (uniform.name != name) continue;
      if (uniform.type == GL_INT) {
        gl::ProgramUniform1i(id, uniform.location, static_cast<int>(number));
      } else {
        gl::ProgramUniform1f(id, uniform.location, static_cast<float>(number));
      }
    }
  }
}

void FrameRenderer::forgetScene() {
  loaded_->forgetScene();
  firstFrame_ = true;  // what the buffers hold is of the other world
}

void FrameRenderer::updateScene(const SceneData& scene) {
  loaded_->scene->uploadMesh(scene, blockIdsOf(*pack_, scene.world.blocks), vertexStyleOf(*pack_));
  if (loaded_->volumes) loaded_->volumes->setCasters(castersOf(scene.mesh, scene.atlas));
  if (loaded_->lampVolumes) loaded_->lampVolumes->setScene(scene);
}

void FrameRenderer::setTimings(bool timings) {
  options_.timings = timings;
  if (!timings) stepTimes_.clear();
}

bool FrameRenderer::resize(int width, int height, Diagnostics& diagnostics) {
  if (width == options_.width && height == options_.height) return true;
  options_.width = width;
  options_.height = height;
  schedule_ = buildSchedule(*pack_, width, height, loaded_->contents, diagnostics);
  loaded_->resize(*pack_, schedule_, diagnostics);
  loaded_->makeBinder(pack_->directives);
  firstFrame_ = true;
  return !hasErrors(diagnostics);
}

void FrameRenderer::render(const FrameState& given, const DrawLists& lists) {
  FrameState state = given;
  lists_ = &lists;
  if (loaded_->lampVolumes) state.volumeLights = loaded_->lampVolumes->choose(state.cameraPosition);
  if (vertexArray_) gl::BindVertexArray(vertexArray_.id());
  gl::PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl::PixelStorei(GL_PACK_ALIGNMENT, 1);
  stepTimes_.clear();
  const float* fog = &state.environment.fogColor.x;
  loaded_->scene->updateLightmap(state);
  loaded_->scene->animate(state);
  if (!lists.draws.empty()) loaded_->scene->uploadLists(lists);
  loaded_->resources->bindBuffers();
  setFog(state);
  loaded_->custom.evaluate(
      [&](const std::string& name) {
        const UniformRow* row = findUniform(name);
        return row != nullptr ? row->value(state, DrawState()) : Value::ofInt(0);
      },
      state.frameTime, state.seed + static_cast<unsigned>(state.frameCounter));
  if (std::exchange(firstFrame_, false)) {
    loaded_->targets->clearFresh(fog);
    loaded_->resources->clearImages(true);
    for (const Step& step : schedule_.setup) runStep(step, state);
  }
  for (const Step& step : schedule_.frame) runStep(step, state);
  if (workIsNoted() && framesOfPack_ < kExactFrames) gl::Finish();
  ++framesOfPack_;
  loaded_->targets->keepHistory();
  loaded_->targets->forgetMipmaps();
}

void FrameRenderer::runStep(const Step& step, const FrameState& state) {
  const auto start = Clock::now();
  const double startOfWork = options_.timings ? processorSeconds() : 0;
  const bool draws = step.kind == Step::Kind::Fullscreen || step.kind == Step::Kind::Draw ||
                     step.kind == Step::Kind::DrawShadow || step.kind == Step::Kind::ShadowVolumes;
  // A program beyond a limit of the driver was reported when it was built.
  if (draws && !programOf(step).program.linked) return;
  const ProgramSource* source = step.program < 0 ? nullptr : &pack_->programs[step.program];
  if (step.kind != Step::Kind::Compute)
    note(step.name, source && !source->stages.empty() ? &source->stages.back() : nullptr);
  if (loaded_->storesFromShaders) gl::MemoryBarrier(GL_ALL_BARRIER_BITS);
  switch (step.kind) {
    case Step::Kind::ClearImages:
      loaded_->resources->clearImages(false);
      break;
    case Step::Kind::ClearShadow:
      loaded_->targets->clearShadow();
      break;
    case Step::Kind::ClearColor:
      loaded_->targets->clearColor(&state.environment.fogColor.x);
      break;
    case Step::Kind::Compute:
      dispatch(step, state);
      break;
    case Step::Kind::Fullscreen:
      drawFullscreen(step, state);
      break;
    case Step::Kind::Draw:
    case Step::Kind::DrawShadow:
      drawGeometry(step, state);
      break;
    case Step::Kind::ShadowVolumes:
      drawShadowVolumes(step, state);
      break;
    case Step::Kind::CopyShadowDepth:
      loaded_->copyDepth(loaded_->targets->shadowDepth(0), loaded_->targets->shadowDepth(1));
      break;
    case Step::Kind::ShadowMipmaps:
      shadowMipmaps();
      break;
    case Step::Kind::SampleCenterDepth:
      sampleCenterDepth();
      break;
    case Step::Kind::CopyDepth:
      loaded_->copyDepth(loaded_->targets->depth(0), loaded_->targets->depth(step.index));
      break;
    case Step::Kind::Present:
      present(step, state);
      break;
  }
  if (options_.timings) {
    gl::Finish();
    stepTimes_.push_back({step.name, std::chrono::duration<double>(Clock::now() - start).count(),
                          processorSeconds() - startOfWork});
  }
  if (watcher_) watcher_(step);
}

void FrameRenderer::note(std::string_view name, const StageText* stage) {
  if (!workIsNoted()) return;
  const bool exact = framesOfPack_ < kExactFrames;
  if (exact) gl::Finish();
  noteStep(name, stage ? entryFileOf(*stage) : std::string_view(), exact);
}

const GpuProgram& FrameRenderer::programOf(const Step& step) const {
  if (step.program >= 0) return *loaded_->programs.at(step.program);
  return usesBuiltinSky(step.geometry) ? *loaded_->builtinSky : *loaded_->builtinTerrain;
}

void FrameRenderer::useProgram(const GpuProgram& program, const Step& step, const FrameState& state,
                               const DrawState& draw) {
  gl::UseProgram(program.program.id());
  uploadUniforms(program.frameUniforms, state, draw, loaded_->custom);
  uploadUniforms(program.drawUniforms, state, draw, loaded_->custom);
  loaded_->binder->bind(program, step);
}

void FrameRenderer::drawFullscreen(const Step& step, const FrameState& state) {
  buildMipmaps(step);
  const ProgramSource& source = pack_->programs[step.program];
  std::string error;
  const gl::Framebuffer& framebuffer = loaded_->targets->framebuffer(step, error);
  gl::BindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
  const auto [scale, x, y] = source.scale;
  const auto w = static_cast<float>(framebuffer.width), h = static_cast<float>(framebuffer.height);
  gl::Viewport(static_cast<int>(w * x), static_cast<int>(h * y), static_cast<int>(w * scale),
               static_cast<int>(h * scale));
  DrawState draw;
  setFullscreenState(&source, draw);
  const GpuProgram& program = programOf(step);
  useProgram(program, step, state, draw);
  loaded_->scene->bindShapes();
  bindVertices(program.program);
  loaded_->scene->drawQuads(loaded_->scene->fullscreen, program.patches);
  unbindVertices(program.program);
  SamplerBinder::unbind(program);
}

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
  draw.forcedDepth = (step.geometry == Geometry::BeamGlow &&
                      pack_->properties.flag("beacon.beam.depth", false)) ||
                     (step.name == "gbuffers_weather" && pack_->properties.flag("rain.depth", false));
  setGeometryState(step, source, draw);
  const GpuProgram& program = programOf(step);
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
  const GpuScene& scene = *loaded_->scene;
  std::size_t bound = 0;
  const auto bindPart = [&](std::size_t part) {
    scene.bindTerrain(bound = part);
    bindVertices(program.program);
    if (!shadow && step.geometry != Geometry::BlockEntity) setChunkFade(program.program);
  };
  bindPart(0);
  const Frustum frustum(projection * view);
  const float mul = pack_->directives.shadowDistanceRenderMul;
  float reach = mul >= 0 ? pack_->directives.shadowDistance * mul
                         : static_cast<float>(state.environment.renderDistance);
  const auto culling = pack_->properties.settings.find("shadow.culling");
  // Two names of one mode. Iris: ShaderProperties.
  if (culling != pack_->properties.settings.end() &&
      (culling->second == "reversed" || culling->second == "safe_zone"))
    reach = std::max(reach, pack_->directives.voxelDistance);
  std::vector<std::pair<float, const MeshSection*>> visible;
  for (const MeshSection& section : loaded_->scene->sections()) {
    if (section.layer != layerOf(step.geometry) || section.count == 0) continue;
    const glm::vec3 lo(glm::dvec3(section.origin) - state.cameraPosition), hi = lo + 16.0f;
    const glm::vec3 nearest = glm::clamp(glm::vec3(0), lo, hi);
    // The shadow pass keeps everything in reach: packs voxelise from it.
    if (shadow ? glm::length(nearest) > reach : frustum.outside(lo - 1.0f, hi + 1.0f)) continue;
    visible.emplace_back(glm::length((lo + hi) * 0.5f), &section);
  }
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
  loaded_->scene->bindShapes();
  bindVertices(program.program);
  loaded_->scene->drawQuads(loaded_->scene->fullscreen, program.patches);
  unbindVertices(program.program);
  SamplerBinder::unbind(program);
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

void FrameRenderer::shadowMipmaps() {
  for (int i = 0; i < 2; ++i)
    if (pack_->directives.shadowtex[i].mipmap && loaded_->targets->shadowDepth(i).id() != 0)
      gl::generateMipmaps(loaded_->targets->shadowDepth(i));
}

void FrameRenderer::sampleCenterDepth() {
  std::string error;
  Step step;
  step.kind = Step::Kind::Draw;
  step.group = ProgramGroup::Gbuffers;
  gl::BindFramebuffer(GL_FRAMEBUFFER, loaded_->targets->framebuffer(step, error).id());
  gl::ReadPixels(options_.width / 2, options_.height / 2, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT,
                 &centerDepth_);
}

unsigned FrameRenderer::screenFramebuffer() { return loaded_->targets->screenFramebuffer().id(); }

}  // namespace orris
