// A FileWatch on a thread of its own, so that thousands of files never hold up a frame.
#pragma once

#include <mutex>
#include <stop_token>
#include <thread>

#include "app/view/files/file_watch.h"

namespace orris {

/// Is woken by inotify where the system has it, and looks by itself now and then, because file systems of
/// other machines wake nobody.
class BackgroundWatch {
 public:
  /// A file of inotify for one watch, -1 where the system has none to give, as in a sandbox.
  static int openEvents();
  /// What is there now counts as seen. Closes `events`.
  BackgroundWatch(std::vector<std::filesystem::path> roots, int events);
  ~BackgroundWatch();

  /// Paths that were added, removed or edited since the last call, once they have settled; sorted.
  std::vector<std::string> take();
  /// What `path` is now counts as seen.
  void accept(const std::string& path);

 private:
  void look(const std::stop_token& stop);
  /// Until something may have changed.
  void sleep();
  void watchFolders();

  std::vector<std::filesystem::path> roots_;
  std::mutex mutex_;  ///< of the two below
  FileWatch watch_;
  std::vector<std::string> changed_;
  int events_, wake_;  ///< files of inotify and of what ends the sleep, -1 without
  std::jthread thread_;
};

}  // namespace orris
