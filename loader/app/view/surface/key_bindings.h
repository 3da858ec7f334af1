// The keys of the window: one table for what they do, for the help on screen and for scripts.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace orris {

enum class ViewCommand {
  Help,
  Options,
  Scene,
  Passes,
  Buffers,
  Program,
  Compare,
  Flicker,
  Editor,
  Reload,
  NextProfile,
  PackOnOff,
  Screenshot,
  Pause,
  SingleFrame,
  FullScreen,
};

struct KeyRow {
  int key;  ///< GLFW's number
  ViewCommand command;
  const char* name;  ///< "F1"
  const char* does;  ///< one line for people
};
std::span<const KeyRow> keyRows();

/// Keys that are held or stand for many, for the help: {"W A S D", "fly"}.
struct KeyHelp {
  const char* keys;
  const char* does;
};
std::span<const KeyHelp> otherKeys();

/// The number of a key by its name in scripts: "A", "5", "F2", "Escape", "Space"; whatever the case.
std::optional<int> keyNamed(std::string_view name);

}  // namespace orris
