#include <orris/render/frame_renderer.h>

#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <string>
#include <utility>

#include <orris/core/work_record.h>
#include <orris/gl/functions.h>
#include <orris/pack/options/live_options.h>
#include <orris/plan/schedule/builtin_program.h>
#include <orris/render/draw/pass_state.h>
#include <orris/render/session/loaded_pack.h>

namespace orris {
namespace {

// The driver is waited for after each step of so many frames: what kills or stalls it mostly does so at
// once, and then the step is known. Later frames are drawn as fast as can be.
constexpr int kExactFrames = 2;

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
  setFog(state, 0);
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
  if (options_.timings && !clock_) clock_.emplace(!gl::isSoftwareRenderer(context_.driver().renderer));
  if (options_.timings) clock_->start();
  const bool draws = step.kind == Step::Kind::Fullscreen || step.kind == Step::Kind::Draw ||
                     step.kind == Step::Kind::DrawShadow || step.kind == Step::Kind::ShadowVolumes;
  // A program beyond a limit of the driver was reported when it was built.
  if (draws && !programOf(step).program.linked) return;
  const ProgramSource* source = step.program < 0 ? nullptr : &pack_->programs[step.program];
  if (step.kind != Step::Kind::Compute)
    note(step.name, source && !source->stages.empty() ? &source->stages.back() : nullptr);
  // A step whose shaders store waits for what came before, and what comes after waits for it; dispatch() sees to
  // that itself. A software rasteriser would draw all passes one by one if each waited.
  const bool stores = step.kind != Step::Kind::Compute && storesFromShaders(step);
  if (std::exchange(stored_, stores) || stores) gl::MemoryBarrier(GL_ALL_BARRIER_BITS);
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
  if (options_.timings) stepTimes_.push_back(clock_->stop(step.name));
  if (watcher_) watcher_(step);
}

bool FrameRenderer::storesFromShaders(const Step& step) const {
  return std::ranges::any_of(programsOf(step), [](const GpuProgram* program) {
    return !program->images.empty() || program->program.storageBlocks > 0;
  });
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
