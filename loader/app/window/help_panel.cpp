// All keys.
#include "app/view/surface/key_bindings.h"
#include "app/window/panel_parts.h"
#include "app/window/panels.h"

namespace orris {

void drawHelp(Interface& interface, PanelState& state) {
  if (beginPanel("Keys", &state.help, ImVec2(0.25f, 0.1f), ImVec2(0.5f, 0.8f),
                 ImVec2(28, 16)) &&
      ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit)) {
    const auto row = [](const char* keys, const char* does) {
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(keys);
      ImGui::TableNextColumn();
      ImGui::TextWrapped("%s", does);
    };
    ImGui::TableSetupColumn("key");
    ImGui::TableSetupColumn("does", ImGuiTableColumnFlags_WidthStretch);
    for (const KeyHelp& help : otherKeys()) row(help.keys, help.does);
    for (const KeyRow& key : keyRows()) row(key.name, key.does);
    ImGui::EndTable();
    interface.name("keys");
  }
  ImGui::End();
}

}  // namespace orris
