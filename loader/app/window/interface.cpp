#include "app/window/interface.h"

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <filesystem>

#include <orris/gl/functions.h>

namespace orris {
namespace {

constexpr float kFontSize = 15;
constexpr const char* kFont = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
constexpr int kKeyCount = 512;

struct KeyPair {
  ImGuiKey theirs;
  int ours;
};
constexpr KeyPair kKeyPairs[] = {
    {ImGuiKey_Tab, GLFW_KEY_TAB},         {ImGuiKey_LeftArrow, GLFW_KEY_LEFT},
    {ImGuiKey_RightArrow, GLFW_KEY_RIGHT}, {ImGuiKey_UpArrow, GLFW_KEY_UP},
    {ImGuiKey_DownArrow, GLFW_KEY_DOWN},  {ImGuiKey_PageUp, GLFW_KEY_PAGE_UP},
    {ImGuiKey_PageDown, GLFW_KEY_PAGE_DOWN}, {ImGuiKey_Home, GLFW_KEY_HOME},
    {ImGuiKey_End, GLFW_KEY_END},         {ImGuiKey_Delete, GLFW_KEY_DELETE},
    {ImGuiKey_Backspace, GLFW_KEY_BACKSPACE}, {ImGuiKey_Enter, GLFW_KEY_ENTER},
    {ImGuiKey_Escape, GLFW_KEY_ESCAPE},   {ImGuiKey_A, GLFW_KEY_A},
    {ImGuiKey_C, GLFW_KEY_C},             {ImGuiKey_V, GLFW_KEY_V},
    {ImGuiKey_X, GLFW_KEY_X},             {ImGuiKey_Z, GLFW_KEY_Z}};

/// Letters of most European languages, and signs.
const ImWchar* letterRanges() {
  static const ImWchar kRanges[] = {0x20, 0x24F, 0x370, 0x52F, 0x2010, 0x205E, 0x2190, 0x22FF, 0};
  return kRanges;
}

}  // namespace

Interface::Interface(float scale) {
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // nothing is written that nobody asked for
  for (const KeyPair& pair : kKeyPairs) io.KeyMap[pair.theirs] = pair.ours;
  ImGui::StyleColorsDark();
  ImGui::GetStyle().ScaleAllSizes(scale);
  ImGui::GetStyle().Colors[ImGuiCol_WindowBg].w = 0.92f;
  if (std::filesystem::exists(kFont)) {
    io.Fonts->AddFontFromFileTTF(kFont, kFontSize * scale, nullptr, letterRanges());
  } else {
    ImFontConfig font;
    font.SizePixels = std::max(13.0f, 13.0f * scale);
    io.Fonts->AddFontDefault(&font);
  }
  usable_ = ImGui_ImplOpenGL3_Init("#version 330");
}

Interface::~Interface() {
  if (usable_) ImGui_ImplOpenGL3_Shutdown();
  ImGui::DestroyContext();
}

void Interface::feed(const ViewEvent& event) {
  ImGuiIO& io = ImGui::GetIO();
  switch (event.kind) {
    case ViewEvent::Kind::Key:
      if (event.code >= 0 && event.code < kKeyCount) io.KeysDown[event.code] = event.pressed;
      io.KeyCtrl = io.KeysDown[GLFW_KEY_LEFT_CONTROL] || io.KeysDown[GLFW_KEY_RIGHT_CONTROL];
      io.KeyShift = io.KeysDown[GLFW_KEY_LEFT_SHIFT] || io.KeysDown[GLFW_KEY_RIGHT_SHIFT];
      break;
    case ViewEvent::Kind::Text:
      io.AddInputCharacter(unsigned(event.code));
      break;
    case ViewEvent::Kind::Move:
      io.MousePos = ImVec2(float(event.x), float(event.y));
      break;
    case ViewEvent::Kind::Button:
      if (event.code < 0 || event.code > 2) break;
      held_[event.code] = event.pressed;
      justPressed_[event.code] |= event.pressed;
      break;
    case ViewEvent::Kind::Scroll:
      io.MouseWheel += float(event.y);
      break;
    case ViewEvent::Kind::Close:
      break;
  }
}

void Interface::begin(const std::vector<ViewEvent>& events, int width, int height,
                      double seconds) {
  for (const ViewEvent& event : events) feed(event);
  ImGuiIO& io = ImGui::GetIO();
  for (int i = 0; i < 3; ++i) io.MouseDown[i] = held_[i] || std::exchange(justPressed_[i], false);
  io.DisplaySize = ImVec2(float(std::max(width, 1)), float(std::max(height, 1)));
  io.DeltaTime = std::max(float(seconds), 1e-4f);
  ImGui_ImplOpenGL3_NewFrame();
  ImGui::NewFrame();
  building_.clear();
}

InputTaken Interface::taken() const {
  const ImGuiIO& io = ImGui::GetIO();
  return {.keys = io.WantTextInput, .mouse = io.WantCaptureMouse};
}

std::pair<double, double> Interface::mouse() const {
  const ImVec2 at = ImGui::GetIO().MousePos;
  return {at.x, at.y};
}

void Interface::name(const std::string& item) {
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  if (ImGui::IsItemVisible()) building_[item] = {low.x, low.y, high.x - low.x, high.y - low.y};
}

void Interface::end(unsigned framebuffer) {
  ImGui::Render();
  gl::BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  // Dear ImGui takes the program in use back afterwards; one that a reload has deleted is gone by then.
  gl::UseProgram(0);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  shown_ = std::exchange(building_, {});
}

}  // namespace orris
