// What commands and script steps do to the viewer, and what it says about it.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>

#include "app/drawing/render_output.h"
#include "app/input/inputs.h"
#include "app/view/pack/plain_pack.h"
#include "app/view/viewer.h"
#include <orris/gl/functions.h>
#include <orris/image/image.h>
#include <orris/pack/programs/live_check.h>
#include <orris/render/inspect/counters.h>

namespace orris {
namespace {

std::string freeScreenshotName() {
  for (int i = 1;; ++i) {
    std::string name = fmt::format("orris-{:04}.png", i);
    if (!std::filesystem::exists(name)) return name;
  }
}

}  // namespace

bool isScreenshotName(const std::string& path) {
  static const std::regex kName("orris-[0-9]{4,9}\\.png");
  return std::regex_match(path, kName);
}

void Viewer::run(ViewCommand command) {
  const auto toggle = [this](bool& panel) {
    panel = !panel;
    if (panel) controls_.giveMouseBack();
  };
  switch (command) {
    case ViewCommand::Help:
      return toggle(panels_.help);
    case ViewCommand::Options:
      return toggle(panels_.options);
    case ViewCommand::Scene:
      return toggle(panels_.scene);
    case ViewCommand::Passes:
      return toggle(panels_.passes);
    case ViewCommand::Buffers:
      return toggleBuffers();
    case ViewCommand::Program:
      return toggle(panels_.program);
    case ViewCommand::Compare:
      if (comparison_) return endComparison();
      compare(CompareMode::Side);
      return;
    case ViewCommand::Flicker:
      if (comparison_) comparison_->showsB = !comparison_->showsB;
      return;
    case ViewCommand::Editor:
      return openEditor();
    case ViewCommand::Reload:
      pack_->reload("R pressed", true);
      return finishPack();
    case ViewCommand::NextProfile:
      if (session().renderer().pack().properties.profiles.empty())
        return say("this pack has no profiles");
      pack_->nextProfile();
      return finishPack();
    case ViewCommand::Screenshot:
      return saveScreenshot(freeScreenshotName());
    case ViewCommand::PackOnOff:
      setPackOn(plain_ != nullptr);
      return;
    case ViewCommand::Pause:
      paused_ = !paused_;
      return;
    case ViewCommand::SingleFrame:
      paused_ = true;
      ++singleFrames_;
      return;
    case ViewCommand::FullScreen:
      fullScreen_ = !fullScreen_;
      return surface_->setFullScreen(fullScreen_);
  }
}

bool Viewer::setPackOn(bool on) {
  if (on == (plain_ == nullptr)) return true;
  endComparison();
  RenderSession& other = pack_->session();
  if (on) {
    other.setCamera(plain_->camera());
    const Environment& seen = plain_->environment();
    other.environment().time = seen.time;
    other.environment().rain = seen.rain;
    other.environment().thunder = seen.thunder;
    plain_.reset();
    say("pack on");
    return true;
  }
  SessionRequest request;
  request.openPack = [](Diagnostics&) { return plainPack(); };
  request.load.dimension = other.loadRequest().dimension;
  request.renderer = {.width = other.renderer().schedule().width,
                      .height = other.renderer().schedule().height};
  request.camera = other.camera();
  request.seed = options_.scene.seed;
  Diagnostics diagnostics;
  plain_ = RenderSession::create(*context_, std::move(request), other.scene().world, diagnostics);
  report_.add(diagnostics);
  say(plain_ ? "pack off" : "the pack cannot be switched off");
  return plain_ != nullptr;
}

bool Viewer::setCamera(const std::string& name) {
  const Camera* camera = session().scene().world.camera(name);
  if (camera != nullptr) session().setCamera(*camera);
  return camera != nullptr;
}

void Viewer::sayOutcome() {
  if (pack_->takeSaved()) watch_->accept(pack_->optionFile());
  const LoadOutcome& last = pack_->outcome();
  status_ = last.succeeded ? kClean : kProblems;
  panels_.problems = true;
  notFinite_.clear();
  if (!last.succeeded) return say("not reloaded: the last good pack keeps running");
  say(fmt::format("reloaded ({}): {} programs built{}{}, {} kept, {:.2f} s", last.cause,
                  last.report.programsBuilt, last.report.built.empty() ? "" : ": ",
                  fmt::join(last.report.built, ", "), last.report.programsReused, last.seconds));
}

void Viewer::sayGlErrors() {
  for (const std::string& text : context_->takeErrors()) {
    report_.error("gl-error", "the GL driver reports: " + text);
    status_ = kHostFailed;
    ++glErrors_;
  }
}

// Each once, however the number changes.
void Viewer::sayCounters() {
  if (session().frame() == 0) return;
  for (Diagnostic& diagnostic : counterWarnings(session().renderer())) {
    if (!saidCounters_.insert(diagnostic.at.line).second) continue;
    report_.add(std::move(diagnostic));
  }
}

void Viewer::saveScreenshot(const std::string& path) {
  if (session().frame() == 0) return;
  Diagnostics diagnostics;
  FrameRenderer& renderer = session().renderer();
  const bool written = isDisplayFormat(path) ? writeImage(path, renderer.screenshot(), diagnostics)
                                             : writeImage(path, renderer.screenshotLinear(), diagnostics);
  report_.add(diagnostics);
  if (written) return say("screenshot: " + path);
  status_ = kUsage;
}

void Viewer::saveWindow(const std::string& path) {
  int width = 0, height = 0;
  surface_->size(width, height);
  Image8 image(width, height, 3);
  gl::BindFramebuffer(GL_READ_FRAMEBUFFER, surface_->framebuffer());
  gl::PixelStorei(GL_PACK_ALIGNMENT, 1);
  for (int y = 0; y < height; ++y)
    gl::ReadPixels(0, height - 1 - y, width, 1, GL_RGB, GL_UNSIGNED_BYTE, image.at(0, y));
  Diagnostics diagnostics;
  if (!writeImage(path, image, diagnostics)) status_ = kUsage;
  report_.add(diagnostics);
}

void Viewer::say(const std::string& line) {
  said_ = line;
  if (!options_.output.quiet) printText(line + "\n");
}

std::string Viewer::perform(const ScriptStep& step) {
  struct Row {
    const char* name;
    Action action;
  };
  static constexpr Row kRows[] = {
      {"set", &Viewer::setOptionsStep},      {"profile", &Viewer::profileStep},
      {"live", &Viewer::liveStep},
      {"time", &Viewer::timeStep},           {"rain", &Viewer::rainStep},
      {"thunder", &Viewer::thunderStep},     {"camera", &Viewer::cameraStep},
      {"pause", &Viewer::pauseStep},         {"pack", &Viewer::packStep},
      {"resize", &Viewer::resizeStep},       {"screenshot", &Viewer::screenshotStep},
      {"picture", &Viewer::pictureStep},     {"state", &Viewer::stateStep},
      {"compare", &Viewer::compareStep},      {"program", &Viewer::programStep},
      {"checkFinite", &Viewer::checkFiniteStep},
      {"show", &Viewer::showStep},           {"shown", &Viewer::shownStep}};
  const auto row = std::ranges::find_if(kRows, [&](const Row& one) { return one.name == step.action; });
  return row == std::end(kRows) ? "cannot be done here" : (this->*row->action)(step.value);
}

std::string Viewer::setOptionsStep(const JsonNode& value) {
  const OptionSet& options = pack_->session().asked().options;
  OptionValues changes;
  for (const JsonMember& member : value.members) {
    const Option* option = options.find(member.key);
    if (option == nullptr) return fmt::format("the pack has no option {}", member.key);
    const std::string& wanted = member.value.text;
    if (!wanted.empty() && std::ranges::find(option->values, wanted) == option->values.end())
      return fmt::format("{} cannot be \"{}\": its values are the texts {}", member.key, wanted,
                         fmt::join(option->values, ", "));
    changes[member.key] = wanted;
  }
  std::vector<std::string> words;
  for (const auto& [name, wanted] : changes) words.push_back(name + "=" + wanted);
  pack_->setOptions(fmt::format("{}", fmt::join(words, " ")), changes);
  finishPack();
  return "";
}

std::string Viewer::profileStep(const JsonNode& value) {
  pack_->setProfile(value.text);
  finishPack();
  return pack_->outcome().succeeded ? "" : "the profile cannot be taken";
}

std::string Viewer::liveStep(const JsonNode& value) {
  const auto reasons = liveOptions(pack_->session().asked());
  std::set<std::string> names;
  for (const JsonNode& item : value.items) {
    const auto found = reasons.find(item.text);
    if (found == reasons.end()) return fmt::format("the pack has no option {}", item.text);
    if (!found->second.empty()) return fmt::format("{} cannot be live: {}", item.text, found->second);
    names.insert(item.text);
  }
  pack_->setLive(names);
  finishPack();
  return pack_->outcome().succeeded ? "" : "the programs cannot be built so";
}

std::string Viewer::timeStep(const JsonNode& value) {
  constexpr std::int64_t kDay = 24000;
  if (value.integer < 0 || value.integer >= kDay) return "a time of day is 0 to 23999";
  session().setTime(int(value.integer));
  return "";
}

std::string Viewer::rainStep(const JsonNode& value) {
  session().environment().rain = float(std::clamp(value.real, 0.0, 1.0));
  return "";
}

std::string Viewer::thunderStep(const JsonNode& value) {
  session().environment().thunder = float(std::clamp(value.real, 0.0, 1.0));
  return "";
}

std::string Viewer::cameraStep(const JsonNode& value) {
  return setCamera(value.text) ? "" : fmt::format("the world has no camera {}", value.text);
}

std::string Viewer::pauseStep(const JsonNode& value) {
  paused_ = value.boolean;
  return "";
}

std::string Viewer::packStep(const JsonNode& value) {
  return setPackOn(value.boolean) ? "" : "the pack cannot be switched off";
}

std::string Viewer::resizeStep(const JsonNode& value) {
  constexpr int kLargest = 16384;
  const bool pair = value.items.size() == 2 && std::ranges::all_of(value.items, [](const JsonNode& n) {
    return n.integer >= 1 && n.integer <= kLargest;
  });
  if (!pair) return "a size is [width, height], in pixels";
  surface_->resize(int(value.items[0].integer), int(value.items[1].integer));
  return "";
}

std::string Viewer::screenshotStep(const JsonNode& value) {
  windowPicture_ = value.text;
  return "";
}

std::string Viewer::pictureStep(const JsonNode& value) {
  saveScreenshot(value.text);
  return "";
}

std::string Viewer::compareStep(const JsonNode& value) {
  if (value.text.empty()) {
    endComparison();
    return "";
  }
  const auto mode = std::ranges::find(kCompareModes, value.text);
  if (mode == kCompareModes.end())
    return fmt::format("there is no \"{}\": sets are compared by {}", value.text,
                       fmt::join(kCompareModes, ", "));
  return compare(CompareMode(mode - kCompareModes.begin())) ? "" : "the pack cannot be drawn twice";
}

std::string Viewer::programStep(const JsonNode& value) {
  panels_.program = false;
  if (value.text.empty() || showProgram(value.text)) return "";
  return fmt::format("there is no program {}: the pack has {}", value.text,
                     fmt::join(programTextNames(session().renderer().pack()), ", "));
}

std::string Viewer::checkFiniteStep(const JsonNode& value) {
  panels_.passes = true;
  checkFinite(value.boolean);
  return "";
}

std::string Viewer::showStep(const JsonNode& value) {
  if (value.text.empty()) {
    panels_.buffers = false;
    inspector_.reset();
    return "";
  }
  std::string problem;
  const auto shown = parseShown(value.text, problem);
  if (shown) problem = problemOf(session().renderer(), shown->what);
  if (problem.empty()) show(*shown);
  return problem;
}

std::string Viewer::shownStep(const JsonNode& value) {
  if (!inspector_ || !inspector_->view()) return "no buffer is shown";
  if (writeShown(value.text, inspector_->asked(), *inspector_->view(), report_)) return "";
  status_ = kUsage;
  return value.text + " cannot be written";
}

std::string Viewer::stateStep(const JsonNode& value) {
  if (writeWholeFile(value.text, jsonText(state()), report_)) return "";
  status_ = kUsage;
  return value.text + " cannot be written";
}

}  // namespace orris
