// Carries out a script, step by step, while frames are drawn.
#pragma once

#include <chrono>
#include <deque>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/view/surface/view_event.h"
#include "app/view/script/view_script.h"

namespace orris {

/// Something on the screen that can be clicked, in pixels.
struct ScreenItem {
  float x = 0, y = 0, width = 0, height = 0;
};

/// What a script acts on.
class ScriptTarget {
 public:
  virtual ~ScriptTarget() = default;
  virtual nlohmann::json state() = 0;
  /// By the name that state() lists in "items".
  virtual std::optional<ScreenItem> item(const std::string& name) = 0;
  /// Does a step that is neither input, nor a file, nor waiting; a problem in words, or "".
  virtual std::string perform(const ScriptStep& step) = 0;
};

class ScriptPlayer {
 public:
  explicit ScriptPlayer(ViewScript script) : script_(std::move(script)) {}

  /// Before each frame: does the steps that are due, up to one that takes time. The events are what the
  /// user does before this frame. The first problem ends the script.
  std::vector<ViewEvent> advance(ScriptTarget& target, Diagnostics& diagnostics);
  bool ended() const { return ended_; }

 private:
  using Clock = std::chrono::steady_clock;
  /// A problem in words, or "".
  std::string begin(const ScriptStep& step, ScriptTarget& target);
  std::string press(const ScriptStep& step);
  std::string point(const ScriptStep& step, ScriptTarget& target);
  std::string waitFor(const ScriptStep& step, ScriptTarget& target);

  ViewScript script_;
  std::size_t next_ = 0;
  std::deque<std::vector<ViewEvent>> turns_;  ///< of the frames to come; empty turns wait
  std::optional<Clock::time_point> deadline_;  ///< of the step "until" that is waited for
  bool ended_ = false;
};

}  // namespace orris
