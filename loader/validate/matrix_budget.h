// The time that the matrices of a run may take, checks before them included.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <optional>

namespace orris {

/// Gives each matrix its part of the time that is left; those to come need as long for the checks
/// before them as this one did.
class MatrixBudget {
 public:
  using Clock = std::chrono::steady_clock;

  /// The time begins now; nullopt: no end.
  MatrixBudget(std::optional<std::chrono::seconds> time, std::size_t packs) : packs_(packs) {
    if (time) end_ = Clock::now() + *time;
  }
  void beginPack(std::size_t matrices) {
    matrices_ = matrices;
    packs_ -= packs_ > 0 ? 1 : 0;
  }
  void beginChecks() { checks_ = Clock::now(); }
  /// When the matrix that begins now has to end.
  std::optional<Clock::time_point> beginMatrix() {
    if (!end_) return std::nullopt;
    matrices_ -= matrices_ > 0 ? 1 : 0;
    const auto others = static_cast<int>(matrices_ + packs_);
    const Clock::time_point now = Clock::now();
    const Clock::duration left = *end_ - now - (now - checks_) * others;
    return now + std::max(Clock::duration::zero(), left / (others + 1));
  }

 private:
  std::optional<Clock::time_point> end_;
  Clock::time_point checks_ = Clock::now();
  std::size_t packs_, matrices_ = 0;
};

}  // namespace orris
