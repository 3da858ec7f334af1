// Checking a pack in another process while the editor goes on: what `orris validate` reports of it.
#pragma once

#include <sys/types.h>

#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>
#include <vector>

#include "app/lsp/overlay_source.h"
#include <orris/check/compile/program_check.h>
#include <orris/validate/validate_options.h>

namespace orris {

struct CheckJob {
  std::string path;  ///< of the pack
  Overlay overlay;
  std::set<std::string> changed;  ///< files since the last whole check; empty: no hurry for some
  Verdicts known;                 ///< of programs that nothing was reported of
  ValidateOptions options;
};

/// One job at a time; the process of a job that is given up is ended.
class BackgroundCheck {
 public:
  BackgroundCheck() = default;
  BackgroundCheck(const BackgroundCheck&) = delete;
  BackgroundCheck& operator=(const BackgroundCheck&) = delete;
  ~BackgroundCheck() { cancel(); }
  void start(const CheckJob& job);
  void cancel();
  bool running() const { return child_ > 0; }
  /// To be waited for; -1 while nothing runs.
  int descriptor() const { return pipe_; }
  /// What the process has said since: {"part": "programs", "entries": [...], "findings": [...]}, then
  /// {"part": "whole", "findings": [...], "quiet": [...]}. {"part": "lost"} when it ended otherwise. A finding
  /// is as in the JSON of `validate`, with its "uri" (a path), "programs", and the edit "repair".
  std::vector<nlohmann::json> take();

 private:
  pid_t child_ = -1;
  int pipe_ = -1;
  bool whole_ = false;  ///< the whole result came
  std::string read_;
};

}  // namespace orris
