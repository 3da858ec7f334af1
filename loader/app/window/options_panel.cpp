// The pack's own options screens.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <fmt/format.h>

#include <algorithm>

#include "app/window/option_pages.h"
#include "app/window/panel_parts.h"
#include "app/window/panels.h"
#include "app/window/rich_text.h"

namespace orris {
namespace {

const ImVec4 kChangedColor(1, 0.79f, 0.29f, 1);
const ImVec4 kLiveColor(0.5f, 0.85f, 1, 1);
const ImVec4 kMissingColor(0.6f, 0.6f, 0.6f, 1);

class OptionsPanel {
 public:
  OptionsPanel(Interface& interface, PanelState& state, const PanelFacts& facts,
               PanelRequests& requests)
      : interface_(interface), state_(state), facts_(facts), requests_(requests),
        pack_(facts.pack.session().asked()), live_(facts.pack.liveReasons(facts.exact)) {}

  void draw() {
    drawHead();
    const std::string screen = state_.screens.empty() ? "" : state_.screens.back();
    const OptionPage page =
        state_.search.empty() ? optionPage(pack_, screen) : searchOptions(pack_, state_.search);
    drawRichText(page.title);
    ImGui::Separator();
    ImGui::BeginChild("page");
    if (page.cells.empty()) ImGui::TextUnformatted("nothing here");
    if (!page.cells.empty() && ImGui::BeginTable("cells", page.columns, ImGuiTableFlags_SizingStretchSame)) {
      for (std::size_t i = 0; i < page.cells.size(); ++i) {
        ImGui::TableNextColumn();
        ImGui::PushID(int(i));
        drawCell(page.cells[i]);
        ImGui::PopID();
      }
      ImGui::EndTable();
    }
    ImGui::EndChild();
  }

 private:
  void drawHead() {
    if (button("Back", !state_.screens.empty() || !state_.search.empty())) {
      if (state_.search.empty()) {
        state_.screens.pop_back();
      } else {
        state_.search.clear();
      }
    }
    ImGui::SameLine();
    if (button("Reset all", !pack_.values.empty())) requests_.resetAll = true;
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1);
    ImGui::InputTextWithHint("##search", "search name, label, comment", &state_.search);
    interface_.name("Search");
    const LoadOutcome& last = facts_.pack.outcome();
    const std::string file = facts_.pack.optionFile();
    if (const std::string doing = facts_.pack.doing(); !doing.empty()) {
      ImGui::TextUnformatted((doing + ": building ...").c_str());
    } else if (last.cause.empty()) {
      ImGui::TextUnformatted(fmt::format("{} changed; saved to {}", pack_.values.size(), file).c_str());
    } else {
      ImGui::TextUnformatted(
          fmt::format("{} changed; {}: {} program{} built in {:.2f} s{}", pack_.values.size(),
                      last.cause, last.report.programsBuilt,
                      last.report.programsBuilt == 1 ? "" : "s", last.seconds,
                      last.succeeded ? "" : ", failed: the last good pack runs")
              .c_str());
    }
  }

  bool button(const char* label, bool enabled) {
    ImGui::BeginDisabled(!enabled);
    const bool pressed = ImGui::Button(label);
    interface_.name(label);
    ImGui::EndDisabled();
    return pressed;
  }

  void drawCell(const OptionCell& cell) {
    switch (cell.kind) {
      case OptionCell::Kind::Empty:
        return ImGui::Dummy(ImVec2(1, ImGui::GetFrameHeight()));
      case OptionCell::Kind::Missing:
        ImGui::TextColored(kMissingColor, "%s: no such option", cell.name.c_str());
        return;
      case OptionCell::Kind::Screen:
        return drawScreen(cell);
      case OptionCell::Kind::Profile:
        return drawProfile(cell);
      case OptionCell::Kind::Slider:
        return drawSlider(cell);
      case OptionCell::Kind::Boolean:
      case OptionCell::Kind::Choice:
        return drawChoice(cell);
    }
  }

  /// A button with a coloured label left and a value right. 1 left click, 2 right click.
  int labelButton(const OptionCell& cell, const char* id) {
    const ImVec2 at = ImGui::GetCursorPos();
    const bool left = ImGui::Button(id, ImVec2(-1, 0));
    const bool right = ImGui::IsItemClicked(ImGuiMouseButton_Right);
    const ImVec2 after = ImGui::GetCursorPos();
    const float width = ImGui::GetItemRectSize().x;
    drawTooltip(tooltipOf(cell));
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const float pad = ImGui::GetStyle().FramePadding.x;
    const std::string value = withoutCodes(cell.valueLabel);
    const float valueWidth = ImGui::CalcTextSize(value.c_str()).x;
    ImGui::PushClipRect(low, ImVec2(std::max(low.x, high.x - valueWidth - 3 * pad), high.y), true);
    ImGui::SetCursorPos(ImVec2(at.x + pad, at.y + ImGui::GetStyle().FramePadding.y));
    drawLabel(cell);
    ImGui::PopClipRect();
    ImGui::SetCursorPos(ImVec2(at.x + std::max(pad, width - valueWidth - pad),
                               at.y + ImGui::GetStyle().FramePadding.y));
    if (!cell.valueLabel.empty()) drawRichText(cell.valueLabel);
    ImGui::SetCursorPos(after);
    return left ? 1 : right ? 2 : 0;
  }

  static void drawLabel(const OptionCell& cell) {
    const ImVec4 color = cell.changed ? kChangedColor : kMissingColor;
    if (cell.changed || cell.labelMissing) {
      ImGui::TextColored(color, "%s%s", cell.changed ? "* " : "", withoutCodes(cell.label).c_str());
    } else {
      drawRichText(cell.label);
    }
  }

