// The running of `orris view`: a window, a session, and what keys and edited files do to them.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "app/input/common.h"
#include "app/report/report.h"
#include "app/view/file_watch.h"
#include "app/view/view_window.h"
#include "gl/context.h"
#include "render/render_session.h"

namespace orris {

struct ViewOptions {
  PackOptions pack;
  SceneOptions scene;
  ImageOptions image{.frames = 0};  ///< frames 0: until the window is closed
  OutputOptions output;
  std::string screenshot;  ///< written at the end, "" for none
};

class Viewer {
 public:
  explicit Viewer(const ViewOptions& options);
  /// Until the window is closed, the frames are drawn, or the process is interrupted. Returns the
  /// exit status: kProblems when the last reload failed and was not repaired.
  int run();

 private:
  using Clock = std::chrono::steady_clock;

  bool open();
  bool openWindow();
  bool openSession(World world, const Camera& camera);
  std::optional<LoadRequest> readChoices(bool withOptionFile);
  void watchFiles();
  void drawFrame();
  void handle(const ViewInput& input, double seconds);
  void followWindowSize();
  void pollFiles();
  void reload(const std::string& cause, bool withOptionFile);
  void nextProfile();
  void tellReload(bool succeeded);
  void tellGlErrors();
  void showTimes();
  void tellCounters();
  void saveScreenshot(const std::string& path);
  bool ended() const;
  void say(const std::string& line) const;

  ViewOptions options_;
  Report report_;
  int status_ = 0;
  std::string optionFile_;
  std::unique_ptr<gl::Context> context_;
  std::optional<ViewWindow> window_;
  std::unique_ptr<RenderSession> session_;
  std::optional<FileWatch> watch_;
  FlyCamera fly_{Camera{}};
  bool closed_ = false;
  Clock::time_point lastFrame_, lastPoll_, titleSince_;
  int titleFrames_ = 0;
  std::set<int> toldCounters_;  ///< lines of shaders.properties
};

}  // namespace orris
