#include "app/view/script/script_player.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/view/script/script_files.h"
#include "app/view/surface/key_bindings.h"

namespace orris {
namespace {

constexpr double kUntilSeconds = 30;
constexpr int kMostFrames = 1'000'000;
constexpr int kDragTurns = 4;

ViewEvent keyEvent(int key, bool pressed) {
  return {.kind = ViewEvent::Kind::Key, .code = key, .pressed = pressed};
}
ViewEvent buttonEvent(int button, bool pressed) {
  return {.kind = ViewEvent::Kind::Button, .code = button, .pressed = pressed};
}
ViewEvent moveEvent(double x, double y) { return {.kind = ViewEvent::Kind::Move, .x = x, .y = y}; }

double numberOf(const JsonNode& object, const char* member, double fallback) {
  const JsonNode* node = object.find(member);
  return node == nullptr ? fallback : node->real;
}

}  // namespace

std::string ScriptPlayer::press(const ScriptStep& step) {
  const auto key = keyNamed(step.value.text);
  if (!key) return fmt::format("there is no key \"{}\"", step.value.text);
  const int hold = int(std::clamp(numberOf(step.object, "hold", 1), 1.0, double(kMostFrames)));
  turns_.push_back({keyEvent(*key, true)});
  for (int i = 1; i < hold; ++i) turns_.emplace_back();
  turns_.push_back({keyEvent(*key, false)});
  turns_.emplace_back();
  return "";
}

std::string ScriptPlayer::point(const ScriptStep& step, ScriptTarget& target) {
  double x = 0, y = 0, width = 0;
  if (step.value.kind == JsonNode::Kind::Array) {
    if (step.value.items.size() != 2) return "a place is [x, y], in pixels";
    x = step.value.items[0].real;
    y = step.value.items[1].real;
  } else {
    const auto item = target.item(step.value.text);
    if (!item) return fmt::format("nothing on the screen is named \"{}\"", step.value.text);
    x = item->x + item->width / 2;
    y = item->y + item->height / 2;
    width = item->width;
  }
  turns_.push_back({moveEvent(x, y)});
  if (step.action == "move") return "";
  const JsonNode* button = step.object.find("button");
  const bool right = button != nullptr && button->text == "right";
  turns_.push_back({buttonEvent(right ? 1 : 0, true)});
  if (step.action == "drag") {
    const double to = x + (numberOf(step.object, "to", 0.5) - 0.5) * width;
    for (int i = 1; i <= kDragTurns; ++i)
      turns_.push_back({moveEvent(x + (to - x) * i / kDragTurns, y)});
  }
  turns_.push_back({buttonEvent(right ? 1 : 0, false)});
  turns_.emplace_back();
  return "";
}

std::string ScriptPlayer::waitFor(const ScriptStep& step, ScriptTarget& target) {
  const std::string problem = mismatch(target.state(), step.value);
  const double seconds = numberOf(step.object, "seconds", kUntilSeconds);
  if (problem.empty()) {
    deadline_.reset();
    return "";
  }
  if (!deadline_)
    deadline_ = Clock::now() + std::chrono::milliseconds(std::int64_t(seconds * 1000));
  if (Clock::now() >= *deadline_) return fmt::format("{}, after {} s", problem, seconds);
  turns_.emplace_back();
  return "";
}

std::string ScriptPlayer::begin(const ScriptStep& step, ScriptTarget& target) {
  const std::string& action = step.action;
  if (action == "key") return press(step);
  if (action == "move" || action == "click" || action == "drag") return point(step, target);
  if (action == "until") return waitFor(step, target);
  if (action == "expect") return mismatch(target.state(), step.value);
  if (action == "frames") {
    turns_.resize(std::size_t(std::clamp<std::int64_t>(step.value.integer, 0, kMostFrames)));
    return "";
  }
  if (action == "scroll") {
    turns_.push_back({{.kind = ViewEvent::Kind::Scroll, .y = step.value.real}});
    return "";
  }
  if (action == "text") {
    for (const char c : step.value.text)
      turns_.push_back({{.kind = ViewEvent::Kind::Text, .code = static_cast<unsigned char>(c)}});
    turns_.emplace_back();
    return "";
  }
  if (isFileStep(step)) return changeFile(step);
  return target.perform(step);
}

std::vector<ViewEvent> ScriptPlayer::advance(ScriptTarget& target, Diagnostics& diagnostics) {
  while (turns_.empty() && !ended_) {
    if (next_ == script_.steps.size()) {
      ended_ = true;
      break;
    }
    const ScriptStep& step = script_.steps[next_];
    const std::string problem = begin(step, target);
    if (!problem.empty()) {
      diagnostics.push_back(script_.problem(
          step, "script-failed", fmt::format("step {} ({}): {}", next_ + 1, step.action, problem)));
      ended_ = true;
      turns_.clear();
      break;
    }
    if (!deadline_) ++next_;
  }
  if (turns_.empty()) return {};
  std::vector<ViewEvent> events = std::move(turns_.front());
  turns_.pop_front();
  return events;
}

}  // namespace orris
