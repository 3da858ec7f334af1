// orris render: the whole pipeline headlessly, to a picture.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/inputs.h"
#include "app/progress.h"
#include "frame/render_session.h"
#include "image/image.h"

namespace orris {
namespace {

struct RenderOptions {
  PackOptions pack;
  SceneOptions scene;
  ImageOptions image;
  OutputOptions output;
  std::string picture;
  OptionValues dumps;  ///< buffer -> file
  std::string timings, patched;
};

bool isLinear(const std::string& path) { return std::filesystem::path(path).extension() != ".png"; }

bool checkOutputs(const RenderOptions& options, Report& report, int& status) {
  if (!checkPicturePath(options.picture, report, status)) return false;
  for (const auto& [buffer, file] : options.dumps)
    if (!checkPicturePath(file, report, status)) return false;
  return options.timings.empty() || checkWritable(options.timings, report, status);
}

/// All frames; what events report is shown at once. false: a reload failed.
bool drawFrames(RenderSession& session, int frames, std::vector<StepTime>& times, Report& report) {
  Progress progress("rendering", frames, report.output());
  for (int i = 0; i < frames; ++i) {
    Diagnostics diagnostics;
    session.renderFrame(diagnostics);
    report.add(diagnostics);
    for (const StepTime& time : session.renderer().stepTimes())
      times.push_back({fmt::format("{},{}", i, time.name), time.seconds});
    progress.advance();
  }
  return report.status() == kClean;
}

void writePicture(const RenderOptions& options, const FrameRenderer& renderer, Report& report,
                  int& status) {
  Diagnostics diagnostics;
  const bool written = isLinear(options.picture)
                           ? writeImage(options.picture, renderer.screenshotLinear(), diagnostics)
                           : writeImage(options.picture, renderer.screenshot(), diagnostics);
  report.add(diagnostics);
  if (!written) status = kUsage;
}

Image8 displayed(const ImageF& image) {
  Image8 result(image.width, image.height, image.channels);
  for (size_t i = 0; i < image.pixels.size(); ++i)
    result.pixels[i] =
        static_cast<std::uint8_t>(std::lround(std::clamp(image.pixels[i], 0.0f, 1.0f) * 255));
  return result;
}

void writeDumps(const RenderOptions& options, const FrameRenderer& renderer, Report& report,
                int& status) {
  for (const auto& [buffer, file] : options.dumps) {
    const auto image = renderer.dump(buffer);
    if (!image) {
      report.error("dump-unknown", fmt::format("--dump {}: no such buffer in this frame", buffer),
                   "buffers: " + renderer.bufferNames());
      status = kUsage;
      continue;
    }
    Diagnostics diagnostics;
    const bool written = isLinear(file) ? writeImage(file, *image, diagnostics)
                                        : writeImage(file, displayed(*image), diagnostics);
    report.add(diagnostics);
    if (!written) status = kUsage;
  }
}

void writeTimings(const std::string& path, const std::vector<StepTime>& times, Report& report,
                  int& status) {
  std::string text = "frame,step,milliseconds\n";
  for (const StepTime& time : times)
    text += fmt::format("{},{:.4f}\n", time.name, time.seconds * 1e3);
  writeWholeFile(path, text, report, status);
}

/// The sources as the driver got them, one file a stage.
void writePatched(const std::string& folder, const ShaderPack& pack, Report& report, int& status) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  const auto write = [&](const std::string& name, const StageText& stage) {
    writeWholeFile(fmt::format("{}/{}.{}", folder, name, stageExtension(stage.stage)),
                   stage.text.text, report, status);
  };
  for (const ProgramSource& program : pack.programs) {
    for (const StageText& stage : program.stages) write(program.name, stage);
    for (const ComputeSource& compute : program.computes) write(compute.name, compute.text);
  }
}

nlohmann::json toJson(RenderSession& session, const gl::DriverInfo& driver,
                      const RenderOptions& options) {
  nlohmann::json reloads = nlohmann::json::array();
  for (const SessionReload& reload : session.reloads())
    reloads.push_back({{"frame", reload.frame},
                       {"cause", reload.cause},
                       {"succeeded", reload.succeeded},
                       {"programsBuilt", reload.report.built},
                       {"programsReused", reload.report.programsReused},
                       {"compileSeconds", reload.report.compileSeconds}});
  const Schedule& schedule = session.renderer().schedule();
  nlohmann::json steps = nlohmann::json::array(), targets = nlohmann::json::array();
  for (const Step& step : schedule.frame) steps.push_back(step.name);
  for (const bool shadow : {false, true})
    for (const TargetPlan& plan : shadow ? schedule.shadowcolor : schedule.colortex)
      targets.push_back(
          {{"name", fmt::format("{}{}", shadow ? "shadowcolor" : "colortex", plan.index)},
           {"format", plan.format},
           {"width", plan.width},
           {"height", plan.height},
           {"sides", plan.needsAlt ? 2 : 1}});
  return {{"picture", options.picture},
          {"frames", session.frame()},
          {"renderer", driver.renderer},
          {"glVersion", driver.version},
          {"profile", session.renderer().pack().currentProfile()},
          {"reloads", reloads},
          {"steps", steps},
          {"targets", targets},
          {"shadowResolution", schedule.shadowResolution}};
}

int runRender(const RenderOptions& options) {
  int status = kClean;
  Report report(options.output);
  if (!checkOutputs(options, report, status)) return status;
  const auto files = openPackFiles(options.pack.path, report, status);
  if (!files) return status;
  const auto load = makeLoadRequest(files, options.pack, {}, report, status);
  if (!load) return status;
  auto world = loadScene(options.scene, options.pack.dimension, report, status);
  if (!world) return status;
  const auto camera = chooseCamera(*world, options.scene.camera, report, status);
  if (!camera) return status;

  Diagnostics diagnostics;
  const auto context = gl::createContext({.backend = options.image.backend}, diagnostics);
  report.add(diagnostics);
  if (!context) return kHostFailed;
  SessionRequest request;
  request.openPack = [&](Diagnostics&) { return files; };
  request.load = *load;
  request.renderer = {options.image.width, options.image.height, isLinear(options.picture),
                      !options.timings.empty()};
  request.camera = *camera;
  request.seed = options.scene.seed;
  const auto session = RenderSession::create(*context, request, std::move(*world), diagnostics);
  report.add(diagnostics);
  if (!session) return loadFailureStatus(files, *load);

  std::vector<StepTime> times;
  if (!drawFrames(*session, options.image.frames, times, report)) status = kProblems;
  for (const std::string& message : context->takeErrors()) {
    report.error("gl-error", message);
    status = kHostFailed;
  }
  writePicture(options, session->renderer(), report, status);
  writeDumps(options, session->renderer(), report, status);
  if (!options.timings.empty()) writeTimings(options.timings, times, report, status);
  if (!options.patched.empty())
    writePatched(options.patched, session->renderer().pack(), report, status);
  printJson(toJson(*session, context->driver(), options), report);
  return status;
}

}  // namespace

void addRenderCommand(CLI::App& app, int& status) {
  const auto options = std::make_shared<RenderOptions>();
  CLI::App* command = app.add_subcommand("render", "render a world with a pack, without a window");
  addPackArgument(*command, options->pack.path);
  addWorldArgument(*command, options->scene.path);
  command->add_option("-o,--output", options->picture, "picture: .png (display) or .exr (linear)")
      ->required();
  addPackFlags(*command, options->pack);
  addSceneFlags(*command, options->scene);
  addImageFlags(*command, options->image);
  addAssignmentFlag(*command, "--dump", options->dumps, "write a buffer after the last frame",
                    "BUFFER=FILE");
  command->add_option("--timings", options->timings, "write a CSV of the time of every step");
  command->add_option("--patched", options->patched,
                      "write the sources given to the driver to a folder");
  addOutputFlags(*command, options->output);
  command->callback([options, &status] { status = runRender(*options); });
}

}  // namespace orris
