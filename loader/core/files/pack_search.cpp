#include <orris/core/files/pack_search.h>

#include <algorithm>
#include <filesystem>

#include <orris/core/files/read_file.h>
#include <orris/core/files/zip_source.h>

namespace orris {
namespace {

namespace fs = std::filesystem;

constexpr int kPackLevels = 4;
constexpr int kPackEntries = 20000;

}  // namespace

std::vector<std::string> findPacks(const std::string& folder) {
  std::vector<std::string> packs;
  std::error_code error;
  fs::recursive_directory_iterator entry(
      folder, fs::directory_options::skip_permission_denied, error);
  for (int seen = 0; !error && entry != fs::recursive_directory_iterator() && seen < kPackEntries;
       entry.increment(error), ++seen) {
    const fs::path& path = entry->path();
    std::error_code unreadable;
    if (entry->is_symlink(unreadable)) continue;
    if (!entry->is_directory(unreadable)) {
      if (path.extension() == ".zip" && isPackZip(path.string())) packs.push_back(path.string());
      continue;
    }
    if (path.filename() == "shaders") packs.push_back(path.parent_path().string());
    if (path.filename() == "shaders" || isHiddenName(path.filename().native()) || entry.depth() + 1 >= kPackLevels)
      entry.disable_recursion_pending();
  }
  std::sort(packs.begin(), packs.end());
  return packs;
}

}  // namespace orris
