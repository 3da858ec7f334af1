// Noticing that files were edited, by their sizes and times: no system facility to run out of, and
// the same on every file system.
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
  /// few times a second.
  std::vector<std::string> poll();
  /// What `path` is now counts as seen.
  void accept(const std::string& path);

 private:
  struct Stamp {
    std::filesystem::file_time_type time;
    std::uintmax_t size = 0;
    bool operator==(const Stamp&) const = default;
  };
  using Snapshot = std::map<std::string, Stamp>;
  Snapshot take() const;

  std::vector<std::filesystem::path> roots_;
  Snapshot seen_, last_;
};

}  // namespace orris
