#include "app/view/viewer.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <thread>
#include <utility>

#include "app/input/inputs.h"
#include "core/read_file.h"
#include "render/counters.h"
#include "image/image.h"

namespace orris {
namespace {

namespace fs = std::filesystem;

constexpr auto kPollInterval = std::chrono::milliseconds(100);
constexpr auto kTitleInterval = std::chrono::milliseconds(500);
// A driver that does not wait for the screen must not draw thousands of frames a second.
constexpr auto kShortestFrame = std::chrono::milliseconds(4);
// A frame that took longer, for a reload, moves the camera and the clock no further than this.
constexpr double kLongestStep = 0.1;

volatile std::sig_atomic_t viewInterrupted = 0;
void onInterrupt(int) { viewInterrupted = 1; }

double secondsBetween(std::chrono::steady_clock::time_point from,
                      std::chrono::steady_clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

fs::path withoutEndSlash(const fs::path& path) {
  return path.has_filename() ? path : path.parent_path();
}

// A pack's own option file lies beside it and is named like it.
std::string optionFileOf(const PackOptions& options) {
  if (!options.settingsFile.empty()) return options.settingsFile;
  return withoutEndSlash(options.path).string() + ".txt";
}

// What of a pack can change its picture: all of a zip, and `shaders` of a folder.
fs::path watchedPart(const std::string& packPath) {
  const fs::path shaders = fs::path(packPath) / "shaders";
  return fs::is_directory(shaders) ? shaders : fs::path(packPath);
}

std::string freeScreenshotName() {
  for (int i = 1;; ++i) {
    std::string name = fmt::format("orris-{:04}.png", i);
    if (!fs::exists(name)) return name;
  }
}

}  // namespace

Viewer::Viewer(const ViewOptions& options)
    : options_(options), report_(options.output), optionFile_(optionFileOf(options.pack)) {}

int Viewer::run() {
  if (!open()) return status_;
  std::signal(SIGINT, onInterrupt);
  std::signal(SIGTERM, onInterrupt);
  while (!ended()) drawFrame();
  tellCounters();
  if (!options_.screenshot.empty()) saveScreenshot(options_.screenshot);
  return status_;
}

bool Viewer::ended() const {
  const int frames = options_.image.frames;
  return closed_ || viewInterrupted != 0 || (frames > 0 && session_->frame() >= frames);
}

bool Viewer::open() {
  if (!openPackFiles(options_.pack.path, report_, status_)) return false;
  std::optional<World> world = loadScene(options_.scene, options_.pack.dimension, report_, status_);
  if (!world) return false;
  const std::optional<Camera> camera =
      chooseCamera(*world, options_.scene.camera, report_, status_);
  if (!camera) return false;
  const std::string& screenshot = options_.screenshot;
  if (!screenshot.empty() && !checkPicturePath(screenshot, report_, status_)) return false;
  return openWindow() && openSession(std::move(*world), *camera);
}

bool Viewer::openWindow() {
  Diagnostics diagnostics;
  context_ = gl::createContext({.backend = gl::Backend::Glfw,
                                .profile = options_.image.context,
                                .width = options_.image.width,
                                .height = options_.image.height,
                                .title = "Orris"},
                               diagnostics);
  report_.add(diagnostics);
  if (!context_) {
    status_ = kHostFailed;
    return false;
  }
  window_.emplace(context_->window());
  window_->setRefreshWait(options_.image.frames == 0);
  return true;
}

bool Viewer::openSession(World world, const Camera& camera) {
  watchFiles();
  const auto load = readChoices(true);
  if (!load) return false;
  SessionRequest request;
  request.openPack = [path = options_.pack.path](Diagnostics& diagnostics) {
    return std::shared_ptr<const FileSource>(openPack(path, diagnostics));
  };
  request.load = *load;
  request.versions = options_.pack.versions;
  if (options_.pack.dimension.empty()) request.load.dimension = world.environment.dimension;
  request.renderer = {.width = options_.image.width, .height = options_.image.height};
  request.camera = camera;
  request.seed = options_.scene.seed;
  Diagnostics diagnostics;
  session_ = RenderSession::create(*context_, std::move(request), std::move(world), diagnostics);
  report_.add(diagnostics);
  if (!session_) {
    const auto files = openPackFiles(options_.pack.path, report_, status_);
    status_ = files ? loadFailureStatus(files, *load) : kUsage;
  }
  lastFrame_ = lastPoll_ = titleSince_ = Clock::now();
  return session_ != nullptr;
}

// The command line's choices with those of the option file as it is now; a pack need not have one.
std::optional<LoadRequest> Viewer::readChoices(bool withOptionFile) {
  PackOptions pack = options_.pack;
  // Beside a pack lies what came with it: a link there may not lead out of the folder.
  const fs::path folder = fs::absolute(optionFile_).parent_path();
  const bool wanted = withOptionFile && (!pack.settingsFile.empty() || liesBelow(folder, optionFile_));
  pack.settingsFile = wanted ? optionFile_ : "";
  const auto files = openPackFiles(pack.path, report_, status_);
  if (!files) return std::nullopt;
  const MacroDefinitions environment = environmentFor(context_->driver(), options_.pack.versions);
  auto request = makeLoadRequest(files, pack, environment, report_, status_);
  if (request) request->name = withoutEndSlash(pack.path).filename().string();
  return request;
}

// Before anything is read: an edit during loading is then seen afterwards.
void Viewer::watchFiles() {
  watch_.emplace(std::vector<fs::path>{watchedPart(options_.pack.path), optionFile_});
}

void Viewer::drawFrame() {
  const Clock::time_point now = Clock::now();
  const double seconds = std::min(secondsBetween(lastFrame_, now), kLongestStep);
  lastFrame_ = now;
  handle(window_->poll(), seconds);
  pollFiles();
  followWindowSize();
  // A given number of frames is a recording: every frame takes the same time.
  if (options_.image.frames == 0) session_->setFrameTime(float(seconds));
  Diagnostics diagnostics;
  session_->renderFrame(diagnostics);
  report_.add(diagnostics);
  FrameRenderer& renderer = session_->renderer();
  const Schedule& schedule = renderer.schedule();
  window_->show(renderer.screenFramebuffer(), schedule.width, schedule.height);
  tellGlErrors();
  if (session_->frame() == 1) {
    const std::string chosen = session_->autoChoices().text();
    say(chosen.empty() ? "ready" : "ready; AUTO took " + chosen);
  }
  showTimes();
  if (options_.image.frames == 0) std::this_thread::sleep_until(now + kShortestFrame);
}

void Viewer::handle(const ViewInput& input, double seconds) {
  const std::vector<Camera>& cameras = session_->scene().world.cameras;
  // The session's camera also moves by the world's events.
  fly_.set(session_->camera());
  if (input.camera >= 0 && input.camera < int(cameras.size())) fly_.set(cameras[input.camera]);
  fly_.scroll(input.scroll);
  fly_.look(input.lookX, input.lookY);
  fly_.move(input.keys, seconds);
  session_->setCamera(fly_.camera());
  closed_ |= input.close;
  if (input.reload) reload("R pressed", true);
  if (input.nextProfile) nextProfile();
  if (input.screenshot) saveScreenshot(freeScreenshotName());
}

void Viewer::followWindowSize() {
  int width = 0, height = 0;
  window_->size(width, height);
  const Schedule& schedule = session_->renderer().schedule();
  const bool same = width == schedule.width && height == schedule.height;
  if (width <= 0 || height <= 0 || same) return;
  Diagnostics diagnostics;
  session_->renderer().resize(width, height, diagnostics);
  report_.add(diagnostics);
}

void Viewer::pollFiles() {
  const Clock::time_point now = Clock::now();
  if (now - lastPoll_ < kPollInterval) return;
  lastPoll_ = now;
  const std::vector<std::string> changed = watch_->poll();
  if (changed.empty()) return;
  std::vector<std::string> names;
  for (const std::string& path : changed) names.push_back(fs::path(path).filename().string());
  reload(fmt::format("{} changed", fmt::join(names, ", ")), true);
}

void Viewer::reload(const std::string& cause, bool withOptionFile) {
  report_.beginAgain();
  LoadRequest& request = session_->loadRequest();
  const auto choices = readChoices(withOptionFile);
  bool succeeded = false;
  if (choices) {
    const OptionValues before = std::exchange(request.fileValues, choices->fileValues);
    Diagnostics diagnostics;
    succeeded = session_->reload(cause, diagnostics);
    report_.add(diagnostics);
    if (!succeeded) request.fileValues = before;
  }
  tellReload(succeeded);
}

// A profile chosen by key counts more than an option file written before.
void Viewer::nextProfile() {
  const ShaderPack& pack = session_->renderer().pack();
  const std::vector<Profile>& profiles = pack.properties.profiles;
  if (profiles.empty()) return say("this pack has no profiles");
  LoadRequest& request = session_->loadRequest();
  const std::string current = pack.currentProfile();
  const auto at = std::find_if(profiles.begin(), profiles.end(),
                               [&](const Profile& profile) { return profile.name == current; });
  const bool last = at == profiles.end() || at + 1 == profiles.end();
  const std::string before = request.profile;
  request.profile = last ? profiles.front().name : (at + 1)->name;
  reload("profile " + request.profile, false);
  if (!session_->reloads().back().succeeded) request.profile = before;
}

void Viewer::tellReload(bool succeeded) {
  status_ = succeeded ? kClean : kProblems;
  if (!succeeded) return say("not reloaded: the last good pack keeps running");
  const SessionReload& last = session_->reloads().back();
  say(fmt::format("reloaded ({}): {} programs built{}{}, {} kept", last.cause,
                  last.report.programsBuilt, last.report.built.empty() ? "" : ": ",
                  fmt::join(last.report.built, ", "), last.report.programsReused));
}

void Viewer::tellGlErrors() {
  for (const std::string& text : context_->takeErrors()) {
    report_.error("gl-error", "the GL driver reports: " + text);
    status_ = kHostFailed;
  }
}

// Each once, however the number changes.
void Viewer::tellCounters() {
  for (Diagnostic& diagnostic : counterWarnings(session_->renderer())) {
    if (!toldCounters_.insert(diagnostic.at.line).second) continue;
    Diagnostics one{std::move(diagnostic)};
    report_.add(one);
  }
}

void Viewer::showTimes() {
  ++titleFrames_;
  const Clock::time_point now = Clock::now();
  if (now - titleSince_ < kTitleInterval) return;
  tellCounters();
  const double milliseconds = secondsBetween(titleSince_, now) * 1000 / titleFrames_;
  const ShaderPack& pack = session_->renderer().pack();
  const std::string profile = pack.currentProfile();
  window_->setTitle(fmt::format("Orris - {} - {} - {:.1f} ms/frame", pack.name,
                                profile.empty() ? "custom" : profile, milliseconds));
  titleSince_ = now;
  titleFrames_ = 0;
}

void Viewer::saveScreenshot(const std::string& path) {
  if (session_->frame() == 0) return;
  Diagnostics diagnostics;
  FrameRenderer& renderer = session_->renderer();
  const bool linear = !path.ends_with(".png");
  const bool written = linear ? writeImage(path, renderer.screenshotLinear(), diagnostics)
                              : writeImage(path, renderer.screenshot(), diagnostics);
  report_.add(diagnostics);
  if (written) return say("screenshot: " + path);
  status_ = kUsage;
}

void Viewer::say(const std::string& line) const {
  if (!options_.output.quiet) printText(line + "\n");
}

}  // namespace orris
