// Any buffer of the frame, after any pass: as a picture, or as a table of numbers.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <cstdint>

#include "app/view/pack/buffer_inspector.h"
#include "app/window/panel_parts.h"
#include "app/window/panels.h"

namespace orris {
namespace {

constexpr const char* kChannelNames[] = {"rgb", "r", "g", "b", "a"};
constexpr const char* kSideNames[] = {"result", "main", "alt"};
constexpr const char* kWordKinds[] = {"float", "int", "uint", "hexadecimal"};
constexpr int kWordsInRow = 4;
constexpr const char* kWholeFrame = "whole frame";

/// One of several texts; the one taken, "" for none.
std::string choose(Interface& interface, const char* label, const std::string& now,
                   const std::vector<std::string>& all, float letters) {
  std::string taken;
  ImGui::SetNextItemWidth(ImGui::GetFontSize() * letters);
  const bool open = ImGui::BeginCombo(label, now.c_str());
  interface.name(label);
  if (!open) return taken;
  for (const std::string& one : all) {
    if (ImGui::Selectable(one.c_str(), one == now)) taken = one;
    interface.name(std::string(label) + " " + one);
  }
  ImGui::EndCombo();
  return taken;
}

void chooseBuffer(Interface& interface, const FrameRenderer& renderer, BufferRequest& what) {
  const std::string buffer =
      choose(interface, "buffer", what.buffer, viewableBuffers(renderer), 10);
  if (!buffer.empty()) what = {.buffer = buffer, .step = what.step, .side = what.side};
  std::vector<std::string> passes = {kWholeFrame};
  for (const Step& step : renderer.schedule().frame)
    if (std::ranges::find(passes, step.name) == passes.end()) passes.push_back(step.name);
  ImGui::SameLine();
  const std::string pass =
      choose(interface, "after", what.step.empty() ? kWholeFrame : what.step, passes, 14);
  if (!pass.empty()) what.step = pass == kWholeFrame ? "" : pass;
}

void chooseLevel(Interface& interface, const BufferView& view, BufferRequest& what) {
  const float width = ImGui::GetFontSize() * 8;
  if (view.levels > 1) {
    ImGui::SetNextItemWidth(width);
    ImGui::SliderInt("mip", &what.level, 0, view.levels - 1, "%d", ImGuiSliderFlags_AlwaysClamp);
    interface.name("mip");
    ImGui::SameLine();
  }
  if (view.slices > 1) {
    ImGui::SetNextItemWidth(width);
    ImGui::SliderInt("slice", &what.slice, 0, view.slices - 1, "%d", ImGuiSliderFlags_AlwaysClamp);
    interface.name("slice");
    ImGui::SameLine();
  }
  for (int side = 0; side < 3; ++side) {
    if (side > 0) ImGui::SameLine();
    if (ImGui::RadioButton(kSideNames[side], int(what.side) == side))
      what.side = BufferRequest::Side(side);
    interface.name(kSideNames[side]);
  }
}

void choosePaint(Interface& interface, const BufferInspector& inspector, ValuePaint& how) {
  for (int i = 0; i <= std::min(inspector.facts().channels, 4); ++i) {
    if (i > 0) ImGui::SameLine();
    if (ImGui::RadioButton(kChannelNames[i], how.channel == i - 1)) how.channel = i - 1;
    interface.name(kChannelNames[i]);
  }
  ImGui::SameLine();
  ImGui::Checkbox("false colours", &how.falseColor);
  interface.name("false colours");
  ImGui::SameLine();
  ImGui::Checkbox("mark negative", &how.markNegative);
  interface.name("mark negative");
  bool own = how.range.has_value();
  if (ImGui::Checkbox("own range", &own)) {
    if (own) {
      how.range = inspector.range();
    } else {
      how.range.reset();
    }
  }
  interface.name("own range");
  ImGui::SameLine();
  float range[2] = {inspector.range().first, inspector.range().second};
  ImGui::SetNextItemWidth(ImGui::GetFontSize() * 14);
  const float speed = std::max((range[1] - range[0]) * 0.01f, 1e-6f);
  if (ImGui::DragFloat2("black, white", range, speed, 0, 0, "%.5g") && range[0] < range[1])
    how.range = std::pair(range[0], range[1]);
  interface.name("black, white");
}

void drawFacts(const BufferInspector& inspector) {
  const BufferView& view = *inspector.view();
  const ValueFacts& facts = inspector.facts();
  std::string text = fmt::format("{}{}  {}x{}", view.side.name, view.side.alt ? " alt" : " main",
                                 view.pixels.width, view.pixels.height);
  for (int c = 0; c < facts.channels; ++c)
    text += fmt::format("  {} {:.5g} to {:.5g}", kChannelNames[c + 1], facts.low[std::size_t(c)],
                        facts.high[std::size_t(c)]);
  ImGui::TextWrapped("%s", text.c_str());
  const auto marked = [](std::size_t count, const char* what, ImVec4 ink) {
    ImGui::SameLine();
    ImGui::TextColored(count > 0 ? ink : ImVec4(0.6f, 0.6f, 0.6f, 1), "%zu %s", count, what);
  };
  ImGui::TextUnformatted("texels:");
  marked(facts.nan, "NaN", ImVec4(1, 0.3f, 1, 1));
  marked(facts.infinite, "Inf", ImVec4(0, 1, 1, 1));
  marked(facts.negative, "negative", ImVec4(0.2f, 0.9f, 0.4f, 1));
}

/// As large as the room allows, texels square.
void drawTexture(Interface& interface, const BufferInspector& inspector) {
  const ImageF& pixels = inspector.view()->pixels;
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float zoom = std::min(room.x / float(pixels.width), room.y / float(pixels.height));
  if (zoom <= 0) return;
  const ImVec2 size(float(pixels.width) * zoom, float(pixels.height) * zoom);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::Image(reinterpret_cast<ImTextureID>(std::uintptr_t(inspector.texture().id())), size);
  interface.name("view");
  if (!ImGui::IsItemHovered()) return;
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const int x = std::clamp(int((mouse.x - corner.x) / zoom), 0, pixels.width - 1);
  const int y = std::clamp(int((mouse.y - corner.y) / zoom), 0, pixels.height - 1);
  std::vector<std::string> numbers;
  for (int c = 0; c < pixels.channels; ++c)
    numbers.push_back(fmt::format("{:.7g}", pixels.at(x, y)[c]));
  ImGui::SetTooltip("%s", fmt::format("{},{}: {}", x, y, fmt::join(numbers, "  ")).c_str());
}

std::string wordText(std::uint32_t word, int kind) {
  switch (kind) {
    case 0:
      return fmt::format("{:.7g}", std::bit_cast<float>(word));
    case 1:
      return fmt::format("{}", std::int32_t(word));
    case 2:
      return fmt::format("{}", word);
    default:
      return fmt::format("{:#010x}", word);
  }
}

void drawWords(Interface& interface, PanelState& state, const BufferView& view, BufferRequest& what) {
  ImGui::TextUnformatted(fmt::format("{} bytes", view.bytes).c_str());
  ImGui::SameLine();
  int offset = int(std::min<std::size_t>(view.offset, INT32_MAX));
  ImGui::SetNextItemWidth(ImGui::GetFontSize() * 10);
  if (ImGui::InputInt("from byte", &offset, kWordsInRow * 4, int(kViewWords) * 4))
    what.offset = std::size_t(std::clamp<long long>(offset, 0, (long long)view.bytes) & ~3LL);
  interface.name("from byte");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(ImGui::GetFontSize() * 8);
  ImGui::Combo("as", &state.wordKind, kWordKinds, int(std::size(kWordKinds)));
  interface.name("as");
  constexpr ImGuiTableFlags kFlags =
      ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerV | ImGuiTableFlags_ScrollY;
  if (!ImGui::BeginTable("words", kWordsInRow + 1, kFlags)) return;
  for (std::size_t i = 0; i < view.words.size(); ++i) {
    if (i % kWordsInRow == 0) {
      ImGui::TableNextColumn();
      ImGui::TextDisabled("%zu", view.offset + i * sizeof(std::uint32_t));
    }
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(wordText(view.words[i], state.wordKind).c_str());
  }
  ImGui::EndTable();
  interface.name("words");
}

}  // namespace

void drawBuffers(Interface& interface, PanelState& state, const PanelFacts& facts,
                 PanelRequests& requests) {
  if (beginPanel("Buffers", &state.buffers, ImVec2(0.02f, 0.05f), ImVec2(0.6f, 0.85f),
                 ImVec2(36, 26)) &&
      facts.inspector != nullptr) {
    const BufferInspector& inspector = *facts.inspector;
    ShownBuffer asked = inspector.asked();
    chooseBuffer(interface, facts.session.renderer(), asked.what);
    if (!inspector.view()) {
      ImGui::TextWrapped("%s", inspector.problem().c_str());
    } else if (inspector.view()->pixels.pixels.empty()) {
      drawWords(interface, state, *inspector.view(), asked.what);
    } else {
      chooseLevel(interface, *inspector.view(), asked.what);
      choosePaint(interface, inspector, asked.how);
      drawFacts(inspector);
      drawTexture(interface, inspector);
    }
    if (shownText(asked) != shownText(inspector.asked())) requests.show = asked;
  }
  ImGui::End();
}

}  // namespace orris
