// A world rendered by a pack over time: events, option changes and reloads. This is what `orris
// render` and `orris view` run, and what an engine of its own embeds.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <orris/plan/schedule/auto_choices.h>
#include <orris/render/session/background_load.h>
#include <orris/render/scene/engine_geometry.h>
#include <orris/render/frame_renderer.h>

namespace orris {

/// Opens the pack's files anew for each (re)load; nullptr and diagnostics when it cannot.
using PackOpener = std::function<std::shared_ptr<const FileSource>(Diagnostics&)>;

struct SessionRequest {
  PackOpener openPack;
  LoadRequest load;       ///< options, profile, dimension; the environment is filled in
  HostVersions versions;  ///< that the environment states
  RendererOptions renderer;
  Camera camera;
  /// Draws in place of the world's blocks and content, of which there are none then; outlives the session.
  EngineGeometry* engine = nullptr;
  std::optional<int> time;  ///< overrides the world's
  unsigned seed = 0;
  /// frameCounter of the first frame. Packs take their random numbers from it: two sessions whose frames
  /// do not overlap share none.
  int firstFrame = 0;
  float frameTime = 1.0f / 60;  ///< fixed, for equal bytes on every run
};

/// A (re)load that happened before a frame.
struct SessionReload {
  int frame = 0;
  std::string cause;  ///< "start", "event: GI_METHOD=NONE", "files changed"
  bool succeeded = false;
  LoadReport report;
};

/// What an engine knows of a moment besides Environment.
struct EngineMoment {
  struct Selected {
    BlockState block;
    glm::dvec3 middle{0};  ///< of the block, in the world
  };
  std::optional<Selected> selected;
  std::optional<glm::dvec3> lightning;  ///< where a bolt strikes
};

class RenderSession {
 public:
  /// nullptr when the pack cannot be rendered; see diagnostics.
  static std::unique_ptr<RenderSession> create(gl::Context& context, SessionRequest request,
                                               World world, Diagnostics& diagnostics);

  /// Applies the events of the next frame and draws it.
  void renderFrame(Diagnostics& diagnostics);

  /// Loads the pack again from its files. false: the last good one keeps running.
  bool reload(const std::string& cause, Diagnostics& diagnostics);
  /// The same files under other values: only the programs that the option reaches are built again.
  bool setOption(const std::string& name, const std::string& value, Diagnostics& diagnostics);
  bool setProfile(const std::string& name, Diagnostics& diagnostics);
  /// Begins to take what `load` makes of a copy of loadRequest(), while frames go on: the pack that runs
  /// stays until advance() ends the change. One at a time; the functions above wait for it.
  void begin(const std::string& cause, PackLoader load);
  /// Between frames: waits for the load for so many seconds at most; once it is there, builds programs for
  /// about as many, at least one.
  /// How the change ended, nullopt while it goes on and when there is none.
  std::optional<bool> advance(double seconds, Diagnostics& diagnostics);
  /// The same without frames in between.
  std::optional<bool> finish(Diagnostics& diagnostics);
  /// The same pack in another world; false: the old one stays.
  bool setWorld(World world, const Camera& camera, Diagnostics& diagnostics);
  /// The next frame is of the same moment as the next one of `other`, which draws a copy of the same world,
  /// and is seen by the same camera.
  void follow(const RenderSession& other);
  void setCamera(const Camera& camera) { request_.camera = camera; }
  /// An engine's own, in place of what the camera's angles and the world's blocks give; nullopt: those.
  void setMatrices(const std::optional<ViewMatrices>& matrices) { matrices_ = matrices; }
  void setMoment(const EngineMoment& moment) { moment_ = moment; }
  void setSurroundings(const std::optional<EyeSurroundings>& eye) { surroundings_ = eye; }
  Environment& environment() { return scene_.world.environment; }
  void setTime(int time) { scene_.world.environment.time = time; }
  void setFrameTime(float seconds) { request_.frameTime = seconds; }
  LoadRequest& loadRequest() { return request_.load; }

  const Camera& camera() const { return request_.camera; }
  int frame() const { return frame_; }  ///< frames drawn so far
  FrameRenderer& renderer() { return *renderer_; }
  const SceneData& scene() const { return scene_; }
  /// The pack as it was asked for, AUTO where an option is AUTO.
  const ShaderPack& asked() const { return *asked_; }
  const std::shared_ptr<const ShaderPack>& sharedAsked() const { return asked_; }
  const std::vector<SessionReload>& reloads() const { return reloads_; }
  /// What was chosen for options that are AUTO; chosen again at each load, and when the scene has
  /// changed by much.
  const AutoChoices& autoChoices() const { return auto_; }

 private:
  RenderSession(SessionRequest request, SceneData scene);
  std::shared_ptr<const ShaderPack> loadPack(Diagnostics& diagnostics);
  std::shared_ptr<const ShaderPack> rebuildPack(Diagnostics& diagnostics);
  bool use(const std::string& cause, std::shared_ptr<const ShaderPack> asked,
           Diagnostics& diagnostics);
  bool take(const std::string& cause, std::shared_ptr<const ShaderPack> pack,
            Diagnostics& diagnostics, LoadReport report = {});
  bool takeLoaded();
  void loadSettled();
  bool endChange(bool good, Diagnostics& diagnostics);
  void waitForChange(Diagnostics& diagnostics);
  SceneMeter meterFor(const ShaderPack& asked) const;
  /// The pack with values chosen for options that are AUTO.
  std::shared_ptr<const ShaderPack> settle(std::shared_ptr<const ShaderPack> asked,
                                           Diagnostics& diagnostics);
  void chooseAgain(Diagnostics& diagnostics);
  bool sceneChanged() const;
  FrameInput frameInput() const;
  void applyEvents(Diagnostics& diagnostics);
  void rebuildScene(Diagnostics& diagnostics);
  void changeEntity(const ChangeEntity& change);
  /// The steps for what the scene has, where they are not those that it had.
  void followContents(const std::string& cause, Diagnostics& diagnostics);
  /// What of the frame depends on both the pack and the content.
  void setContentIds(FrameState& state) const;
  EngineMoment moment() const;
  void followWorld(Diagnostics& diagnostics);

  /// First its pack is loaded as it was asked for, then with what AUTO becomes, then programs are built.
  struct Change {
    std::string cause;
    std::optional<BackgroundLoad> load;
    std::shared_ptr<const ShaderPack> asked, pack;
    LoadRequest request;
    AutoChoices choices;
    LoadReport report;
    Diagnostics problems;
  };

  SessionRequest request_;
  SceneData scene_;
  std::unique_ptr<Change> change_;
  std::optional<bool> ended_;  ///< a change that something else waited for, until advance() says so
  std::unique_ptr<FrameRenderer> renderer_;
  std::optional<FrameState> state_;
  std::optional<ViewMatrices> matrices_;
  std::optional<EyeSurroundings> surroundings_;
  EngineMoment moment_;
  std::vector<SessionReload> reloads_;
  AutoChoices auto_;
  /// What was asked for, and the scene for which `auto_` was chosen.
  std::shared_ptr<const ShaderPack> asked_;
  struct {
    int frame = 0, time = 0;
    glm::dvec3 eye{0};
    bool blocksChanged = false;  ///< since
  } chosenFor_;
  size_t nextEvent_ = 0;
  GeometrySet weather_ = 0;  ///< of the frame before
  int frame_ = 0;
};

/// Environment macros for the driver of a context.
MacroDefinitions environmentFor(const gl::DriverInfo& driver, const HostVersions& versions = {});

}  // namespace orris
