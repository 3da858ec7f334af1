// The passes of the frame in order: times, what each writes and reads, and a pixel through all of them.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "app/window/panel_parts.h"
#include "app/window/panels.h"

namespace orris {
namespace {

constexpr ImGuiTableFlags kTable = ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerV |
                                   ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_ScrollY;

std::string sideName(const BufferSide& side) { return side.name + (side.alt ? " alt" : ""); }

void textCell(const std::string& text) {
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(text.c_str());
}

std::string sidesText(const std::vector<BufferSide>& sides) {
  std::vector<std::string> names;
  for (const BufferSide& side : sides) names.push_back(sideName(side));
  return fmt::format("{}", fmt::join(names, ", "));
}

/// A click on a buffer shows it as it is after the pass.
void drawWrites(Interface& interface, const FrameRenderer& renderer, const Step& step,
                const std::string& label, PanelRequests& requests) {
  ImGui::TableNextColumn();
  bool first = true;
  for (const BufferSide& side : renderer.writesOf(step)) {
    if (!std::exchange(first, false)) ImGui::SameLine();
    const std::string item = side.name + "@" + label;
    ImGui::PushID(item.c_str());
    if (ImGui::SmallButton(sideName(side).c_str())) {
      ShownBuffer& show = requests.show.emplace();
      show.what = {.buffer = side.name, .step = step.name};
    }
    ImGui::PopID();
    interface.name(item);
  }
}

/// Of the cell that was drawn last: while the mouse is over it, the times of the last frames.
void drawHistory(const StepHistory& times, const std::string& step) {
  const auto found = times.steps.find(step);
  if (found == times.steps.end() || !ImGui::IsItemHovered()) return;
  std::vector<float> milliseconds;
  for (const StepTime& time : found->second) milliseconds.push_back(float(time.seconds * 1e3));
  const float most = *std::ranges::max_element(milliseconds);
  ImGui::BeginTooltip();
  ImGui::TextUnformatted(fmt::format("{}, 0 to {:.3f} ms", step, most).c_str());
  ImGui::PlotHistogram("##history", milliseconds.data(), int(milliseconds.size()), 0, nullptr, 0, most,
                       ImVec2(ImGui::GetFontSize() * 16, ImGui::GetFontSize() * 4));
  ImGui::EndTooltip();
}

void drawSteps(Interface& interface, const PanelFacts& facts, PanelRequests& requests) {
  const FrameRenderer& renderer = facts.session.renderer();
  const std::vector<std::string> names = stepLabels(renderer.schedule());
  double total = 0;
  for (const std::string& name : names) total += facts.times.median(name).passed;
  ImGui::TextUnformatted(fmt::format("median of the last {} frames; all passes {:.2f} ms",
                                     StepHistory::kFrames, total).c_str());
  const bool hasCard = std::ranges::any_of(
      names, [&](const std::string& name) { return facts.times.median(name).card.has_value(); });
  const ImVec2 size(0, ImGui::GetContentRegionAvail().y * (facts.pixel || facts.checksFinite ? 0.5f : 0.8f));
  if (!ImGui::BeginTable("steps", hasCard ? 6 : 5, kTable | ImGuiTableFlags_ScrollX, size)) return;
  ImGui::TableSetupScrollFreeze(0, 1);
  for (const char* head : {"pass", "ms", "processor ms", "card ms", "writes", "reads"})
    if (hasCard || std::string_view(head) != "card ms") ImGui::TableSetupColumn(head);
  ImGui::TableHeadersRow();
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Step& step = renderer.schedule().frame[i];
    const StepHistory::Median times = facts.times.median(names[i]);
    textCell(names[i]);
    textCell(fmt::format("{:.3f}", times.passed));
    interface.name("ms of " + names[i]);
    drawHistory(facts.times, names[i]);
    textCell(fmt::format("{:.3f}", times.processors));
    if (hasCard) textCell(fmt::format("{:.3f}", times.card.value_or(0)));
    drawWrites(interface, renderer, step, names[i], requests);
    textCell(sidesText(renderer.readsOf(step)));
  }
  ImGui::EndTable();
  interface.name("steps");
}

void drawFiniteCheck(Interface& interface, const PanelFacts& facts, PanelRequests& requests) {
  bool checks = facts.checksFinite;
  if (ImGui::Checkbox("find NaN and Inf", &checks)) requests.checkFinite = checks;
  interface.name("find NaN and Inf");
  if (checks && facts.notFinite.empty()) ImGui::TextUnformatted("none so far");
  for (const Diagnostic& found : facts.notFinite) {
    ImGui::TextWrapped("%s", found.message.c_str());
    for (const std::string& note : found.notes) ImGui::TextWrapped("%s", note.c_str());
  }
}

void drawPixel(Interface& interface, const PanelFacts& facts, PanelRequests& requests) {
  if (!facts.pixel) {
    ImGui::TextUnformatted("click on the picture: the pixel after every pass that wrote it");
    return;
  }
  ImGui::TextUnformatted(fmt::format("pixel {},{}", facts.pixel->first, facts.pixel->second).c_str());
  ImGui::SameLine();
  if (ImGui::SmallButton("stop probing")) requests.dropPixel = true;
  interface.name("stop probing");
  if (!ImGui::BeginTable("pixel", 3, kTable)) return;
  for (const ProbeValue& value : facts.probe) {
    std::vector<std::string> numbers;
    for (const float number : value.value) numbers.push_back(fmt::format("{:.6g}", number));
    textCell(value.step);
    textCell(sideName(value.side));
    textCell(fmt::format("{}", fmt::join(numbers, "  ")));
  }
  ImGui::EndTable();
  interface.name("pixel");
}

}  // namespace

