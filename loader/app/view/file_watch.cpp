#include "app/view/file_watch.h"

#include <algorithm>
#include <system_error>
#include <utility>

namespace orris {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxDepth = 32;

}  // namespace

FileWatch::FileWatch(std::vector<fs::path> roots)
    : roots_(std::move(roots)), seen_(take()), last_(seen_) {}

FileWatch::Snapshot FileWatch::take() const {
  Snapshot snapshot;
  const auto add = [&snapshot](const fs::path& path) {
    std::error_code error;
    Stamp stamp{.time = fs::last_write_time(path, error), .size = fs::file_size(path, error)};
    // A file that vanishes while it is looked at is one that is not there.
    if (!error) snapshot.emplace(path.string(), stamp);
  };
  for (const fs::path& root : roots_) {
    std::error_code error;
    if (!fs::is_directory(root, error)) {
      add(root);
      continue;
    }
    const auto options = fs::directory_options::skip_permission_denied;
    for (fs::recursive_directory_iterator it(root, options, error), end; !error && it != end;
         it.increment(error)) {
      if (it.depth() >= kMaxDepth) it.disable_recursion_pending();
      std::error_code unknown;
      if (it->is_regular_file(unknown)) add(it->path());
    }
  }
  return snapshot;
}

void FileWatch::accept(const std::string& path) {
  std::error_code error;
  const Stamp stamp{.time = fs::last_write_time(path, error), .size = fs::file_size(path, error)};
  if (error) return;
  seen_[path] = last_[path] = stamp;
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

}  // namespace orris
