// The running of `orris view`: a surface, a pack, and what keys, edited files and scripts do to them.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "app/drawing/supervised_run.h"
#include "app/input/common.h"
#include "app/output/report.h"
#include "app/view/apart/shown_window.h"
#include "app/view/files/background_watch.h"
#include "app/view/pack/buffer_inspector.h"
#include "app/view/pack/live_pack.h"
#include "app/view/pack/program_text.h"
#include "app/view/script/script_player.h"
#include "app/view/pack/set_comparison.h"
#include "app/view/surface/view_controls.h"
#include "app/view/surface/view_surface.h"
#include "app/window/panels.h"
#include <orris/gl/context.h>
#include <orris/render/session/render_session.h>

namespace orris {

struct ViewOptions {
  PackOptions pack;
  SceneOptions scene;
  ImageOptions image{.frames = 0};  ///< frames 0: until the window is closed
  OutputOptions output;
  WorkLimits limits;  ///< of a process that draws apart from its window
  std::string screenshot;  ///< written at the end, "" for none
  std::string script;      ///< file of steps, "" for none
};

/// Of the pictures that F2 writes into the working folder.
bool isScreenshotName(const std::string& path);

class Viewer final : public ScriptTarget {
 public:
  explicit Viewer(const ViewOptions& options);
  /// Until the window is closed, the frames are drawn, the script ends, or the process is interrupted.
  /// Returns the exit status: kProblems when the last reload failed and was not repaired, or the script
  /// met a problem.
  int run();

  nlohmann::json state() override;
  std::optional<ScreenItem> item(const std::string& name) override;
  std::string perform(const ScriptStep& step) override;

 private:
  using Clock = std::chrono::steady_clock;
  using Action = std::string (Viewer::*)(const JsonNode&);

  bool readInputs();
  bool readScript();
  /// In a process of its own, apart from the window, where both drivers are software rasterisers; else in this
  /// one.
  int runInWindow();
  /// Between the two: has another process draw when one dies of what its pack has become.
  int keepDrawing(WindowLink& link);
  /// In the process that is shut in.
  int drawApart(WindowLink& link);
  /// In this process, with a window of its own or without one.
  int drawHere(std::unique_ptr<gl::Context> window);
  /// Until it ends(), with a context and a surface.
  int draw();
  bool openPack();
  /// After a process that died: what it could not read.
  void catchUp();
  void noteDrawn(int framesBefore);
  /// From what was last seen before the process died that drew it.
  void goOn(const KeptScene& scene);
  AllowedFiles filesApart() const;
  void drawFrame();
  void drawPicture(double seconds);
  void showPicture();
  /// Those that are open take their part of the events.
  void beginPanels(std::vector<ViewEvent>& events, double seconds);
  void endPanels();
  void apply(const PanelRequests& requests);
  bool panelsShown() const;
  void closePanels();
  bool setWorld(const std::string& name);
  /// At the first error, or there.
  void openEditor();
  void openEditor(const SourceLocation& at);
  /// Opens the text; false: there is none of that name.
  bool showProgram(const std::string& name);
  const ProgramText* shownProgram();
  /// Opens the buffers.
  void show(ShownBuffer shown);
  void toggleBuffers();
  void checkFinite(bool on);
  /// B is the set in force, unless there is a B already.
  bool compare(CompareMode mode);
  void endComparison();
  std::vector<ViewEvent> pollEvents();
  void handle(const ViewInput& input, double seconds);
  void run(ViewCommand command);
  void followWindowSize();
  void followFiles();
  /// Goes on with what was asked of the pack, while frames are drawn.
  void followPack(double passed);
  /// Where every frame counts, as in scripts, what a step asks of the pack is done before the next frame.
  void finishPack();
  void sayOutcome();
  void sayGlErrors();
  void sayCounters();
  void showTimes();
  void saveScreenshot(const std::string& path);
  void saveWindow(const std::string& path);
  /// What is drawn: the pack, or while it is off the host's own programs.
  RenderSession& session() { return plain_ ? *plain_ : pack_->session(); }
  bool setPackOn(bool on);
  bool setCamera(const std::string& name);
  bool hasFixedTime() const { return options_.image.frames > 0 || player_.has_value(); }
  bool ended() const;
  void say(const std::string& line);

  std::string setOptionsStep(const JsonNode& value);
  std::string profileStep(const JsonNode& value);
  std::string liveStep(const JsonNode& value);
  std::string timeStep(const JsonNode& value);
  std::string rainStep(const JsonNode& value);
  std::string thunderStep(const JsonNode& value);
  std::string cameraStep(const JsonNode& value);
  std::string pauseStep(const JsonNode& value);
  std::string packStep(const JsonNode& value);
  std::string resizeStep(const JsonNode& value);
  std::string screenshotStep(const JsonNode& value);
  std::string pictureStep(const JsonNode& value);
  std::string compareStep(const JsonNode& value);
  std::string programStep(const JsonNode& value);
  std::string checkFiniteStep(const JsonNode& value);
  std::string showStep(const JsonNode& value);
  std::string shownStep(const JsonNode& value);
  std::string stateStep(const JsonNode& value);

  ViewOptions options_;
  Report report_;
  int status_ = 0;
  std::unique_ptr<gl::Context> context_;
  std::unique_ptr<ViewSurface> surface_;
  std::optional<World> world_;  ///< until the pack is open
  std::optional<Camera> camera_;
  int watchEvents_ = -1;  ///< for the watch
  std::unique_ptr<LivePack> pack_;
  KeptPack* kept_ = nullptr;  ///< only where the window is another process's
  std::optional<Diagnostic> death_;  ///< of the process that drew before this one
  std::string chosenWorld_;  ///< in the window, "" for the one it began with
  std::unique_ptr<RenderSession> plain_;  ///< only while the pack is off
  std::optional<ScriptPlayer> player_;
  std::optional<BackgroundWatch> watch_;
  ViewControls controls_;
  std::unique_ptr<Interface> interface_;  ///< made when the first panel opens
  PanelState panels_;
  bool building_ = false;  ///< between beginPanels() and endPanels()
  InputTaken taken_;
  PanelRequests requests_;  ///< of this frame
  StepHistory times_;
  std::optional<std::pair<int, int>> pixel_;  ///< that is probed, from the top left
  std::vector<ProbeValue> probe_;
  bool checksFinite_ = false;
  Diagnostics notFinite_;  ///< of the first frame that wrote NaN or Inf since that began, or since the last load
  std::optional<BufferInspector> inspector_;  ///< only while the buffers are open
  std::optional<ProgramText> program_;  ///< only while a program is shown, of this pack
  std::shared_ptr<const ShaderPack> programOf_;
  std::unique_ptr<SetComparison> comparison_;  ///< only while sets are compared
  FlyCamera fly_{Camera{}};
  bool closed_ = false, paused_ = false, fullScreen_ = false;
  int singleFrames_ = 0;  ///< to be drawn although paused
  int framesDrawn_ = 0, glErrors_ = 0;
  Clock::time_point lastFrame_, titleSince_;
  double drawSeconds_ = 0;  ///< of the last frame
  int titleFrames_ = 0;
  std::vector<std::string> worldsBeside_;  ///< the world that is drawn
  std::string said_;          ///< the last line
  std::string windowPicture_;  ///< file for the window as the next frame shows it, "" for none
  std::set<int> saidCounters_;  ///< lines of shaders.properties
};

}  // namespace orris
