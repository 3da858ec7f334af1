#include "app/view/surface/key_bindings.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cctype>

#include <orris/pack/files/text.h>

namespace orris {
namespace {

constexpr KeyRow kKeyRows[] = {
    {GLFW_KEY_F1, ViewCommand::Help, "F1", "this list"},
    {GLFW_KEY_O, ViewCommand::Options, "O", "the pack's options; a change is saved to its option file"},
    {GLFW_KEY_T, ViewCommand::Scene, "T", "time of day, weather, world, camera"},
    {GLFW_KEY_F3, ViewCommand::Passes, "F3", "the passes with their times; click on a pixel to probe it"},
    {GLFW_KEY_F4, ViewCommand::Buffers, "F4", "any buffer after any pass, as picture or numbers"},
    {GLFW_KEY_F5, ViewCommand::Program, "F5", "the final source of a program and the author's lines"},
    {GLFW_KEY_C, ViewCommand::Compare, "C", "keep the options as B and compare; again to end"},
    {GLFW_KEY_X, ViewCommand::Flicker, "X", "A or B, while sets are compared by flicker"},
    {GLFW_KEY_E, ViewCommand::Editor, "E", "open $VISUAL at the first error"},
    {GLFW_KEY_R, ViewCommand::Reload, "R", "reload the pack from its files"},
    {GLFW_KEY_P, ViewCommand::NextProfile, "P", "next profile of the pack"},
    {GLFW_KEY_K, ViewCommand::PackOnOff, "K", "pack on and off"},
    {GLFW_KEY_F2, ViewCommand::Screenshot, "F2", "write the picture to orris-0001.png and so on"},
    {GLFW_KEY_COMMA, ViewCommand::Pause, ",", "pause and go on"},
    {GLFW_KEY_PERIOD, ViewCommand::SingleFrame, ".", "one frame, then pause"},
    {GLFW_KEY_F11, ViewCommand::FullScreen, "F11", "full screen on and off"},
};

constexpr KeyHelp kOtherKeys[] = {
    {"W A S D", "fly; the mouse wheel sets the speed"},
    {"Space, Shift", "up, down"},
    {"Click, Esc", "take the mouse to look around; give it back, close what is open, end"},
    {"1 to 9", "named cameras of the world, in its order"},
};

struct NamedKey {
  const char* name;
  int key;
};
constexpr NamedKey kNamedKeys[] = {
    {"escape", GLFW_KEY_ESCAPE},   {"enter", GLFW_KEY_ENTER},
    {"tab", GLFW_KEY_TAB},         {"backspace", GLFW_KEY_BACKSPACE},
    {"delete", GLFW_KEY_DELETE},   {"space", GLFW_KEY_SPACE},
    {"left", GLFW_KEY_LEFT},       {"right", GLFW_KEY_RIGHT},
    {"up", GLFW_KEY_UP},           {"down", GLFW_KEY_DOWN},
    {"pageup", GLFW_KEY_PAGE_UP},  {"pagedown", GLFW_KEY_PAGE_DOWN},
    {"home", GLFW_KEY_HOME},       {"end", GLFW_KEY_END},
    {"shift", GLFW_KEY_LEFT_SHIFT}, {"control", GLFW_KEY_LEFT_CONTROL},
    {"alt", GLFW_KEY_LEFT_ALT},    {".", GLFW_KEY_PERIOD},
    {",", GLFW_KEY_COMMA}};

constexpr int kFunctionKeys = 12;

}  // namespace

std::span<const KeyRow> keyRows() { return kKeyRows; }

std::span<const KeyHelp> otherKeys() { return kOtherKeys; }

std::optional<int> keyNamed(std::string_view name) {
  const std::string word = lowerCase(std::string(name));
  // GLFW numbers letters and digits as ASCII does, letters by their capitals.
  if (word.size() == 1 && std::isalnum(static_cast<unsigned char>(word[0])) != 0)
    return std::toupper(static_cast<unsigned char>(word[0]));
  for (int i = 1; i <= kFunctionKeys; ++i)
    if (word == "f" + std::to_string(i)) return GLFW_KEY_F1 + i - 1;
  const auto found = std::ranges::find(kNamedKeys, word, &NamedKey::name);
  if (found == std::end(kNamedKeys)) return std::nullopt;
  return found->key;
}

}  // namespace orris
