// Runs a schedule: programs, targets and scene on the GPU, one frame at a time.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <orris/gl/context.h>
#include <orris/image/image.h>
#include <orris/render/gpu_program.h>
#include <orris/render/inspect/step_clock.h>
#include <orris/render/scene/gpu_scene.h>
#include <orris/render/pack_resources.h>
#include <orris/render/render_targets.h>
#include <orris/render/draw/sampler_binder.h>
#include <orris/render/scene/shadow_volumes.h>

namespace orris {

class EngineGeometry;

/// Linked programs of one GL context, by the text of their stages and the names of the pack's own
/// uniforms: renderers with the same pool build each program once.
using ProgramPool = std::map<std::string, std::shared_ptr<GpuProgram>>;

struct RendererOptions {
  int width = 0, height = 0;
  bool floatScreen = false;  ///< keep values beyond 0..1 on the screen
  bool timings = false;      ///< finish and time every step
  std::shared_ptr<ProgramPool> pool;  ///< none: programs are shared between loads of the renderer alone
};

/// What a (re)load did.
struct LoadReport {
  int programsBuilt = 0, programsReused = 0;
  std::vector<std::string> built;  ///< names, in frame order
  double compileSeconds = 0;
};

/// One of the two textures of a render target; of any other buffer there is only main.
struct BufferSide {
  std::string name;  ///< as dump() takes it
  bool alt = false;
  bool operator==(const BufferSide&) const = default;
};

/// Needs the context it was made with to be current in every call.
class FrameRenderer {
 public:
  FrameRenderer(gl::Context& context, const RendererOptions& options);
  ~FrameRenderer();

  /// Takes a pack for a scene. Programs whose text did not change are kept, and render targets whose
  /// plan did not. On any error nothing changes: the last good pack keeps running.
  bool setPack(std::shared_ptr<const ShaderPack> pack, const SceneData& scene, LoadReport& report,
               Diagnostics& diagnostics);
  /// Builds one program that setPack() of the same pack will need and this renderer has not; false when
  /// none is left. Errors are those of setPack().
  bool buildAhead(const std::shared_ptr<const ShaderPack>& pack, const SceneData& scene,
                  LoadReport& report, Diagnostics& diagnostics);
  void forgetAhead() { ahead_ = {}; }
  /// The value of a live option (ShaderPack::live) from the next frame on; setPack() sets those of the
  /// pack.
  void setLive(const std::string& option, const std::string& value);
  /// Blocks changed: new vertices.
  void updateScene(const SceneData& scene);
  /// Draws what an engine submits in place of the scene's blocks and content; it outlives the renderer.
  void setEngine(EngineGeometry* engine) { engine_ = engine; }
  /// The next setPack() is for another world: its textures are uploaded, too.
  void forgetScene();
  bool resize(int width, int height, Diagnostics& diagnostics);

  /// `lists`: what the frame has besides blocks, sky and clouds.
  void render(const FrameState& state, const DrawLists& lists = {});

  const ShaderPack& pack() const { return *pack_; }
  const std::shared_ptr<const ShaderPack>& sharedPack() const { return pack_; }
  const Schedule& schedule() const { return schedule_; }
  /// Of shadow volumes: faces that the last frame counted apart for the eye, and silhouettes made
  /// since the load; 0 without volumes.
  int facesAtEye() const;
  int silhouetteBuilds() const;
  /// Programs of the schedule that this driver cannot run: the frame lacks what they do.
  std::vector<std::string> programsLeftOut() const;
  /// Depth under the screen centre in the last frame, if a program asked for it.
  float centerDepth() const { return centerDepth_; }
  const std::vector<StepTime>& stepTimes() const { return stepTimes_; }
  /// As RendererOptions::timings, from the next frame on.
  void setTimings(bool timings);
  /// Calls `watcher` after each step of the frames to come, which may read buffers; empty: no call, no cost.
  using StepWatcher = std::function<void(const Step&)>;
  void watchSteps(StepWatcher watcher) { watcher_ = std::move(watcher); }
  /// What a step leaves its results in: draw buffers, then depth, then images that its programs have, which it
  /// may only read. A copy's destination; of the last step "screen".
  std::vector<BufferSide> writesOf(const Step& step) const;
  /// What the samplers of a step's programs read, and images, which they may only write: sides of buffers,
  /// and by their names what else there is ("gtexture", "noisetex").
  std::vector<BufferSide> readsOf(const Step& step) const;
  /// nullptr where the frame has no such buffer.
  const gl::Texture* texture(const BufferSide& side) const;
  /// The side that holds the result of the frame.
  BufferSide finalSide(const std::string& name) const;

