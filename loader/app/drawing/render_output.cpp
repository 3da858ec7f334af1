#include "app/drawing/render_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/drawing/frame_probe.h"
#include "app/input/inputs.h"
#include <orris/image/image.h>
#include <orris/pack/files/text.h>
#include <orris/render/inspect/counters.h>

namespace orris {
namespace {

template <class T>
bool writePicture(const std::string& path, const BasicImage<T>& image, Report& report) {
  Diagnostics diagnostics;
  const bool written = writeImage(path, image, diagnostics);
  report.add(diagnostics);
  return written;
}

Image8 displayed(const ImageF& image) {
  Image8 result(image.width, image.height, image.channels);
  for (size_t i = 0; i < image.pixels.size(); ++i)
    result.pixels[i] =
        static_cast<std::uint8_t>(std::lround(std::clamp(image.pixels[i], 0.0f, 1.0f) * 255));
  return result;
}

bool writeDump(const std::string& path, const ImageF& image, Report& report) {
  return isDisplayFormat(path) ? writePicture(path, displayed(image), report)
                               : writePicture(path, image, report);
}

bool writeTimings(const std::string& path, const std::vector<FrameStepTime>& times, Report& report) {
  std::string text = "frame,step,milliseconds,processor_milliseconds,card_milliseconds\n";
  for (const FrameStepTime& time : times)
    text += fmt::format("{},{},{:.4f},{:.4f},{}\n", time.frame, time.step.name,
                        time.step.seconds * 1e3, time.step.processorSeconds * 1e3,
                        time.step.cardSeconds ? fmt::format("{:.4f}", *time.step.cardSeconds * 1e3) : "");
  return writeWholeFile(path, text, report);
}

nlohmann::json renderJson(const SessionReload& reload) {
  return {{"frame", reload.frame},
          {"cause", reload.cause},
          {"succeeded", reload.succeeded},
          {"programsBuilt", reload.report.built},
          {"programsReused", reload.report.programsReused},
          {"compileSeconds", reload.report.compileSeconds}};
}

nlohmann::json renderJson(const TargetPlan& plan, const char* kind) {
  return {{"name", fmt::format("{}{}", kind, plan.index)},
          {"format", plan.format},
          {"width", plan.width},
          {"height", plan.height},
          {"sides", plan.needsAlt ? 2 : 1}};
}

/// What was chosen for options that are AUTO, of what and why.
nlohmann::json describeAuto(const AutoChoices& autoChoices, const ShaderPack& pack) {
  nlohmann::json options = nlohmann::json::array();
  for (const AutoChoice& choice : autoChoices.all()) {
    nlohmann::json candidates = nlohmann::json::array();
    for (const AutoEstimate& estimate : choice.candidates)
      candidates.push_back({{"value", estimate.value},
                            {"milliseconds", estimate.milliseconds},
                            {"allowed", estimate.allowed}});
    for (const AutoCandidate& candidate : autoCandidates(pack))
      for (nlohmann::json& entry : candidates)
        if (candidate.option == choice.option && candidate.value == entry["value"])
          entry["cost"] = candidate.formula();
    options.push_back(
        {{"option", choice.option}, {"value", choice.value}, {"candidates", candidates}});
  }
  return {{"options", options}, {"quantities", autoChoices.quantities()}};
}

std::vector<std::string> stepNames(const Schedule& schedule) {
  std::vector<std::string> names;
  for (const Step& step : schedule.frame) names.push_back(step.name);
  return names;
}

}  // namespace

bool checkPaths(const RenderOutputs& outputs, Report& report) {
  bool good = checkPicturePath(outputs.picture, report);
  for (const auto& [buffer, path] : outputs.dumps) good &= checkPicturePath(path, report);
  for (const auto& [shown, path] : outputs.shows)
    good &= shown.starts_with("bufferObject.") ? checkWritable(path, report)
                                               : checkPicturePath(path, report);
  if (!outputs.timings.empty()) good &= checkWritable(outputs.timings, report);
  return good;
}

bool checkBuffers(const RenderOutputs& outputs, const FrameRenderer& renderer, Report& report) {
  bool good = true;
  const auto runs = [&](const std::string& pass) {
    return std::ranges::find(renderer.schedule().frame, pass, &Step::name) !=
           renderer.schedule().frame.end();
  };
  for (const auto& [name, path] : outputs.dumps) {
    const auto parts = splitDumpName(name);
    const std::string& buffer = parts ? parts->first : name;
    if (parts && !runs(parts->second)) {
      good = false;
      report.error("dump-unknown", fmt::format("--dump {}: no such pass in this frame", name),
                   suggest(parts->second, stepNames(renderer.schedule())));
      continue;
    }
    if (renderer.texture(renderer.finalSide(buffer)) != nullptr) continue;
    good = false;
    report.error("dump-unknown", fmt::format("--dump {}: no such buffer in this frame", buffer),
                 "buffers: " + renderer.bufferNames());
  }
  for (const auto& [text, path] : outputs.shows) {
    std::string problem;
    if (const auto shown = parseShown(text, problem)) problem = problemOf(renderer, shown->what);
    if (problem.empty()) continue;
    good = false;
    report.error("show-unknown", fmt::format("--show {}: {}", text, problem), "");
  }
  return good;
}

bool writeShown(const std::string& path, const ShownBuffer& asked, const BufferView& view,
                Report& report) {
  if (view.pixels.pixels.empty())
    return writeWholeFile(path, storageTable(view), report);
  return isDisplayFormat(path) ? writePicture(path, paintValues(view.pixels, asked.how), report)
                               : writePicture(path, view.pixels, report);
}

bool writeOutputs(const RenderOutputs& outputs, const FrameRenderer& renderer,
                  const PassDumps& passDumps, const std::vector<FrameStepTime>& times,
                  Report& report) {
  bool good = isDisplayFormat(outputs.picture)
                  ? writePicture(outputs.picture, renderer.screenshot(), report)
                  : writePicture(outputs.picture, renderer.screenshotLinear(), report);
  for (const auto& [buffer, path] : outputs.dumps)
    if (const auto image = splitDumpName(buffer) ? std::nullopt : renderer.dump(buffer)) good &= writeDump(path, *image, report);
  for (const auto& [name, image] : passDumps)
    good &= writeDump(outputs.dumps.at(name), image, report);
  if (!outputs.timings.empty()) good &= writeTimings(outputs.timings, times, report);
  return good;
}

nlohmann::json describe(RenderSession& session, const gl::DriverInfo& driver) {
  const Schedule& schedule = session.renderer().schedule();
  const ShaderPack& pack = session.renderer().pack();
  nlohmann::json reloads = nlohmann::json::array(), programs = reloads, steps = reloads,
                 targets = reloads;
  for (const SessionReload& reload : session.reloads()) reloads.push_back(renderJson(reload));
  for (const int index : schedule.programs) programs.push_back(pack.programs[size_t(index)].name);
  for (const Step& step : schedule.frame) steps.push_back(step.name);
  for (const TargetPlan& plan : schedule.colortex) targets.push_back(renderJson(plan, "colortex"));
  for (const TargetPlan& plan : schedule.shadowcolor)
    targets.push_back(renderJson(plan, "shadowcolor"));
  return {{"frames", session.frame()},
          {"renderer", driver.renderer},
          {"glVersion", driver.version},
          {"profile", pack.currentProfile()},
          {"reloads", reloads},
          {"programs", programs},
          {"steps", steps},
          {"targets", targets},
          {"auto", describeAuto(session.autoChoices(), pack)},
          {"leftOut", session.renderer().programsLeftOut()},
          {"coreProfile", driver.coreProfile},
          {"counters", readCounters(session.renderer())},
          {"shadowResolution", schedule.shadowResolution}};
}

}  // namespace orris
