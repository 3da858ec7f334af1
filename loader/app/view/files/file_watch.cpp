#include "app/view/files/file_watch.h"

#include <sys/stat.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include <orris/core/files/replace_file.h>

namespace orris {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxDepth = 32;

std::int64_t nanoseconds(const timespec& time) {
  return std::int64_t(time.tv_sec) * 1'000'000'000 + time.tv_nsec;
}

/// Calls `visit` for everything below a folder; no link is followed.
template <class Visit>
void walk(const fs::path& folder, const Visit& visit) {
  std::error_code error;
  const auto options = fs::directory_options::skip_permission_denied;
  for (fs::recursive_directory_iterator it(folder, options, error), end; !error && it != end;
       it.increment(error)) {
    if (it.depth() >= kMaxDepth) it.disable_recursion_pending();
    visit(*it);
  }
}

}  // namespace

FileWatch::FileWatch(std::vector<fs::path> roots)
    : roots_(std::move(roots)), seen_(take()), last_(seen_) {}

// A file that vanishes while it is looked at is one that is not there.
bool FileWatch::read(const std::string& path, Stamp& stamp) {
  struct stat found {};
  if (stat(path.c_str(), &found) != 0) return false;
  stamp = {nanoseconds(found.st_mtim), nanoseconds(found.st_ctim), found.st_size};
  return true;
}

FileWatch::Snapshot FileWatch::take() const {
  Snapshot snapshot;
  const auto add = [&snapshot](const fs::path& path) {
    Stamp stamp;
    if (read(path.string(), stamp)) snapshot.emplace(path.string(), stamp);
  };
  for (const fs::path& root : roots_) {
    std::error_code error;
    if (!fs::is_directory(root, error)) {
      add(root);
      continue;
    }
    walk(root, [&](const fs::directory_entry& entry) {
      std::error_code unknown;
      if (entry.is_regular_file(unknown) && !isPartial(entry.path())) add(entry.path());
    });
  }
  return snapshot;
}

void FileWatch::accept(const std::string& path) {
  Stamp stamp;
  if (read(path, stamp)) seen_[path] = last_[path] = stamp;
}

std::vector<std::string> FileWatch::poll() {
  Snapshot now = take();
  const bool settled = now == last_;
  last_ = std::move(now);
  std::vector<std::string> changed;
  if (!settled || last_ == seen_) return changed;
  for (const auto& [path, stamp] : last_) {
    const auto before = seen_.find(path);
    if (before == seen_.end() || before->second != stamp) changed.push_back(path);
  }
  for (const auto& [path, stamp] : seen_) {
    if (!last_.contains(path)) changed.push_back(path);
  }
  seen_ = last_;
  std::sort(changed.begin(), changed.end());
  return changed;
}

std::vector<fs::path> watchedFolders(const std::vector<fs::path>& roots) {
  std::vector<fs::path> folders;
  for (const fs::path& root : roots) {
    std::error_code error;
    folders.push_back(fs::absolute(root, error).parent_path());
    if (!fs::is_directory(root, error)) continue;
    folders.push_back(root);
    walk(root, [&](const fs::directory_entry& entry) {
      std::error_code unknown;
      if (entry.is_directory(unknown) && !entry.is_symlink(unknown)) folders.push_back(entry.path());
    });
  }
  return folders;
}

}  // namespace orris
