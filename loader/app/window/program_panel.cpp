// The final source of a program beside the author's lines, and what made it.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/view/pack/program_text.h"
#include "app/window/panel_parts.h"
#include "app/window/panels.h"

namespace orris {
namespace {

const ImVec4 kHostColor(0.6f, 0.6f, 0.6f, 1);
const ImU32 kChosenColor = IM_COL32(70, 110, 60, 255);

void drawChoice(Interface& interface, const PanelFacts& facts, PanelRequests& requests) {
  const ProgramText& program = *facts.program;
  if (ImGui::BeginCombo("program", program.name.c_str(), ImGuiComboFlags_HeightLarge)) {
    for (const std::string& name : programTextNames(facts.session.renderer().pack())) {
      if (ImGui::Selectable(name.c_str(), name == program.name)) requests.program = name;
      interface.name("program " + name);
    }
    ImGui::EndCombo();
  }
  interface.name("program");
}

void drawFind(Interface& interface, PanelState& state, const ProgramText& program, PanelRequests& requests) {
  const bool entered = ImGui::InputTextWithHint("##find", "words, or /file.glsl:LINE of the author", &state.programWords,
                                                ImGuiInputTextFlags_EnterReturnsTrue);
  interface.name("find in program");
  ImGui::SameLine();
  const bool next = ImGui::Button("next");
  interface.name("next line");
  if (entered || next) {
    state.programLine = program.find(state.programWords, state.programLine);
    state.programMoved = true;
  }
  const bool chosen = state.programLine > 0 && std::size_t(state.programLine) <= program.lines.size();
  if (!chosen) return;
  const ProgramLine& line = program.lines[std::size_t(state.programLine) - 1];
  ImGui::TextUnformatted(fmt::format("line {} is of {}", state.programLine, authorText(line)).c_str());
  if (line.author.file.empty()) return;
  ImGui::SameLine();
  if (ImGui::SmallButton("open in editor")) requests.edit = line.author;
  interface.name("open in editor");
}

void drawMakers(const ProgramText& program) {
  std::vector<std::string> rules;
  for (const AppliedRule& rule : program.rules) rules.push_back(fmt::format("{} {}", rule.rule, rule.count));
  const auto list = [](const char* head, const std::vector<std::string>& words) {
    if (ImGui::TreeNode(head, "%s (%d)", head, int(words.size()))) {
      ImGui::TextWrapped("%s", fmt::format("{}", fmt::join(words, ", ")).c_str());
      ImGui::TreePop();
    }
  };
  list("rules applied", rules);
  list("options", program.options);
  list("files", program.includes);
}

void drawLines(Interface& interface, PanelState& state, const ProgramText& program) {
  if (!ImGui::BeginTable("text", 3, ImGuiTableFlags_ScrollX | ImGuiTableFlags_ScrollY | ImGuiTableFlags_SizingFixedFit |
                                        ImGuiTableFlags_BordersInnerV))
    return;
  if (state.programMoved && state.programLine > 0) {
    const float row = ImGui::GetTextLineHeightWithSpacing();
    ImGui::SetScrollY(std::max(0.0f, row * float(state.programLine - 4)));
  }
  state.programMoved = false;
  ImGuiListClipper clipper;
  clipper.Begin(int(program.lines.size()));
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const ProgramLine& line = program.lines[std::size_t(i)];
      ImGui::TableNextRow();
      ImGui::TableNextColumn();
      if (i + 1 == state.programLine) ImGui::TableSetBgColor(ImGuiTableBgTarget_RowBg0, kChosenColor);
      const std::string number = std::to_string(i + 1);
      if (ImGui::Selectable(number.c_str(), false, ImGuiSelectableFlags_SpanAllColumns)) state.programLine = i + 1;
      interface.name("line " + number);
      ImGui::TableNextColumn();
      ImGui::TextColored(kHostColor, "%s", line.text.empty() ? "" : authorText(line).c_str());
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(line.text.c_str());
    }
  }
  ImGui::EndTable();
}

}  // namespace

void drawProgram(Interface& interface, PanelState& state, const PanelFacts& facts, PanelRequests& requests) {
  if (facts.program == nullptr) return;
  if (beginPanel("Program", &state.program, ImVec2(0.02f, 0.05f), ImVec2(0.7f, 0.9f), ImVec2(30, 20))) {
    drawChoice(interface, facts, requests);
    drawFind(interface, state, *facts.program, requests);
    drawMakers(*facts.program);
    drawLines(interface, state, *facts.program);
  }
  ImGui::End();
}

}  // namespace orris
