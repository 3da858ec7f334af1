// Noticing that files were edited, by their sizes and times: the same on every file system.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace orris {

/// Watches files, and folders with everything below them; what does not exist yet may come later.
class FileWatch {
 public:
  /// What is there now counts as seen.
  explicit FileWatch(std::vector<std::filesystem::path> roots);

  /// Paths added, removed or edited since the last time some were returned, sorted. Empty until two
  /// calls in a row see the same: an editor may be in the middle of writing several files. Call it a
  /// few times a second. What replaceFile() fills to put it in the place of another file does not count.
  std::vector<std::string> poll();
  /// What `path` is now counts as seen.
  void accept(const std::string& path);
  /// Did the last call see nothing that is not returned yet?
  bool settled() const { return last_ == seen_; }

 private:
  /// Of the content and of the file: who may read it counts, and what was moved here with an older time.
  struct Stamp {
    std::int64_t content = 0, change = 0;  ///< nanoseconds
    std::int64_t size = 0;
    bool operator==(const Stamp&) const = default;
  };
  static bool read(const std::string& path, Stamp& stamp);
  using Snapshot = std::map<std::string, Stamp>;
  Snapshot take() const;

  std::vector<std::filesystem::path> roots_;
  Snapshot seen_, last_;
};

/// The folders in which something may happen to the roots: with all below them, and what they lie in.
std::vector<std::filesystem::path> watchedFolders(const std::vector<std::filesystem::path>& roots);

}  // namespace orris