  std::string tooltipOf(const OptionCell& cell) const {
    // The label may not fit into its cell.
    std::string text = withoutCodes(cell.label) + ": " + withoutCodes(cell.valueLabel);
    if (cell.kind == OptionCell::Kind::Screen) text = withoutCodes(cell.label);
    const auto add = [&](const std::string& line) { text += (text.empty() ? "" : "\n\n") + line; };
    if (!cell.comment.empty()) add(cell.comment);
    if (cell.labelMissing && cell.kind != OptionCell::Kind::Screen)
      add("no text option." + cell.name + " in the language file");
    if (cell.kind == OptionCell::Kind::Slider && live_ != nullptr) {
      const auto found = live_->find(cell.name);
      if (found != live_->end())
        add(found->second.empty() ? "live: the picture follows while it is dragged, nothing is built"
                                  : "not live: " + found->second);
    }
    if (const Option* option = pack_.options.find(cell.name); option != nullptr && cell.changed)
      add(fmt::format("default: {}; shift and click to reset",
                      withoutCodes(valueLabelOf(pack_, *option, option->defaultValue))));
    return text;
  }

  void drawScreen(const OptionCell& cell) {
    OptionCell shown = cell;
    shown.valueLabel = ">";
    if (labelButton(shown, "##screen") == 1) {
      state_.search.clear();
      state_.screens.push_back(cell.name);
    }
    interface_.name("[" + cell.name + "]");
  }

  void drawProfile(const OptionCell& cell) {
    const int clicked = labelButton(cell, "##profile");
    interface_.name("<profile>");
    if (clicked == 0 || cell.values.empty()) return;
    const auto at = std::ranges::find(cell.values, cell.value);
    const int count = int(cell.values.size());
    const int index = at == cell.values.end() ? (clicked == 1 ? -1 : count)
                                              : int(at - cell.values.begin());
    const int step = clicked == 1 ? 1 : -1;
    requests_.profile = cell.values[std::size_t((index + step + count) % count)];
  }

  void drawChoice(const OptionCell& cell) {
    const int clicked = labelButton(cell, "##choice");
    interface_.name(cell.name);
    const Option* option = pack_.options.find(cell.name);
    if (clicked == 0 || option == nullptr) return;
    requests_.set[cell.name] = ImGui::GetIO().KeyShift
                                   ? ""
                                   : valueBeside(*option, cell.value, clicked == 1 ? 1 : -1);
  }

  bool canBeLive(const std::string& option) const {
    if (live_ == nullptr) return pack_.live.contains(option);
    const auto found = live_->find(option);
    return found != live_->end() && found->second.empty();
  }

  /// Taken over when it is let go, but a live option while it is dragged, too.
  void drawSlider(const OptionCell& cell) {
    const auto found = std::ranges::find(cell.values, cell.value);
    int index = found == cell.values.end() ? 0 : int(found - cell.values.begin());
    if (const auto dragged = state_.dragged.find(cell.name); dragged != state_.dragged.end())
      index = dragged->second;
    const Option* option = pack_.options.find(cell.name);
    if (option == nullptr || cell.values.empty()) return;
    const std::string format =
        withoutCodes(cell.label) + ": " +
        withoutCodes(valueLabelOf(pack_, *option, cell.values[std::size_t(index)]));
    ImGui::SetNextItemWidth(-1);
    // The text is no format of numbers: a per cent sign in it must stay one.
    ImGui::SliderInt("##slider", &index, 0, int(cell.values.size()) - 1, "",
                     ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput);
    interface_.name(cell.name);
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const ImVec2 size = ImGui::CalcTextSize(format.c_str());
    const bool live = canBeLive(cell.name);
    const ImVec4 color = cell.changed ? kChangedColor
                         : live       ? kLiveColor
                                      : ImGui::GetStyle().Colors[ImGuiCol_Text];
    ImGui::PushClipRect(low, high, true);
    ImGui::GetWindowDrawList()->AddText(
        ImVec2(std::max(low.x, (low.x + high.x - size.x) / 2), low.y + ImGui::GetStyle().FramePadding.y),
        ImGui::GetColorU32(color), format.c_str());
    ImGui::PopClipRect();
    const bool released = ImGui::IsItemDeactivated();
    if (ImGui::IsItemActive()) {
      const auto [entry, first] = state_.dragged.try_emplace(cell.name, -1);
      if (live && entry->second != index) requests_.drag[cell.name] = cell.values[std::size_t(index)];
      entry->second = index;
    } else if (released && state_.dragged.erase(cell.name) > 0) {
      const std::string& value = cell.values[std::size_t(index)];
      if (value != cell.value) requests_.set[cell.name] = value;
    }
    if (ImGui::IsItemClicked() && ImGui::GetIO().KeyShift) requests_.set[cell.name] = "";
    drawTooltip(tooltipOf(cell));
  }

  Interface& interface_;
  PanelState& state_;
  const PanelFacts& facts_;
  PanelRequests& requests_;
  const ShaderPack& pack_;
  const std::map<std::string, std::string>* live_;  ///< nullptr: not known yet
};

}  // namespace

void drawOptions(Interface& interface, PanelState& state, const PanelFacts& facts,
                 PanelRequests& requests) {
  if (beginPanel("Options", &state.options, ImVec2(0.04f, 0.05f), ImVec2(0.6f, 0.9f),
                 ImVec2(24, 16)))
    OptionsPanel(interface, state, facts, requests).draw();
  ImGui::End();
}

}  // namespace orris
