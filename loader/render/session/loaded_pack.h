// Everything a FrameRenderer holds on the GPU for one pack, scene and size.
#pragma once

#include <map>
#include <memory>
#include <utility>

#include <orris/render/frame_renderer.h>
#include <orris/render/scene/lamp_volumes.h>

namespace orris {

/// Programs are shared between loads by the hash of their text, so a reload builds only what changed.
struct FrameRenderer::Loaded {
  Loaded(const ShaderPack& pack, const Schedule& schedule, const SceneData& scene,
         const RendererOptions& options, Loaded* previous, const ProgramPool& ahead,
         LoadReport& report, Diagnostics& diagnostics);
  void resize(const ShaderPack& pack, const Schedule& schedule, Diagnostics& diagnostics);
  void makeBinder(const PackDirectives& directives);
  /// Nothing of the scene serves another load.
  void forgetScene() { blockIds_ = {kNoScene}; }
  void copyDepth(const gl::Texture& from, const gl::Texture& to);
  void blit(const gl::Texture& from, const gl::Framebuffer& to);

  SceneContents contents;
  std::map<int, std::shared_ptr<GpuProgram>> programs;                  ///< by pack program index
  std::map<std::pair<int, int>, std::shared_ptr<GpuProgram>> computes;  ///< program, compute
  std::map<std::string, std::shared_ptr<GpuProgram>> byText;            ///< cache key -> program
  std::map<const GpuProgram*, std::uint32_t> outputs;  ///< of its fragment stage, outputsOf()
  std::shared_ptr<GpuProgram> builtinTerrain, builtinSky;
  std::shared_ptr<RenderTargets> targets;
  std::shared_ptr<GpuScene> scene;
  std::unique_ptr<PackResources> resources;
  std::unique_ptr<ShadowVolumes> volumes;  ///< only where the schedule has them
  std::unique_ptr<LampVolumes> lampVolumes;
  gl::Texture noise;
  CustomUniforms custom;
  std::unique_ptr<SamplerBinder> binder;
  bool freshTargets = false;       ///< targets were made by this load and hold nothing yet

 private:
  /// Where programs are that need not be built again.
  struct Known {
    Loaded* previous;
    const ProgramPool& ahead;
  };
  void buildPrograms(const ShaderPack& pack, const Schedule& schedule, const Known& known,
                     LoadReport& report, Diagnostics& diagnostics);
  std::shared_ptr<GpuProgram> program(const Wanted& wanted, const SourceLines& lines,
                                      const Known& known, LoadReport& report,
                                      Diagnostics& diagnostics);
  static constexpr int kNoScene = -2;  ///< no block has this id
  const RendererOptions& options_;
  Schedule plan_;  ///< what `targets` was made for
  std::vector<int> blockIds_;
  VertexStyle style_;
};

/// The file of the pack that the stage begins in, "" for a built-in one.
std::string_view entryFileOf(const StageText& stage);

/// Contract constants.csv workGroups and workGroupsRender.
std::array<unsigned, 3> groupCounts(const ComputeSource& compute, const std::vector<int>& localSize,
                                    const glm::vec2& size);

}  // namespace orris
