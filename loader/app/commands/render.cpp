// orris render: the whole pipeline headlessly, to a picture.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands/commands.h"
#include "app/drawing/frame_end.h"
#include "app/drawing/frame_probe.h"
#include "app/drawing/render_output.h"
#include "app/drawing/supervised_run.h"
#include "app/input/inputs.h"
#include "app/output/progress.h"
#include <orris/check/compile/program_check.h>
#include <orris/image/image.h>
#include <orris/render/inspect/counters.h>
#include <orris/render/session/render_session.h>
#include <orris/validate/patched_sources.h>

namespace orris {
namespace {

struct RenderOptions {
  PackOptions pack;
  SceneOptions scene;
  ImageOptions image;
  FramesWanted frames;
  OutputOptions output;
  RenderOutputs outputs;
  WorkLimits limits;
};

/// Pack, options and camera as the command line asks for them.
std::optional<SessionRequest> makeRequest(const RenderOptions& options, const World& world,
                                          Report& report) {
  const auto files = openPackFiles(options.pack.path, report);
  if (!files) return std::nullopt;
  PackOptions pack = options.pack;
  if (pack.dimension.empty()) pack.dimension = world.environment.dimension;
  const auto load = makeLoadRequest(files, pack, {}, report);
  const auto camera =
      load ? chooseCamera(world, options.scene.camera, report) : std::nullopt;
  if (!camera) return std::nullopt;
  SessionRequest request;
  request.openPack = [files](Diagnostics&) { return files; };
  request.load = *load;
  request.versions = options.pack.versions;
  request.renderer = {options.image.width, options.image.height, !isDisplayFormat(options.outputs.picture),
                      !options.outputs.timings.empty()};
  request.camera = *camera;
  request.seed = options.scene.seed;
  return request;
}

/// The sources are wanted most when the driver refuses one: written before it is asked.
bool showSources(const RenderOptions& options, const SessionRequest& request,
                 const gl::DriverInfo& driver, Report& report) {
  if (options.outputs.patched.empty() && !options.output.verbose) return true;
  Diagnostics diagnostics;
  LoadRequest load = request.load;
  load.environment = environmentFor(driver, request.versions);
  const auto pack = loadShaderPack(request.openPack(diagnostics), load, diagnostics);
  if (!pack) return true;  // the session says why
  Diagnostics notes = ruleNotes(*pack);
  report.add(notes);
  Diagnostics unwritten;
  if (options.outputs.patched.empty() || writePatched(options.outputs.patched, *pack, unwritten))
    return true;
  report.add(unwritten);
  return false;
}

std::vector<FrameStepTime> drawFrames(RenderSession& session, const FramesWanted& wanted, FrameEnd& end,
                                      FrameProbe& probe, Report& report) {
  std::vector<FrameStepTime> times;
  Progress progress("rendering", wanted.most, report.output());
  bool last = false;
  for (int frame = 0; !last; ++frame) {
    Diagnostics diagnostics;
    last = end.isLast(frame);
    probe.begin(frame, last);
    session.renderFrame(diagnostics);
    report.add(diagnostics);
    end.drawn(frame, session.renderer());
    for (const StepTime& step : session.renderer().stepTimes()) times.push_back({frame, step});
    progress.advance();
  }
  return times;
}

using Clock = std::chrono::steady_clock;

std::string framesText(int count, std::optional<bool> settled) {
  std::string text = fmt::format("{} frame{}", count, count == 1 ? "" : "s");
  if (settled) text += *settled ? " until it settled" : ", not settled";
  return text;
}

void sayRendered(const RenderOptions& options, RenderSession& session, std::optional<bool> settled,
                 const gl::DriverInfo& driver, Clock::time_point began) {
  std::vector<std::string> paths = {options.outputs.picture};
  for (const auto& [buffer, path] : options.outputs.dumps) paths.push_back(path);
  for (const auto& [shown, path] : options.outputs.shows) paths.push_back(path);
  paths.push_back(options.outputs.timings);
  const double seconds = std::chrono::duration<double>(Clock::now() - began).count();
  sayWritten(options.output, paths,
             fmt::format("{}x{}, {}, {:.1f} s, {}", options.image.width, options.image.height,
                         framesText(session.frame(), settled), seconds, driver.renderer.substr(0, driver.renderer.find(" ("))));
}

/// The closing line of a picture that lacks something.
void sayLeftOut(const FrameRenderer& renderer, bool allowed, Report& report) {
  const std::vector<std::string> names = renderer.programsLeftOut();
  if (names.empty()) return;
  Diagnostics diagnostics(1);
  Diagnostic& found = diagnostics.front();
  found.severity = allowed ? Severity::Warning : Severity::Error;
  found.id = "program-left-out";
  found.message = fmt::format("{} left out of the picture, which this driver cannot run: {}",
                              names.size() == 1 ? "a program is" : fmt::format("{} programs are", names.size()),
                              fmt::join(names, ", "));
  if (!allowed) found.hint = "with --allow-missing this is a warning";
  report.add(diagnostics);
}

nlohmann::json shownJson(FrameProbe& probe) {
  nlohmann::json all = nlohmann::json::object();
  for (const auto& [text, show] : probe.shows())
    if (show.view) all[text] = toJson(*show.view, show.asked.how);
  return all;
}

int runRender(const RenderOptions& options, Report& report, nlohmann::json& result) {
  const Clock::time_point began = Clock::now();
  Diagnostics diagnostics;
  if (!checkPaths(options.outputs, report)) return report.status();
  auto world = loadScene(options.scene, options.pack.dimension, report);
  if (!world) return report.status();
  const auto request = makeRequest(options, *world, report);
  if (!request) return report.status();

  if (!makePatchedFolder(options.outputs.patched, diagnostics)) {
    report.add(diagnostics);
    return report.status();
  }
  confineDrawing();
  const auto context = gl::createContext(
      {.backend = options.image.backend, .profile = options.image.context}, diagnostics);
  report.add(diagnostics);
  if (!context) return report.status();
  if (!showSources(options, *request, context->driver(), report)) return report.status();
  const auto session = RenderSession::create(*context, *request, std::move(*world), diagnostics);
  report.add(diagnostics);
  if (!session) return report.status();
  if (!checkBuffers(options.outputs, session->renderer(), report)) return report.status();

  FrameProbe probe(options.outputs, session->renderer());
  FrameEnd end(options.frames, session->scene().world);
  const auto times = drawFrames(*session, options.frames, end, probe, report);
  result = describe(*session, context->driver());
  if (end.settled()) result["settled"] = *end.settled();
  if (!options.outputs.probe.empty()) result["probe"] = probe.json();
  if (!options.outputs.shows.empty()) result["shown"] = shownJson(probe);
  if (!options.output.json && !options.output.quiet) printText(probe.text());
  Diagnostics counted = counterWarnings(session->renderer());
  report.add(counted);
  if (report.status() != kClean) return report.status();
  const std::vector<std::string> errors = context->takeErrors();
  for (const std::string& message : errors) report.error("gl-error", message);
  // The frames are not what the pack asks for: a picture of an earlier run stays.
  if (!errors.empty()) return report.status();
  bool written = writeOutputs(options.outputs, session->renderer(), probe.dumps(), times, report);
  for (const auto& [text, show] : probe.shows())
    if (show.view)
      written &= writeShown(options.outputs.shows.at(text), show.asked, *show.view, report);
  if (written)
    sayRendered(options, *session, end.settled(), context->driver(), began);
  Diagnostics notFinite = probe.findings();
  report.add(notFinite);
  sayLeftOut(session->renderer(), options.outputs.allowMissing, report);
  return report.status();
}

/// What a process that may write nothing else is allowed to.
SupervisedWork supervised(const RenderOptions& options) {
  AllowedFiles files;
  files.outputs = {options.outputs.picture, options.outputs.timings};
  for (const auto& [buffer, path] : options.outputs.dumps) files.outputs.push_back(path);
  for (const auto& [shown, path] : options.outputs.shows) files.outputs.push_back(path);
  if (!options.outputs.patched.empty()) files.folders = {options.outputs.patched};
  return {.limits = options.limits,
          .backend = options.image.backend,
          .pack = options.pack.path,
          .files = std::move(files),
          .confined = true};
}

void addOutputPaths(CLI::App& command, RenderOutputs& outputs) {
  command.add_option("-o,--output", outputs.picture, "picture: .png (display) or .exr (linear)")
      ->type_name("OUT")
      ->required();
  addAssignmentFlag(command, "--dump", outputs.dumps,
                    "write a buffer after the last frame, or after a pass of it",
                    "BUFFER[@PASS]=FILE");
  addAssignmentFlag(command, "--show", outputs.shows,
                    "paint the values of a buffer, or list them: side, mip, slice, channel, range, "
                    "false colours (docs/view.md)",
                    "BUFFER[@PASS][:WORD...]=FILE");
  command
      .add_option("--probe", outputs.probe,
                  "print the value of a pixel after every pass of the last frame that wrote it")
      ->type_name("X,Y");
  command.add_flag("--check-finite", outputs.checkFinite,
                   "name the first pass that writes NaN or Inf");
  command.add_option("--timings", outputs.timings, "write a CSV of the time of every step")
      ->type_name("FILE");
  command.add_flag("--allow-missing", outputs.allowMissing,
                   "status 0 although this driver cannot run some programs");
  command.add_option("--patched", outputs.patched, "write the sources as the driver gets them")
      ->type_name("DIR");
}

void checkShows(const RenderOptions& options) {
  for (const auto& [text, path] : options.outputs.shows) {
    std::string problem;
    if (!parseShown(text, problem)) throw CLI::ValidationError("--show", problem);
  }
}

void checkProbe(const RenderOptions& options) {
  const std::string& text = options.outputs.probe;
  const auto pixel = parsePixel(text);
  if (text.empty() || (pixel && pixel->first < options.image.width &&
                       pixel->second < options.image.height))
    return;
  throw CLI::ValidationError(
      "--probe", fmt::format("\"{}\" is no pixel of a picture of {}x{}: write X,Y from the top left",
                             text, options.image.width, options.image.height));
}

}  // namespace

void addRenderCommand(CLI::App& app, int& status) {
  const auto options = std::make_shared<RenderOptions>();
  CLI::App* command = app.add_subcommand("render", "render a world with a pack, without a window");
  addPackArgument(*command, options->pack.path);
  addWorldArgument(*command, options->scene.path);
  addOutputPaths(*command, options->outputs);
  addPackFlags(*command, options->pack);
  addVersionFlags(*command, options->pack.versions);
  addSceneFlags(*command, options->scene);
  addImageFlags(*command, options->image);
  addSettlingFramesFlag(*command, options->frames);
  addLimitFlags(*command, options->limits);
  addOutputFlags(*command, options->output);
  command->callback([options, &status] {
    checkProbe(*options);
    checkShows(*options);
    Report report(options->output);
    nlohmann::json result = nlohmann::json::object();
    status = runSupervised(supervised(*options), report,
                           [&] { return runRender(*options, report, result); });
    result["status"] = status;
    printJson(std::move(result), report);
  });
}

}  // namespace orris
