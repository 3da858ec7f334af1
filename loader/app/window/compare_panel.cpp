// Two option sets beside each other: how they are shown, what they cost, where their values differ.
#include <fmt/format.h>

#include "app/view/pack/set_comparison.h"
#include "app/window/panel_parts.h"
#include "app/window/panels.h"

namespace orris {
namespace {

constexpr double kMilliseconds = 1e3;

void drawModes(Interface& interface, SetComparison& comparison) {
  for (std::size_t i = 0; i < kCompareModes.size(); ++i) {
    if (i > 0) ImGui::SameLine();
    const auto mode = CompareMode(i);
    if (ImGui::RadioButton(kCompareModes[i], comparison.mode == mode)) comparison.mode = mode;
    interface.name(kCompareModes[i]);
  }
  if (comparison.mode == CompareMode::Wipe) {
    ImGui::SetNextItemWidth(-1);
    ImGui::SliderFloat("##wipe", &comparison.wipe, 0, 1, "A to here: %.2f", ImGuiSliderFlags_AlwaysClamp);
    interface.name("wipe position");
  }
  if (comparison.mode == CompareMode::Flicker)
    ImGui::TextUnformatted(comparison.showsB ? "B is shown; X shows A" : "A is shown; X shows B");
}

/// What each costs stands in its picture.
void drawCosts(const SetComparison& comparison) {
  const auto [a, b] = comparison.costs();
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const float letter = ImGui::GetFontSize();
  const auto write = [&](float x, float y, const char* name, double seconds) {
    const std::string text = fmt::format("{}  {:.1f} ms", name, seconds * kMilliseconds);
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    list.AddRectFilled(ImVec2(x, y), ImVec2(x + size.x + letter, y + size.y + letter / 2), IM_COL32(0, 0, 0, 190));
    list.AddText(ImVec2(x + letter / 2, y + letter / 4), IM_COL32_WHITE, text.c_str());
  };
  const bool side = comparison.mode == CompareMode::Side;
  const float y = side ? display.y * 0.25f : display.y - 2 * letter;
  if (comparison.mode != CompareMode::Flicker || !comparison.showsB) write(0, y, "A", a);
  if (comparison.mode == CompareMode::Flicker && !comparison.showsB) return;
  const bool alone = comparison.mode == CompareMode::Flicker;
  write(alone ? 0 : side ? display.x / 2 : display.x - 9 * letter, y, "B", b);
}

void drawValues(Interface& interface, const SetComparison& comparison, const ShaderPack& pack,
                PanelRequests& requests) {
  const auto values = comparison.differingValues(pack);
  if (values.empty()) {
    ImGui::TextWrapped("A and B have the same values: change A under O, or with P");
    return;
  }
  if (ImGui::Button("take B")) requests.values = comparison.valuesOfB();
  interface.name("take B");
  if (!ImGui::BeginTable("values", 3, ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY)) return;
  for (const char* head : {"option", "A", "B"}) ImGui::TableSetupColumn(head);
  ImGui::TableHeadersRow();
  for (const auto& [name, pair] : values) {
    for (const std::string& text : {name, pair.first, pair.second}) {
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(text.c_str());
    }
  }
  ImGui::EndTable();
}

}  // namespace

void drawCompare(Interface& interface, PanelState& state, const PanelFacts& facts, PanelRequests& requests) {
  if (facts.comparison == nullptr) return;
  drawCosts(*facts.comparison);
  if (beginPanel("Compare", &state.compare, ImVec2(0.3f, 0.02f), ImVec2(0.4f, 0.2f), ImVec2(24, 8))) {
    drawModes(interface, *facts.comparison);
    drawValues(interface, *facts.comparison, facts.pack.session().asked(), requests);
  }
  ImGui::End();
}

}  // namespace orris
