// What is wrong with the last edit, at the author's line.
#include "app/window/panel_parts.h"
#include "app/window/panels.h"
#include <orris/core/diagnostic.h>

namespace orris {

void drawProblems(Interface& interface, PanelState& state, const PanelFacts& facts) {
  const LoadOutcome& last = facts.pack.outcome();
  if (beginPanel("Not reloaded: the last good pack keeps running", &state.problems,
                 ImVec2(0.02f, 0.6f), ImVec2(0.96f, 0.38f))) {
    for (const Diagnostic& problem : last.problems) {
      const bool isError = problem.severity == Severity::Error;
      ImGui::PushStyleColor(ImGuiCol_Text, isError ? ImVec4(1, 0.5f, 0.45f, 1)
                                                   : ImVec4(1, 0.85f, 0.4f, 1));
      ImGui::TextUnformatted(formatDiagnostic(problem).c_str());
      ImGui::PopStyleColor();
      interface.name("problem");
      ImGui::Separator();
    }
  }
  ImGui::End();
}

}  // namespace orris
