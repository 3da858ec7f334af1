#include "app/window/panel_parts.h"

#include <algorithm>
#include <string>

#include "app/window/rich_text.h"

namespace orris {
namespace {

ImVec4 inkOf(const TextRun& run) {
  constexpr float kMost = 255;
  return ImVec4(float(run.color >> 16 & 255u) / kMost, float(run.color >> 8 & 255u) / kMost,
                float(run.color & 255u) / kMost, 1);
}

}  // namespace

bool beginPanel(const char* title, bool* open, ImVec2 place, ImVec2 size, ImVec2 letters) {
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const float letter = ImGui::GetFontSize();
  const ImVec2 taken(std::min(std::max(display.x * size.x, letters.x * letter), display.x),
                     std::min(std::max(display.y * size.y, letters.y * letter), display.y));
  ImGui::SetNextWindowPos(ImVec2(std::min(display.x * place.x, display.x - taken.x),
                                 std::min(display.y * place.y, display.y - taken.y)),
                          ImGuiCond_Appearing);
  ImGui::SetNextWindowSize(taken, ImGuiCond_Appearing);
  return ImGui::Begin(title, open, ImGuiWindowFlags_NoCollapse);
}

void drawRichText(std::string_view text) {
  bool first = true;
  for (const TextRun& run : textRuns(text)) {
    if (!first) ImGui::SameLine(0, 0);
    first = false;
    ImGui::PushStyleColor(ImGuiCol_Text, inkOf(run));
    ImGui::TextUnformatted(run.text.c_str());
    ImGui::PopStyleColor();
  }
}

void drawTooltip(std::string_view text) {
  constexpr float kLettersWide = 40;
  if (text.empty() || !ImGui::IsItemHovered()) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(ImGui::GetFontSize() * kLettersWide);
  ImGui::TextUnformatted(withoutCodes(text).c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

}  // namespace orris
