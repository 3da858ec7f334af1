// The panels over the picture, and what the user asks for in them.
#include <fmt/format.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cstdlib>

#include "app/input/shipped_worlds.h"
#include "app/input/world_shelf.h"
#include "app/view/viewer.h"

namespace orris {

bool Viewer::panelsShown() const {
  const bool problems = panels_.problems && !pack_->outcome().succeeded;
  return panels_.help || panels_.options || panels_.scene || panels_.passes ||
         panels_.buffers || panels_.compare || panels_.program || problems;
}

void Viewer::closePanels() {
  panels_.help = panels_.options = panels_.scene = panels_.passes = panels_.buffers =
      panels_.compare = panels_.program = panels_.problems = false;
}

void Viewer::beginPanels(std::vector<ViewEvent>& events, double seconds) {
  taken_ = {};
  building_ = panelsShown();
  if (!building_) return;
  if (!interface_) interface_ = std::make_unique<Interface>(surface_->scale());
  building_ = interface_->usable();
  if (!building_) return;
  int width = 0, height = 0;
  surface_->size(width, height);
  interface_->begin(events, width, height, seconds);
  taken_ = interface_->taken();
  const auto isEscape = [](const ViewEvent& event) {
    return event.kind == ViewEvent::Kind::Key && event.code == GLFW_KEY_ESCAPE && event.pressed;
  };
  if (!controls_.holdsMouse() && std::erase_if(events, isEscape) > 0) closePanels();
  if (!panels_.passes || taken_.mouse || controls_.holdsMouse()) return;
  // With the passes open a click on the picture is for its pixel.
  for (const ViewEvent& event : events) {
    if (event.kind != ViewEvent::Kind::Button || !event.pressed) continue;
    const auto [x, y] = interface_->mouse();
    pixel_ = std::pair(std::clamp(int(x), 0, width - 1), std::clamp(int(y), 0, height - 1));
    singleFrames_ = std::max(singleFrames_, 1);
    taken_.mouse = true;
  }
}

void Viewer::endPanels() {
  if (!building_) return;
  building_ = false;
  const PanelFacts facts{*pack_,  session(), plain_ == nullptr, paused_, hasFixedTime(),
                         worldsBeside_, times_, pixel_,    probe_, checksFinite_, notFinite_,
                         inspector_ ? &*inspector_ : nullptr, shownProgram(),
                         comparison_.get()};
  if (panels_.options) drawOptions(*interface_, panels_, facts, requests_);
  if (panels_.scene) drawScene(*interface_, panels_, facts, requests_);
  if (panels_.passes) drawPasses(*interface_, panels_, facts, requests_);
  if (panels_.buffers) drawBuffers(*interface_, panels_, facts, requests_);
  if (panels_.program) drawProgram(*interface_, panels_, facts, requests_);
  if (panels_.compare) drawCompare(*interface_, panels_, facts, requests_);
  if (panels_.problems && !pack_->outcome().succeeded) drawProblems(*interface_, panels_, facts);
  if (panels_.help) drawHelp(*interface_, panels_);
  interface_->end(surface_->framebuffer());
  if (!panels_.buffers) inspector_.reset();
  if (!panels_.compare) comparison_.reset();
  if (!panels_.passes) {
    times_ = {};
    pixel_.reset();
    probe_.clear();
    checkFinite(false);
  }
}

void Viewer::apply(const PanelRequests& requests) {
  for (const auto& [name, value] : requests.drag) pack_->drag(name, value);
  if (requests.resetAll) pack_->resetOptions();
  if (requests.values) pack_->chooseValues("values of B", *requests.values);
  if (!requests.profile.empty()) pack_->chooseProfile(requests.profile);
  for (const auto& [name, value] : requests.set)
    pack_->setOptions(value.empty() ? name + " reset" : fmt::format("{}={}", name, value), {{name, value}});
  if (requests.resetAll || requests.values || !requests.profile.empty() || !requests.set.empty() ||
      !requests.drag.empty())
    finishPack();
  Environment& environment = session().environment();
  if (requests.time) session().setTime(*requests.time);
  if (requests.rain) environment.rain = *requests.rain;
  if (requests.thunder) environment.thunder = *requests.thunder;
  if (!requests.camera.empty()) setCamera(requests.camera);
  if (!requests.world.empty()) setWorld(requests.world);
  if (requests.pause) paused_ = *requests.pause;
  if (requests.singleFrame) run(ViewCommand::SingleFrame);
  if (requests.dropPixel) {
    pixel_.reset();
    probe_.clear();
  }
  if (requests.checkFinite) checkFinite(*requests.checkFinite);
  if (requests.show) show(*requests.show);
  if (!requests.program.empty()) showProgram(requests.program);
  if (requests.edit) openEditor(*requests.edit);
  if (requests.packOn) setPackOn(*requests.packOn);
}

bool Viewer::setWorld(const std::string& name) {
  setPackOn(true);
  endComparison();
  const std::string path = findWorld(name);
  Diagnostics diagnostics;
  auto world = path.empty() ? std::nullopt : loadWorld(path, options_.scene.seed, diagnostics);
  bool done = false;
  if (world) world->resourcePacks = options_.scene.resources;
  if (world && !world->cameras.empty()) {
    const Camera camera = world->cameras.front();
    done = pack_->session().setWorld(std::move(*world), camera, diagnostics);
  }
  report_.add(diagnostics);
  if (done) {
    chosenWorld_ = name;
    // A process that is shut in can list no folder: what was there before stays.
    if (auto beside = worldsBeside(path); !beside.empty()) worldsBeside_ = std::move(beside);
    if (!player_) noteRecentWorld(path);
  }
  say(done ? "world " + name : fmt::format("the world {} cannot be drawn", name));
  return done;
}

void Viewer::checkFinite(bool on) {
  checksFinite_ = on;
  notFinite_.clear();
  if (on) singleFrames_ = std::max(singleFrames_, 1);  // a pause has looked at nothing
}

void Viewer::show(ShownBuffer shown) {
  panels_.buffers = true;
  if (inspector_) {
    inspector_->ask(std::move(shown));
  } else {
    inspector_.emplace(std::move(shown));
  }
  singleFrames_ = std::max(singleFrames_, 1);  // a pause has read nothing of it
}

void Viewer::toggleBuffers() {
  panels_.buffers = !panels_.buffers;
  inspector_.reset();
  if (!panels_.buffers) return;
  controls_.giveMouseBack();
  ShownBuffer first;
  first.what.buffer = viewableBuffers(session().renderer()).front();
  show(first);
}

bool Viewer::compare(CompareMode mode) {
  setPackOn(true);
  if (!comparison_) {
    Diagnostics diagnostics;
    comparison_ = SetComparison::create(*context_, pack_->session(), options_.scene.seed, diagnostics);
    report_.add(diagnostics);
  }
  panels_.compare = comparison_ != nullptr;
  if (!comparison_) {
    say("this pack cannot be drawn twice");
    return false;
  }
  controls_.giveMouseBack();
  comparison_->mode = mode;
  singleFrames_ = std::max(singleFrames_, 1);
  return true;
}

void Viewer::endComparison() {
  panels_.compare = false;
  comparison_.reset();
}

bool Viewer::showProgram(const std::string& name) {
  const auto& pack = session().renderer().sharedPack();
  auto text = programText(*pack, name);
  if (!text) return false;
  program_ = std::move(text);
  programOf_ = pack;
  panels_.program = true;
  panels_.programLine = 0;
  return true;
}

// After a reload that of the new pack; a program that it lacks closes the panel.
const ProgramText* Viewer::shownProgram() {
  if (!panels_.program) {
    program_.reset();
    programOf_.reset();
    return nullptr;
  }
  const auto& pack = session().renderer().sharedPack();
  if (program_ && programOf_ == pack) return &*program_;
  const std::vector<std::string> names = programTextNames(*pack);
  const std::string name = program_ ? program_->name : names.empty() ? "" : names.front();
  const int line = panels_.programLine;
  panels_.program = showProgram(name);
  panels_.programLine = line;
  return panels_.program ? &*program_ : nullptr;
}

void Viewer::openEditor() {
  const Diagnostics& problems = pack_->outcome().problems;
  const auto located = std::ranges::find_if(problems, [](const Diagnostic& one) {
    return one.severity == Severity::Error && one.at.line > 0;
  });
  if (located == problems.end()) return say("there is no error to open");
  openEditor(located->at);
}

void Viewer::openEditor(const SourceLocation& at) {
  const std::string problem = surface_->openEditor(options_.pack.path, at);
  say(problem.empty() ? "opened " + formatLocation(at) : problem);
}

}  // namespace orris
