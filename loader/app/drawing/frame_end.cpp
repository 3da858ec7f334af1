#include "app/drawing/frame_end.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>

namespace orris {
namespace {

constexpr int kFrameLimit = 1000000;
constexpr int kLeastSettled = 32;  // fewer show too little of what adapts slowly
constexpr std::string_view kAuto = "auto";

std::optional<int> parseCount(std::string_view text) {
  int count = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  return whole && count >= 1 && count <= kFrameLimit ? std::optional(count) : std::nullopt;
}

/// "32", "auto" or "auto:500"; nullopt for other texts.
std::optional<FramesWanted> parseFrames(std::string_view text) {
  FramesWanted frames;
  if (text == kAuto) return frames;
  frames.untilSettled = text.starts_with(kAuto) && text.substr(kAuto.size()).starts_with(':');
  const auto count = parseCount(frames.untilSettled ? text.substr(kAuto.size() + 1) : text);
  if (!count) return std::nullopt;
  frames.most = *count;
  return frames;
}

int lastEventOf(const World& world) {
  int last = 0;
  for (const Event& event : world.events) last = std::max(last, event.frame);
  return last;
}

}  // namespace

void addSettlingFramesFlag(CLI::App& command, FramesWanted& frames) {
  command
      .add_option_function<std::string>(
          "--frames",
          [&frames](const std::string& text) {
            const auto parsed = parseFrames(text);
            if (!parsed)
              throw CLI::ValidationError(
                  "--frames", fmt::format("expected 1 to {}, auto, or auto:N for at most N: {}", kFrameLimit, text));
            frames = *parsed;
          },
          fmt::format("frames to draw, the last one is the picture; auto: until it settles, {} to {}, auto:N to N "
                      "(default auto)",
                      kLeastSettled, frames.most))
      ->type_name("N|auto[:N]");
}

FrameEnd::FrameEnd(const FramesWanted& wanted, const World& world)
    : wanted_(wanted), start_(lastEventOf(world)) {}

// One frame before a power of two, so that the last one, in which passes are looked at, is known before it is drawn.
void FrameEnd::drawn(int frame, const FrameRenderer& renderer) {
  const int count = frame - start_ + 2;
  const bool looks = count >= PictureSettling::kFirstLook && (count & (count - 1)) == 0;
  if (!wanted_.untilSettled || settled_ || !looks) return;
  const bool still = settling_.settles(renderer.screenshot());
  settled_ = still && count >= kLeastSettled;
}

std::optional<bool> FrameEnd::settled() const {
  return wanted_.untilSettled ? std::optional(settled_) : std::nullopt;
}

}  // namespace orris