  /// The screen, top row first.
  Image8 screenshot() const;
  ImageF screenshotLinear() const;  ///< decoded from sRGB
  /// Any buffer by name (colortexN, shadowcolorN, depthtexN, shadowtexN, a custom image), as it
  /// stands after the last frame, top row first; a 3-D image as its slices from top to bottom.
  std::optional<ImageF> dump(const std::string& name) const;
  /// The same of one side, as it stands.
  std::optional<ImageF> dump(const BufferSide& side) const;
  /// A custom image of whole numbers, all bits of them, bottom row first, slice after slice; empty
  /// where there is none.
  std::vector<std::uint32_t> dumpWords(const std::string& image) const;
  /// Bytes of a bufferObject of the pack; 0 where there is none.
  std::size_t storageBytes(int index) const;
  /// Words of it from a byte on that is a multiple of 4, up to its end.
  std::vector<std::uint32_t> storageWords(int index, std::size_t offset, std::size_t words) const;
  /// Numbers of the pack's bufferObjects.
  std::vector<int> storageNumbers() const;
  /// What dump() takes, separated by blanks.
  std::string bufferNames() const;
  unsigned screenFramebuffer();
  glm::ivec2 size() const { return {options_.width, options_.height}; }

 private:
  struct Loaded;
  /// A program of a pack and the stages that it is linked from, which live in the pack.
  struct Wanted {
    std::string name, key;
    std::vector<const StageText*> stages;
  };
  struct Ahead {
    std::shared_ptr<const ShaderPack> pack;
    std::vector<Wanted> wanted;
    std::size_t next = 0;
    ProgramPool built;  ///< by Wanted::key
  };
  static std::vector<Wanted> wantedPrograms(const ShaderPack& pack, const Schedule& schedule);
  static std::shared_ptr<GpuProgram> buildWanted(const Wanted& wanted, const SourceLines& lines,
                                                 LoadReport& report, Diagnostics& diagnostics);
  void runStep(const Step& step, const FrameState& state);
  /// May programs of the step write images or storage buffers?
  bool storesFromShaders(const Step& step) const;
  /// Notes what is drawn next, for whoever watches over this process.
  void note(std::string_view name, const StageText* stage);
  void drawFullscreen(const Step& step, const FrameState& state);
  void drawGeometry(const Step& step, const FrameState& state);
  glm::mat4 shadowProjectionOf(const FrameState& state) const;
  /// Blocks from the eye to the farthest entity that casts a shadow.
  float entityShadowReach(const FrameState& state) const;
  void drawTerrain(const Step& step, const GpuProgram& program, const FrameState& state,
                   const glm::mat4& view, const glm::mat4& projection, DrawState& draw);
  void drawSky(const Step& step, const GpuProgram& program, const FrameState& state,
               DrawState& draw);
  void drawContent(const Step& step, const GpuProgram& program, const FrameState& state,
                   DrawState& draw);
  void drawEngine(const Step& step, const GpuProgram& program, const FrameState& state,
                  DrawState& draw);
  void setContentMatrices(const Step& step, const FrameState& state, DrawState& draw) const;
  void setDrawIds(const ContentDraw& content, DrawState& draw) const;
  void drawClouds(const Step& step, const GpuProgram& program, const FrameState& state,
                  DrawState& draw);
  void drawShadowVolumes(const Step& step, const FrameState& state);
  void drawLampVolumes(const Step& step, const FrameState& state);
  const gl::Program& useVolumeProgram(const Step& step, const FrameState& state, const glm::mat4& modelView);
  VolumeMethod volumeMethod() const;
  void dispatch(const Step& step, const FrameState& state);
  void present(const Step& step, const FrameState& state);
  void buildMipmaps(const Step& step);
  void shadowMipmaps();
  void sampleCenterDepth();
  void useProgram(const GpuProgram& program, const Step& step, const FrameState& state,
                  const DrawState& draw);
  const GpuProgram& programOf(const Step& step) const;
  /// Of the pack: what is drawn with, or its computes.
  std::vector<const GpuProgram*> programsOf(const Step& step) const;

  gl::Context& context_;
  EngineGeometry* engine_ = nullptr;
  RendererOptions options_;
  gl::Handle<gl::deleteVertexArray> vertexArray_;  ///< of a core context, which draws with none
  std::shared_ptr<const ShaderPack> pack_;
  Schedule schedule_;
  std::unique_ptr<Loaded> loaded_;
  Ahead ahead_;
  bool firstFrame_ = true;
  bool stored_ = false;  ///< shaders of the last step did, and nothing has waited for it
  int framesOfPack_ = 0;  ///< drawn since setPack()
  float centerDepth_ = 1;
  const DrawLists* lists_ = nullptr;  ///< of the frame that is drawn
  std::optional<StepClock> clock_;  ///< made when steps are first timed
  std::vector<StepTime> stepTimes_;
  StepWatcher watcher_;
};

}  // namespace orris
