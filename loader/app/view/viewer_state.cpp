// The state of the viewer as JSON: what scripts wait for and assert. docs/view.md lists it.
#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "app/view/viewer.h"

namespace orris {
namespace {

nlohmann::json cameraState(const Camera& camera) {
  const auto& at = camera.position;
  return {{"name", camera.name},
          {"position", {at.x, at.y, at.z}},
          {"yaw", camera.yaw},
          {"pitch", camera.pitch}};
}

nlohmann::json outcomeState(const LoadOutcome& outcome) {
  return {{"cause", outcome.cause},
          {"succeeded", outcome.succeeded},
          {"seconds", outcome.seconds},
          {"frames", outcome.frames},
          {"longestFrame", outcome.longestFrame},
          {"built", outcome.report.built},
          {"kept", outcome.report.programsReused}};
}

nlohmann::json panelsState(const PanelState& panels) {
  return {{"help", panels.help},
          {"options", panels.options},
          {"scene", panels.scene},
          {"passes", panels.passes},
          {"buffers", panels.buffers},
          {"compare", panels.compare},
          {"program", panels.program},
          {"screen", panels.screens.empty() ? "" : panels.screens.back()},
          {"search", panels.search}};
}

nlohmann::json probeState(const std::vector<ProbeValue>& probe) {
  nlohmann::json chain = nlohmann::json::array();
  for (const ProbeValue& value : probe)
    chain.push_back({{"step", value.step}, {"buffer", value.side.name}, {"value", value.value}});
  return chain;
}

nlohmann::json sidesState(const std::vector<BufferSide>& sides) {
  nlohmann::json names = nlohmann::json::array();
  for (const BufferSide& side : sides) names.push_back(side.name + (side.alt ? " alt" : ""));
  return names;
}

/// Of passes of one name the last.
nlohmann::json passesState(const FrameRenderer& renderer) {
  nlohmann::json passes = nlohmann::json::object();
  for (const Step& step : renderer.schedule().frame)
    passes[step.name] = {{"reads", sidesState(renderer.readsOf(step))},
                         {"writes", sidesState(renderer.writesOf(step))}};
  return passes;
}

nlohmann::json programState(const ProgramText& program, int chosen) {
  nlohmann::json rules = nlohmann::json::object();
  for (const AppliedRule& rule : program.rules) rules[rule.rule] = rule.count;
  nlohmann::json json = {{"name", program.name},   {"lines", program.lines.size()}, {"rules", rules},
                         {"options", program.options}, {"includes", program.includes},  {"line", chosen}};
  if (chosen < 1 || std::size_t(chosen) > program.lines.size()) return json;
  const ProgramLine& line = program.lines[std::size_t(chosen) - 1];
  json["text"] = line.text;
  json["author"] = authorText(line);
  json["linesOfAuthor"] = program.linesFrom(line.author.file, line.author.line);
  return json;
}

/// Memory of this process, 0 where the system does not say.
double residentMegabytes() {
  std::ifstream file("/proc/self/statm");
  double all = 0, resident = 0;
  if (!(file >> all >> resident)) return 0;
  return resident * double(sysconf(_SC_PAGESIZE)) / 1e6;
}

}  // namespace

nlohmann::json Viewer::state() {
  const RenderSession& own = pack_->session();
  const ShaderPack& pack = own.asked();
  nlohmann::json values = nlohmann::json::object();
  for (const auto& [name, option] : pack.options.all())
    values[name] = pack.options.value(pack.values, name);
  nlohmann::json items = nlohmann::json::array(), steps = items;
  if (interface_ && panelsShown())
    for (const auto& [name, item] : interface_->items()) items.push_back(name);
  FrameRenderer& renderer = session().renderer();
  for (const Step& step : renderer.schedule().frame) steps.push_back(step.name);
  int width = 0, height = 0;
  surface_->size(width, height);
  const World& world = session().scene().world;
  const Environment& environment = world.environment;
  return {{"frame", session().frame()},
          {"width", width},
          {"height", height},
          {"paused", paused_},
          {"panels", panelsState(panels_)},
          {"items", items},
          {"interface", interface_ != nullptr},
          {"steps", steps},
          {"passes", passesState(renderer)},
          {"timedSteps", renderer.stepTimes().size()},
          {"probe", probeState(probe_)},
          {"checksFinite", checksFinite_},
          {"notFinite", toJson(notFinite_)},
          {"shown", inspector_ ? inspector_->state() : nlohmann::json()},
          {"program", panels_.program && program_ ? programState(*program_, panels_.programLine) : nlohmann::json()},
          {"compare", comparison_ ? comparison_->state(pack) : nlohmann::json()},
          {"copies", BufferInspector::copies()},
          {"packOn", plain_ == nullptr},
          {"pack", pack.name},
          {"profile", pack.currentProfile()},
          {"values", values},
          {"changed", pack.values},
          {"live", pack.live},
          {"world", world.name},
          {"camera", cameraState(session().camera())},
          {"time", environment.time},
          {"rain", environment.rain},
          {"thunder", environment.thunder},
          {"loads", own.reloads().size()},
          {"doing", pack_->doing()},
          {"load", outcomeState(pack_->outcome())},
          {"problems", toJson(pack_->outcome().problems)},
          {"glErrors", glErrors_},
          {"residentMegabytes", residentMegabytes()},
          {"said", said_}};
}

std::optional<ScreenItem> Viewer::item(const std::string& name) {
  if (!interface_ || !panelsShown()) return std::nullopt;
  const auto found = interface_->items().find(name);
  if (found == interface_->items().end()) return std::nullopt;
  return found->second;
}

}  // namespace orris
