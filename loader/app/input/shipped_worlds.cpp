#include "app/input/shipped_worlds.h"

#include <filesystem>
#include <set>

#include <orris/world/random_room.h>

namespace orris {
namespace {

namespace fs = std::filesystem;

/// The installed ones first: they are those of this version.
std::vector<fs::path> shelves() {
  std::error_code error;
  const fs::path command = fs::read_symlink("/proc/self/exe", error);
  return {command.parent_path().parent_path() / "share" / "orris" / "worlds", ORRIS_WORLDS};
}

bool isWorld(const fs::path& folder) {
  std::error_code error;
  return fs::is_regular_file(folder / "world.json", error);
}

}  // namespace

std::vector<std::string> shippedWorldNames() {
  std::set<std::string> names;
  for (const fs::path& shelf : shelves()) {
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(shelf, error)) {
      if (isWorld(entry.path())) names.insert(entry.path().filename().string());
    }
  }
  return {names.begin(), names.end()};
}

std::string findWorld(const std::string& request) {
  std::error_code error;
  const fs::path path(request);
  const bool plainName = path.filename() == path && path.extension().empty() && request != "." && request != "..";
  if (!plainName || fs::exists(path, error) || request.starts_with(kRandomRoom)) return request;
  for (const fs::path& shelf : shelves()) {
    if (isWorld(shelf / path)) return (shelf / path).string();
  }
  return "";
}

}  // namespace orris
