#include <orris/render/session/loaded_pack.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <orris/core/work_record.h>
#include <orris/gl/functions.h>
#include <orris/glsl/syntax/fragment_outputs.h>
#include <orris/plan/schedule/builtin_program.h>

namespace orris {
namespace {

std::vector<const StageText*> pointersTo(const std::vector<StageText>& stages) {
  std::vector<const StageText*> result;
  for (const StageText& stage : stages) result.push_back(&stage);
  return result;
}

std::string keyOf(const std::vector<const StageText*>& stages) {
  std::string key;
  for (const StageText* stage : stages)
    key +=
        fmt::format("{}:{};", stageName(stage->stage), std::hash<std::string>()(stage->text.text));
  return key;
}

/// Bindings hold places in the list of custom uniforms.
std::string poolKey(std::string key, const CustomUniforms& custom) {
  for (const auto& [name, value] : custom.values()) key += name + ",";
  return key;
}

SourceLines linesOf(const ShaderPack& pack) {
  return [&pack](const std::string& file, int line) { return pack.sourceLine(file, line); };
}

}  // namespace

std::shared_ptr<GpuProgram> FrameRenderer::buildWanted(const Wanted& wanted,
                                                       const SourceLines& lines, LoadReport& report,
                                                       Diagnostics& diagnostics) {
  noteWork("compiling", wanted.name, entryFileOf(*wanted.stages.back()));
  auto built = std::make_shared<GpuProgram>(
      buildGpuProgram(wanted.name, wanted.stages, lines, diagnostics));
  ++report.programsBuilt;
  report.built.push_back(wanted.name);
  report.compileSeconds += built->program.compileSeconds + built->program.linkSeconds;
  return built;
}

std::string_view entryFileOf(const StageText& stage) {
  const auto& sites = stage.text.sites;
  return sites.empty() ? std::string_view() : std::string_view(sites.front().file);
}

std::array<unsigned, 3> groupCounts(const ComputeSource& compute, const std::vector<int>& localSize,
                                    const glm::vec2& size) {
  std::array<unsigned, 3> groups{1, 1, 1};
  if (compute.directives.workGroups) {
    for (int i = 0; i < 3; ++i)
      groups[i] = static_cast<unsigned>(std::max(0, (*compute.directives.workGroups)[i]));
    return groups;
  }
  const auto scale = compute.directives.workGroupsRender.value_or(std::array<float, 2>{1, 1});
  for (int i = 0; i < 2; ++i) {
    const float local =
        localSize.size() == 3 ? static_cast<float>(std::max(1, localSize[i])) : 1.0f;
    groups[i] = static_cast<unsigned>(std::ceil(std::ceil(size[i] * scale[i]) / local));
  }
  return groups;
}

std::vector<std::string> FrameRenderer::programsLeftOut() const {
  std::vector<std::string> names;
  for (const int index : schedule_.programs) {
    const ProgramSource& source = pack_->programs[static_cast<std::size_t>(index)];
    const auto drawn = loaded_->programs.find(index);
    if (drawn != loaded_->programs.end() && !drawn->second->program.linked)
      names.push_back(source.name);
    for (std::size_t i = 0; i < source.computes.size(); ++i)
      if (!loaded_->computes.at({index, static_cast<int>(i)})->program.linked)
        names.push_back(source.computes[i].name);
  }
  return names;
}

FrameRenderer::Loaded::Loaded(const ShaderPack& pack, const Schedule& schedule,
                              const SceneData& sceneData, const RendererOptions& options,
                              Loaded* previous, const ProgramPool& ahead, LoadReport& report,
                              Diagnostics& diagnostics)
    : contents(sceneData.contents()),
      custom(pack.properties.customUniforms, expressionInput, diagnostics),
      options_(options),
      plan_(schedule),
      blockIds_(blockIdsOf(pack, sceneData.world.blocks)),
      style_(vertexStyleOf(pack)) {
  if (hasErrors(diagnostics)) return;
  buildPrograms(pack, schedule, {previous, ahead}, report, diagnostics);
  if (hasErrors(diagnostics)) return;
  freshTargets = previous == nullptr || !schedule.sameTargets(previous->plan_);
  targets = freshTargets ? std::make_shared<RenderTargets>(
                               schedule, options.floatScreen,
                               previous != nullptr ? previous->targets.get() : nullptr, diagnostics)
                         : previous->targets;
  const bool sameScene =
      previous != nullptr && previous->blockIds_ == blockIds_ && previous->style_ == style_;
  scene = sameScene ? previous->scene : std::make_shared<GpuScene>(sceneData, blockIds_, style_);
  resources = std::make_unique<PackResources>(pack, schedule.width, schedule.height, diagnostics);
  if (schedule.noisetex)
    noise = makeNoiseTexture(std::clamp(pack.directives.noiseTextureResolution, 1, 4096));
  if (schedule.sunVolumes)
    volumes = std::make_unique<ShadowVolumes>(castersOf(sceneData.mesh, sceneData.atlas));
  const auto lights = pack.properties.settings.find("shadowvolume.lights");
  if (schedule.lampShadows && lights != pack.properties.settings.end())
    lampVolumes = std::make_unique<LampVolumes>(
        sceneData, parseVolumeLights(lights->second).value_or(VolumeLightSettings()));
  if (previous == nullptr || freshTargets) return;
  resources->clearImages(true);
}

std::vector<FrameRenderer::Wanted> FrameRenderer::wantedPrograms(const ShaderPack& pack,
                                                               const Schedule& schedule) {
  std::vector<Wanted> wanted;
  const auto add = [&wanted](const std::string& name, std::vector<const StageText*> stages) {
    wanted.push_back({name, keyOf(stages), std::move(stages)});
  };
  for (const int index : schedule.programs) {
    const ProgramSource& source = pack.programs[static_cast<std::size_t>(index)];
    if (!source.stages.empty()) add(source.name, pointersTo(source.stages));
    for (const ComputeSource& compute : source.computes) add(compute.name, {&compute.text});
  }
  return wanted;
}

bool FrameRenderer::buildAhead(const std::shared_ptr<const ShaderPack>& pack, const SceneData& scene,
                               LoadReport& report, Diagnostics& diagnostics) {
  if (ahead_.pack != pack) {
    Diagnostics problems;  // those of setPack(), too
    ahead_ = {.pack = pack,
              .wanted = wantedPrograms(*pack, buildSchedule(*pack, options_.width, options_.height,
                                                            scene.contents(), problems))};
  }
  while (ahead_.next < ahead_.wanted.size()) {
    const Wanted& wanted = ahead_.wanted[ahead_.next++];
    if (loaded_->byText.contains(wanted.key) || ahead_.built.contains(wanted.key)) continue;
    ahead_.built[wanted.key] = buildWanted(wanted, linesOf(*pack), report, diagnostics);
    return true;
  }
  return false;
}

void FrameRenderer::Loaded::buildPrograms(const ShaderPack& pack, const Schedule& schedule,
                                          const Known& known, LoadReport& report,
                                          Diagnostics& diagnostics) {
  const SourceLines lines = linesOf(pack);
  for (const Wanted& wanted : wantedPrograms(pack, schedule))
    program(wanted, lines, known, report, diagnostics);
  for (const int index : schedule.programs) {
    const ProgramSource& source = pack.programs[static_cast<std::size_t>(index)];
    if (!source.stages.empty()) programs[index] = byText.at(keyOf(pointersTo(source.stages)));
    for (size_t i = 0; i < source.computes.size(); ++i)
      computes[{index, static_cast<int>(i)}] = byText.at(keyOf({&source.computes[i].text}));
  }
  const auto needsBuiltin = [&](bool sky) {
    return std::any_of(schedule.frame.begin(), schedule.frame.end(), [&](const Step& step) {
      const bool geometry = step.kind == Step::Kind::Draw || step.kind == Step::Kind::DrawShadow;
      return geometry && step.program < 0 && usesBuiltinSky(step.geometry) == sky;
    });
  };
  for (const bool sky : {false, true}) {
    if (!needsBuiltin(sky)) continue;
    const auto stages = builtinProgram(sky);
    const auto pointers = pointersTo(stages);
    (sky ? builtinSky : builtinTerrain) =
        program({sky ? "built-in sky" : "built-in terrain", keyOf(pointers), pointers}, lines, known,
                report, diagnostics);
  }
}

std::shared_ptr<GpuProgram> FrameRenderer::Loaded::program(const Wanted& wanted,
                                                           const SourceLines& lines,
                                                           const Known& known, LoadReport& report,
                                                           Diagnostics& diagnostics) {
  // A copy of the bindings would share the GL object; custom uniforms may have moved, so makeBinder()
  // matches them again on the shared one after success of the whole load.
  const auto find = [](const auto& map, const std::string& key) {
    const auto it = map.find(key);
    return it == map.end() ? nullptr : it->second;
  };
  if (auto here = find(byText, wanted.key)) return here;
  std::shared_ptr<GpuProgram> result = find(known.ahead, wanted.key);
  if (!result) {
    if (known.previous) result = find(known.previous->byText, wanted.key);
    if (!result && options_.pool) result = find(*options_.pool, poolKey(wanted.key, custom));
    if (result) ++report.programsReused;
  }
  if (!result) {
    const std::size_t said = diagnostics.size();
    result = buildWanted(wanted, lines, report, diagnostics);
    // What has a message is built again, so that every renderer gives it.
    if (options_.pool && diagnostics.size() == said)
      (*options_.pool)[poolKey(wanted.key, custom)] = result;
  }
  byText[wanted.key] = result;
  const StageText& last = *wanted.stages.back();
  outputs[result.get()] = last.stage == Stage::Fragment ? outputsOf(last.text.text) : ~0u;
  return result;
}

void FrameRenderer::Loaded::resize(const ShaderPack& pack, const Schedule& schedule,
                                   Diagnostics& diagnostics) {
  plan_ = schedule;
  binder.reset();
  targets = std::make_shared<RenderTargets>(schedule, options_.floatScreen, nullptr, diagnostics);
  resources = std::make_unique<PackResources>(pack, schedule.width, schedule.height, diagnostics);
}

void FrameRenderer::Loaded::makeBinder(const PackDirectives& directives) {
  for (auto& [key, program] : byText) matchUniforms(*program, custom);
  binder = std::make_unique<SamplerBinder>(*targets, *scene, *resources, directives, noise);
}

void FrameRenderer::Loaded::copyDepth(const gl::Texture& from, const gl::Texture& to) {
  if (from.id() == 0 || to.id() == 0) return;
  gl::CopyImageSubData(from.id(), from.target, 0, 0, 0, 0, to.id(), to.target, 0, 0, 0, 0,
                       from.width, from.height, 1);
}

void FrameRenderer::Loaded::blit(const gl::Texture& from, const gl::Framebuffer& to) {
  std::string error;
  const gl::Framebuffer source = gl::createFramebuffer({&from}, nullptr, "present", error);
  if (source.id() == 0) return;
  gl::BindFramebuffer(GL_READ_FRAMEBUFFER, source.id());
  gl::BindFramebuffer(GL_DRAW_FRAMEBUFFER, to.id());
  gl::BlitFramebuffer(0, 0, from.width, from.height, 0, 0, to.width, to.height, GL_COLOR_BUFFER_BIT,
                      GL_NEAREST);
  gl::BindFramebuffer(GL_FRAMEBUFFER, to.id());
}

}  // namespace orris
