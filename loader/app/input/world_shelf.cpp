#include "app/input/world_shelf.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include <orris/core/limits.h>
#include <orris/core/files/read_file.h>
#include <orris/core/files/replace_file.h>
#include <orris/pack/files/text.h>

namespace orris {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostRecent = 10;
constexpr std::size_t kMostBeside = 200;
constexpr std::size_t kMostBytes = 1 << 16;

bool holdsWorld(const fs::path& folder) {
  std::error_code error;
  return fs::is_regular_file(folder / "world.json", error) || fs::is_regular_file(folder / "level.dat", error);
}

fs::path findRecentFile() {
  const char* state = std::getenv("XDG_STATE_HOME");
  if (state != nullptr && *state == '/') return fs::path(state) / "orris" / "recent-worlds";
  const char* home = std::getenv("HOME");
  return home != nullptr && *home == '/' ? fs::path(home) / ".local/state/orris/recent-worlds" : fs::path();
}

std::string absoluteOf(const std::string& world) {
  std::error_code error;
  fs::path path = fs::absolute(world, error).lexically_normal();
  if (!path.has_filename()) path = path.parent_path();
  return path.string();
}

}  // namespace

std::vector<std::string> worldsBeside(const std::string& world) {
  std::error_code error;
  std::vector<std::string> found;
  if (!fs::exists(world, error)) return found;
  for (fs::directory_iterator it(fs::path(absoluteOf(world)).parent_path(), error), end;
       !error && it != end && found.size() < kMostBeside; it.increment(error))
    if (holdsWorld(it->path())) found.push_back(it->path().string());
  std::ranges::sort(found);
  return found;
}

const std::string& recentWorldsFile() {
  static const std::string path = [] {
    const fs::path file = findRecentFile();
    std::error_code error;
    if (!file.empty()) fs::create_directories(file.parent_path(), error);
    return file.string();
  }();
  return path;
}

std::vector<std::string> recentWorlds() {
  ReadFault fault;
  const auto text = readFile(recentWorldsFile(), kMostBytes, fault);
  std::vector<std::string> worlds;
  for (std::string& line : splitLines(text.value_or(""))) {
    std::error_code error;
    if (worlds.size() < kMostRecent && line.starts_with('/') && fs::exists(line, error))
      worlds.push_back(std::move(line));
  }
  return worlds;
}

void noteRecentWorld(const std::string& world) {
  const std::string& file = recentWorldsFile();
  std::error_code error;
  if (file.empty() || !fs::exists(world, error)) return;
  const std::string path = absoluteOf(world);
  if (path.find('\n') != std::string::npos) return;
  std::vector<std::string> worlds = recentWorlds();
  std::erase(worlds, path);
  worlds.insert(worlds.begin(), path);
  worlds.resize(std::min(worlds.size(), kMostRecent));
  std::string text;
  for (const std::string& one : worlds) text += one + "\n";
  (void)replaceFile(file, text);
}

}  // namespace orris
