// Small things that several panels draw.
#pragma once

#include <imgui.h>

#include <string_view>

namespace orris {

/// A window of a part of the display: place and size as fractions of it. It is no smaller than
/// `letters` of the font where the display is not. Follow with ImGui::End().
bool beginPanel(const char* title, bool* open, ImVec2 place, ImVec2 size,
                ImVec2 letters = ImVec2(0, 0));
/// A text with colour codes on one line.
void drawRichText(std::string_view text);
/// A tooltip for what was drawn last, with colour codes, wrapped.
void drawTooltip(std::string_view text);

}  // namespace orris
