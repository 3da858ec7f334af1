// Checking a pack in other processes while the editor goes on.
#pragma once

#include <sys/types.h>

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/lsp/check_work.h"

namespace orris {

/// One job at a time; a new one ends the one in progress.
class BackgroundCheck {
 public:
  /// Of the pack at `path`.
  BackgroundCheck(std::string path, ValidateOptions options)
      : path_(std::move(path)), options_(std::move(options)) {}
  BackgroundCheck(const BackgroundCheck&) = delete;
  BackgroundCheck& operator=(const BackgroundCheck&) = delete;
  ~BackgroundCheck() { stop(); }
  /// The job gets its number here.
  void start(CheckJob job);
  /// Ends all processes.
  void stop();
  /// To be waited for; -1 where there are no processes.
  int descriptor() const { return out_; }
  /// What the last job has said since, as checkForEditor() does; {"part": "lost"} when it ended otherwise.
  std::vector<nlohmann::json> take();

 private:
  bool open();

  std::string path_;
  ValidateOptions options_;
  pid_t first_ = -1;  ///< its forks go on without it
  int jobs_ = -1, out_ = -1, number_ = 0;
  bool running_ = false;  ///< the last job has not ended
  std::string read_;
};

}  // namespace orris
