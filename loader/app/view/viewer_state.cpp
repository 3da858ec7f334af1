// The state of the viewer as JSON: what scripts wait for and assert. docs/view.md lists it.
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
          {"built", outcome.report.built},
          {"kept", outcome.report.programsReused}};
}

}  // namespace

nlohmann::json Viewer::state() {
  const RenderSession& own = pack_->session();
  const ShaderPack& pack = own.asked();
  nlohmann::json values = nlohmann::json::object();
  for (const auto& [name, option] : pack.options.all())
    values[name] = pack.options.value(pack.values, name);
  int width = 0, height = 0;
  surface_->size(width, height);
  const World& world = session().scene().world;
  const Environment& environment = world.environment;
  return {{"frame", session().frame()},
          {"width", width},
          {"height", height},
          {"paused", paused_},
          {"packOn", plain_ == nullptr},
          {"pack", pack.name},
          {"profile", pack.currentProfile()},
          {"values", values},
          {"changed", pack.values},
          {"world", world.name},
          {"camera", cameraState(session().camera())},
          {"time", environment.time},
          {"rain", environment.rain},
          {"thunder", environment.thunder},
          {"loads", own.reloads().size()},
          {"load", outcomeState(pack_->outcome())},
          {"problems", toJson(pack_->outcome().problems)},
          {"glErrors", glErrors_},
          {"said", said_}};
}

std::optional<ScreenItem> Viewer::item(const std::string&) { return std::nullopt; }

}  // namespace orris