std::vector<std::string> stepLabels(const Schedule& schedule) {
  std::map<std::string, int> met;
  std::vector<std::string> labels;
  for (const Step& step : schedule.frame) {
    const int count = ++met[step.name];
    labels.push_back(count == 1 ? step.name : fmt::format("{} ({})", step.name, count));
  }
  return labels;
}

void StepHistory::add(const Schedule& schedule, const std::vector<StepTime>& times) {
  // Steps before the frame (setup) and steps left out for the driver have no place in the list.
  if (times.size() != schedule.frame.size()) return;
  const std::vector<std::string> labels = stepLabels(schedule);
  for (std::size_t i = 0; i < times.size(); ++i) {
    const StepTime& time = times[i];
    std::deque<StepTime>& history = steps[labels[i]];
    history.push_back(time);
    if (history.size() > kFrames) history.pop_front();
  }
}

StepHistory::Median StepHistory::median(const std::string& step) const {
  const auto found = steps.find(step);
  if (found == steps.end() || found->second.empty()) return {};
  const auto middle = [&](const auto& secondsOf) {
    std::vector<double> values;
    for (const StepTime& time : found->second) values.push_back(secondsOf(time) * 1e3);
    const auto at = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), at, values.end());
    return *at;
  };
  Median all{.passed = middle([](const StepTime& time) { return time.seconds; }),
             .processors = middle([](const StepTime& time) { return time.processorSeconds; }),
             .card = {}};
  if (found->second.front().cardSeconds)
    all.card = middle([](const StepTime& time) { return time.cardSeconds.value_or(0); });
  return all;
}

void drawPasses(Interface& interface, PanelState& state, const PanelFacts& facts,
                PanelRequests& requests) {
  if (beginPanel("Passes", &state.passes, ImVec2(0.45f, 0.05f), ImVec2(0.53f, 0.9f))) {
    drawSteps(interface, facts, requests);
    drawFiniteCheck(interface, facts, requests);
    drawPixel(interface, facts, requests);
  }
  ImGui::End();
}

}  // namespace orris
