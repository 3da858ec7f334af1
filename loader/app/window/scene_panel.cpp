// Time of day, weather, world and camera.
#include <fmt/format.h>

#include <filesystem>

#include "app/input/shipped_worlds.h"
#include "app/input/world_shelf.h"
#include "app/window/panel_parts.h"
#include "app/window/panels.h"

namespace orris {
namespace {

constexpr int kLastTick = 23999;

struct NamedTime {
  const char* name;
  int ticks;
};
constexpr NamedTime kTimes[] = {{"sunrise", 23000}, {"noon", 6000}, {"sunset", 12500}, {"midnight", 18000}};

void drawTime(Interface& interface, const Environment& environment, PanelRequests& requests) {
  int time = environment.time;
  if (ImGui::SliderInt("time", &time, 0, kLastTick, "%d", ImGuiSliderFlags_AlwaysClamp))
    requests.time = time;
  interface.name("time");
  for (const NamedTime& named : kTimes) {
    if (named.ticks != kTimes[0].ticks) ImGui::SameLine();
    if (ImGui::SmallButton(named.name)) requests.time = named.ticks;
    interface.name(named.name);
  }
  const auto weather = [&](const char* name, float value, std::optional<float>& request) {
    if (ImGui::SliderFloat(name, &value, 0, 1, "%.2f", ImGuiSliderFlags_AlwaysClamp)) request = value;
    interface.name(name);
  };
  weather("rain", environment.rain, requests.rain);
  weather("thunder", environment.thunder, requests.thunder);
}

/// Items of the open list; their names for scripts are whole paths.
void drawWorldsOf(Interface& interface, const char* head, const std::vector<std::string>& worlds,
                  PanelRequests& requests) {
  if (worlds.empty()) return;
  ImGui::TextDisabled("%s", head);
  for (const std::string& path : worlds) {
    ImGui::PushID((head + path).c_str());
    if (ImGui::Selectable(std::filesystem::path(path).filename().c_str())) requests.world = path;
    ImGui::PopID();
    drawTooltip(path);
    interface.name(std::string("world ") + head + " " + path);
  }
}

void drawPlaces(Interface& interface, const World& world, const std::vector<std::string>& beside, const Camera& at,
                PanelRequests& requests) {
  if (ImGui::BeginCombo("world", world.name.c_str(), ImGuiComboFlags_HeightLarge)) {
    drawWorldsOf(interface, "shown before", recentWorlds(), requests);
    drawWorldsOf(interface, "in this folder", beside, requests);
    ImGui::TextDisabled("that come with Orris");
    for (const std::string& name : shippedWorldNames()) {
      if (ImGui::Selectable(name.c_str(), name == world.name)) requests.world = name;
      interface.name("world " + name);
    }
    ImGui::EndCombo();
  }
  interface.name("world");
  if (ImGui::BeginCombo("camera", at.name.c_str())) {
    for (const Camera& camera : world.cameras) {
      if (ImGui::Selectable(camera.name.c_str(), camera.name == at.name))
        requests.camera = camera.name;
      interface.name("camera " + camera.name);
    }
    ImGui::EndCombo();
  }
  interface.name("camera");
  ImGui::TextUnformatted(fmt::format("{:.2f}, {:.2f}, {:.2f}, yaw {:.1f}, pitch {:.1f}",
                                     at.position.x, at.position.y, at.position.z, at.yaw, at.pitch)
                             .c_str());
}

}  // namespace

void drawScene(Interface& interface, PanelState& state, const PanelFacts& facts,
               PanelRequests& requests) {
  if (beginPanel("Scene", &state.scene, ImVec2(0.6f, 0.05f), ImVec2(0.36f, 0.5f),
                 ImVec2(22, 16))) {
    const World& world = facts.session.scene().world;
    drawTime(interface, world.environment, requests);
    drawPlaces(interface, world, facts.worldsBeside, facts.session.camera(), requests);
    bool paused = facts.paused, packOn = facts.packOn;
    if (ImGui::Checkbox("paused", &paused)) requests.pause = paused;
    interface.name("paused");
    ImGui::SameLine();
    if (ImGui::Button("one frame")) requests.singleFrame = true;
    interface.name("one frame");
    if (ImGui::Checkbox("pack on", &packOn)) requests.packOn = packOn;
    interface.name("pack on");
  }
  ImGui::End();
}

}  // namespace orris
