#include "app/view/files/open_editor.h"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include <orris/core/files/read_file.h>
#include <orris/pack/files/text.h>

namespace orris {
namespace {

namespace fs = std::filesystem;

/// Editors that take FILE:LINE, and the flag that they want before it ("" for none).
struct PlaceEditor {
  const char* program;
  const char* flag;
};
constexpr PlaceEditor kPlaceEditors[] = {
    {"code", "-g"}, {"codium", "-g"}, {"subl", ""}, {"zed", ""}, {"hx", ""}, {"helix", ""}};

}  // namespace

std::vector<std::string> editorCommand(const std::string& editor, const std::string& file,
                                       int line) {
  std::vector<std::string> command = splitBlanks(editor);
  if (command.empty()) return {};
  const std::string program = fs::path(command.front()).filename().string();
  const auto row = std::ranges::find_if(
      kPlaceEditors, [&](const PlaceEditor& one) { return one.program == program; });
  if (row == std::end(kPlaceEditors)) {
    command.push_back(fmt::format("+{}", line));
    command.push_back(file);
    return command;
  }
  if (*row->flag != '\0') command.emplace_back(row->flag);
  command.push_back(fmt::format("{}:{}", file, line));
  return command;
}

std::string openInEditor(const std::string& packPath, const SourceLocation& at) {
  const char* editor = std::getenv("VISUAL");
  if (editor == nullptr || *editor == '\0') editor = std::getenv("EDITOR");
  if (editor == nullptr || *editor == '\0') return "set VISUAL to the editor that E shall open";
  const fs::path root = packPath;
  const fs::path shaders = fs::is_directory(root / "shaders") ? root / "shaders" : root;
  const fs::path file = fs::absolute(shaders / fs::path(at.file).relative_path());
  // The place may be asked for by a process that a pack has taken over.
  if (!liesBelow(packPath, file)) return fmt::format("{} is no file that an editor could open", file.string());
  const std::vector<std::string> command = editorCommand(editor, file.string(), at.line);
  if (command.empty()) return "set VISUAL to the editor that E shall open";
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  while (waitpid(-1, nullptr, WNOHANG) > 0) {  // editors that have ended
  }
  pid_t process = 0;
  const int failure = posix_spawnp(&process, words[0], nullptr, nullptr, words.data(), environ);
  return failure == 0 ? "" : fmt::format("{} cannot be started", command.front());
}

}  // namespace orris
