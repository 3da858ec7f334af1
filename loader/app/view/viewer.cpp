#include "app/view/viewer.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <thread>
#include <utility>

#include "app/input/inputs.h"
#include "app/input/world_shelf.h"
#include <orris/core/work_record.h>
#include <orris/gl/functions.h>
#include <orris/render/inspect/counters.h>
#include <orris/render/inspect/finite_check.h>

namespace orris {
namespace {

namespace fs = std::filesystem;

constexpr auto kTitleInterval = std::chrono::milliseconds(500);
// A driver that does not wait for the screen must not draw thousands of frames a second.
constexpr auto kShortestFrame = std::chrono::milliseconds(4);
// A frame that took longer, for a reload, moves the camera and the clock no further than this.
constexpr double kLongestStep = 0.1;
constexpr double kFixedStep = 1.0 / 60;

// The others show what the process that died had read.
constexpr bool PanelState::* kKeptPanels[] = {&PanelState::help, &PanelState::options, &PanelState::scene,
                                              &PanelState::passes};

volatile std::sig_atomic_t viewInterrupted = 0;
void onInterrupt(int) { viewInterrupted = 1; }

double secondsBetween(std::chrono::steady_clock::time_point from,
                      std::chrono::steady_clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

// What of a pack can change its picture: all of a zip, and `shaders` of a folder.
fs::path watchedPart(const std::string& packPath) {
  const fs::path shaders = fs::path(packPath) / "shaders";
  return fs::is_directory(shaders) ? shaders : fs::path(packPath);
}

}  // namespace

Viewer::Viewer(const ViewOptions& options) : options_(options), report_(options.output) {}

int Viewer::run() {
  if (!readInputs()) return report_.status();
  const gl::Backend backend = options_.image.backend;
  const bool window = backend == gl::Backend::Auto || backend == gl::Backend::Glfw;
  return window ? runInWindow() : drawHere(nullptr);
}

int Viewer::draw() {
  if (!openPack()) return report_.status();
  std::signal(SIGINT, onInterrupt);
  std::signal(SIGTERM, onInterrupt);
  while (!ended()) drawFrame();
  sayCounters();
  if (!options_.screenshot.empty()) saveScreenshot(options_.screenshot);
  return status_;
}

bool Viewer::ended() const {
  const int frames = options_.image.frames;
  return closed_ || viewInterrupted != 0 || (player_ && player_->ended()) ||
         (frames > 0 && !player_ && framesDrawn_ >= frames);
}

bool Viewer::readScript() {
  if (options_.script.empty()) return true;
  auto text = readWholeFile(options_.script, report_);
  if (!text) return false;
  Diagnostics diagnostics;
  auto script = parseViewScript(options_.script, std::move(*text), diagnostics);
  report_.add(diagnostics);
  if (!script) return false;
  player_.emplace(std::move(*script));
  return true;
}

bool Viewer::readInputs() {
  if (!readScript() || !openPackFiles(options_.pack.path, report_)) return false;
  world_ = loadScene(options_.scene, options_.pack.dimension, report_);
  if (!world_) return false;
  camera_ = chooseCamera(*world_, options_.scene.camera, report_);
  if (!camera_) return false;
  const std::string& screenshot = options_.screenshot;
  if (!screenshot.empty() && !checkPicturePath(screenshot, report_)) return false;
  worldsBeside_ = worldsBeside(options_.scene.path);
  return true;
}

bool Viewer::openPack() {
  pack_ = std::make_unique<LivePack>(options_.pack, *context_, report_);
  if (watchEvents_ < 0) watchEvents_ = BackgroundWatch::openEvents();
  // Before anything is read: an edit during loading is then seen afterwards.
  watch_.emplace(std::vector<fs::path>{watchedPart(options_.pack.path), pack_->optionFile()}, watchEvents_);
  lastFrame_ = titleSince_ = Clock::now();
  const auto kept = death_ ? kept_->state() : std::nullopt;
  if (!pack_->open(options_.scene, options_.image, std::move(*world_), *camera_, kept)) return false;
  if (death_) pack_->noteDeath(*death_);
  world_.reset();
  if (kept) goOn(kept->scene);
  // A script is no person, who may want a world again.
  if (!player_) noteRecentWorld(options_.scene.path);
  return true;
}

std::vector<ViewEvent> Viewer::pollEvents() {
  std::vector<ViewEvent> events = surface_->poll();
  if (!player_) return events;
  Diagnostics diagnostics;
  for (const ViewEvent& event : player_->advance(*this, diagnostics)) events.push_back(event);
  if (hasErrors(diagnostics) && status_ == kClean) status_ = kProblems;
  report_.add(diagnostics);
  return events;
}

// Whoever mends what the driver died of may have done so before anybody watched the files again.
void Viewer::catchUp() {
  status_ = kProblems;
  panels_.problems = true;
  say("taken back: the last good pack draws again");
  const fs::path part = watchedPart(options_.pack.path);
  const auto isNew = [&](const fs::path& path) {
    std::error_code missing;
    const auto time = fs::last_write_time(path, missing);
    return !missing && time > kept_->riskSince();
  };
  bool changed = isNew(part) || isNew(pack_->optionFile());
  std::error_code error;
  for (fs::recursive_directory_iterator it(part, error), end; !changed && !error && it != end; it.increment(error))
    changed = isNew(it->path());
  if (changed) pack_->reload("files changed", true);
}

// What has come as far as the window is a picture that the driver has finished.
void Viewer::noteDrawn(int framesBefore) {
  if (!kept_ || plain_ || framesDrawn_ == framesBefore) return;
  RenderSession& session = pack_->session();
  const Environment& seen = session.environment();
  KeptScene scene{.world = chosenWorld_,
                  .camera = session.camera(),
                  .time = seen.time,
                  .rain = seen.rain,
                  .thunder = seen.thunder};
  for (std::size_t i = 0; i < std::size(kKeptPanels); ++i) scene.panels |= unsigned(panels_.*kKeptPanels[i]) << i;
  kept_->drew(session.sharedAsked(), scene);
  kept_->setAtRisk(!pack_->doing().empty());
}

void Viewer::goOn(const KeptScene& scene) {
  if (!scene.world.empty()) setWorld(scene.world);
  RenderSession& session = pack_->session();
  session.setCamera(scene.camera);
  session.environment().time = scene.time;
  session.environment().rain = scene.rain;
  session.environment().thunder = scene.thunder;
  for (std::size_t i = 0; i < std::size(kKeptPanels); ++i) panels_.*kKeptPanels[i] = ((scene.panels >> i) & 1) != 0;
}

void Viewer::drawFrame() {
  const Clock::time_point now = Clock::now();
  const double passed = secondsBetween(lastFrame_, now);
  // A script or a given number of frames is a recording: every frame takes the same time.
  const double seconds = hasFixedTime() ? kFixedStep : std::min(passed, kLongestStep);
  lastFrame_ = now;
  const bool held = controls_.holdsMouse();
  std::vector<ViewEvent> events = pollEvents();
  beginPanels(events, seconds);
  handle(controls_.take(events, taken_), seconds);
  if (controls_.holdsMouse() != held) surface_->holdMouse(!held);
  followFiles();
  followPack(passed);
  followWindowSize();
  const Clock::time_point began = Clock::now();
  const int framesBefore = framesDrawn_;
  drawPicture(seconds);
  showPicture();
  noteDrawn(framesBefore);
  drawSeconds_ = secondsBetween(began, Clock::now());
  sayGlErrors();
  showTimes();
  noteIdle();
  if (!hasFixedTime() || player_) std::this_thread::sleep_until(now + kShortestFrame);
}

void Viewer::drawPicture(double seconds) {
  if (paused_ && singleFrames_ == 0 && session().frame() > 0) return;
  singleFrames_ = std::max(singleFrames_ - 1, 0);
  // Single frames are there to be compared.
  session().setFrameTime(float(paused_ ? kFixedStep : seconds));
  FrameRenderer& renderer = session().renderer();
  renderer.setTimings(panels_.passes);
  std::optional<PixelProbe> probe;
  if (panels_.passes && pixel_) {
    probe.emplace(renderer, pixel_->first, pixel_->second);
  }
  std::optional<FiniteCheck> finite;
  if (checksFinite_ && notFinite_.empty()) finite.emplace(renderer);
  if (probe || finite || inspector_)
    renderer.watchSteps([&](const Step& step) {
      if (probe) probe->after(step);
      if (finite) finite->after(step, session().frame());
      if (inspector_) inspector_->after(renderer, step);
    });
  Diagnostics diagnostics;
  if (comparison_) comparison_->drawOther(session(), diagnostics);
  session().renderFrame(diagnostics);
  if (comparison_) comparison_->endFrame(renderer);
  report_.add(diagnostics);
  if (panels_.passes) times_.add(renderer.schedule(), renderer.stepTimes());
  if (probe || finite || inspector_) renderer.watchSteps({});
  if (probe) probe_ = probe->values();
  if (finite) notFinite_ = finite->findings();
  if (inspector_) inspector_->endFrame(renderer);
  if (++framesDrawn_ != 1) return;
  if (death_) return catchUp();
  const std::string chosen = session().autoChoices().text();
  say(chosen.empty() ? "ready" : "ready; AUTO took " + chosen);
}

void Viewer::showPicture() {
  FrameRenderer& renderer = session().renderer();
  int width = 0, height = 0;
  surface_->size(width, height);
  gl::Disable(GL_SCISSOR_TEST);
  if (comparison_) {
    comparison_->show(renderer, *surface_);
  } else {
    gl::BlitNamedFramebuffer(renderer.screenFramebuffer(), surface_->framebuffer(), 0, 0,
                             renderer.schedule().width, renderer.schedule().height, 0, 0, width,
                             height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  }
  endPanels();
  if (!windowPicture_.empty()) saveWindow(std::exchange(windowPicture_, ""));
  surface_->show();
  apply(std::exchange(requests_, {}));
}

void Viewer::handle(const ViewInput& input, double seconds) {
  const std::vector<Camera>& cameras = session().scene().world.cameras;
  // The session's camera also moves by the world's events.
  fly_.set(session().camera());
  if (input.camera >= 0 && input.camera < int(cameras.size())) fly_.set(cameras[input.camera]);
  fly_.scroll(input.scroll);
  fly_.look(input.lookX, input.lookY);
  fly_.move(input.keys, seconds);
  session().setCamera(fly_.camera());
  closed_ |= input.close;
  for (const ViewCommand command : input.commands) run(command);
}

void Viewer::followWindowSize() {
  int width = 0, height = 0;
  surface_->size(width, height);
  FrameRenderer& renderer = session().renderer();
  const Schedule& schedule = renderer.schedule();
  const bool same = width == schedule.width && height == schedule.height;
  if (width <= 0 || height <= 0 || same) return;
  Diagnostics diagnostics;
  renderer.resize(width, height, diagnostics);
  report_.add(diagnostics);
  singleFrames_ = std::max(singleFrames_, 1);  // a pause has no picture of this size
}

void Viewer::followFiles() {
  const std::vector<std::string> changed = watch_->take();
  if (changed.empty()) return;
  std::vector<std::string> names;
  for (const std::string& path : changed) names.push_back(fs::path(path).filename().string());
  pack_->reload(fmt::format("{} changed", fmt::join(names, ", ")), true);
}

// Building may take as long as drawing does: the picture goes on at half the pace at worst.
void Viewer::followPack(double passed) {
  if (kept_ && !pack_->doing().empty()) kept_->setAtRisk(true);
  if (pack_->advance(drawSeconds_, passed)) sayOutcome();
}

void Viewer::finishPack() {
  if (!hasFixedTime()) return;
  while (pack_->finish()) sayOutcome();
}

void Viewer::showTimes() {
  ++titleFrames_;
  const Clock::time_point now = Clock::now();
  if (now - titleSince_ < kTitleInterval) return;
  sayCounters();
  const double milliseconds = secondsBetween(titleSince_, now) * 1000 / titleFrames_;
  const ShaderPack& pack = pack_->session().renderer().pack();
  const std::string profile = pack.currentProfile();
  const std::string shown = plain_ ? "pack off" : profile.empty() ? "custom" : profile;
  surface_->setTitle(fmt::format("Orris - {} - {} - {:.1f} ms/frame{}", pack.name, shown,
                                 milliseconds, paused_ ? " - paused" : ""));
  titleSince_ = now;
  titleFrames_ = 0;
}

}  // namespace orris
