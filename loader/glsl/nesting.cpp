#include "glsl/nesting.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace orris {
namespace {

using Kind = NestingMark::Kind;

// Packs are untrusted: each place is tried with all marks.
constexpr std::size_t kMostSteps = 100'000'000;
constexpr int kAlone = 40, kOtherIndent = 4, kOtherDepth = 2, kOtherGroup = 8, kPartOfGuard = 20;

int misfit(const NestingMark& open, const NestingMark& close) {
  if (open.group != close.group) return kOtherGroup;
  const bool known = open.indent >= 0 && close.indent >= 0;
  return (known && open.indent != close.indent ? kOtherIndent : 0) +
         (open.depth != close.depth ? kOtherDepth : 0);
}

/// Pairs the marks with one more among them.
class Trial {
 public:
  Trial(std::span<const NestingMark> marks, const NestingPlace& place, Kind kind)
      : marks_(marks), place_(place), added_{kind, place.indent, -1, place.group, place.line} {}

  /// Cost and length of all pairs; the partner of the added mark is marks.size() when it has none.
  void run() {
    cost_ = place_.cost;
    for (std::size_t i = 0; i <= marks_.size(); ++i) {
      if (i == place_.before) take(kAdded);
      if (i < marks_.size()) take(int(i));
    }
    cost_ += kAlone * int(open_.size());
  }

  std::pair<int, long> cost() const { return {cost_, length_}; }
  std::optional<std::size_t> partner() const { return partner_; }

 private:
  static constexpr int kAdded = -1;
  const NestingMark& at(int i) const { return i == kAdded ? added_ : marks_[std::size_t(i)]; }

  void take(int i) {
    const NestingMark& mark = at(i);
    if (mark.kind == Kind::Open) return open_.push_back(i);
    if (open_.empty()) {
      cost_ += kAlone;
      return;
    }
    const int other = open_.back();
    const NestingMark& open = at(other);
    // Of the added mark only what its place says is known.
    if (i != kAdded && other != kAdded)
      cost_ += misfit(open, mark);
    else if (mark.indent >= 0 && open.indent >= 0 && mark.group == open.group &&
             mark.indent != open.indent)
      cost_ += kOtherIndent;
    if (mark.kind == Kind::Middle) return;
    const bool last = i == int(marks_.size()) - 1;
    if (open.whole && !last) cost_ += kPartOfGuard;
    length_ += mark.line - open.line;
    if (i == kAdded) partner_ = std::size_t(other);
    if (other == kAdded) partner_ = std::size_t(i);
    open_.pop_back();
  }

  std::span<const NestingMark> marks_;
  const NestingPlace& place_;
  NestingMark added_;
  std::vector<int> open_;
  int cost_ = 0;
  long length_ = 0;
  std::optional<std::size_t> partner_;
};

}  // namespace

std::optional<MissingMark> findMissingMark(std::span<const NestingMark> marks,
                                           std::span<const NestingPlace> places, Kind kind) {
  const std::size_t most = std::min(places.size(), kMostSteps / (marks.size() + 1));
  std::optional<MissingMark> best;
  std::pair<int, long> least;
  for (std::size_t i = 0; i < most; ++i) {
    Trial trial(marks, places[i], kind);
    trial.run();
    if (!trial.partner() || (best && trial.cost() >= least)) continue;
    least = trial.cost();
    best = {i, *trial.partner()};
  }
  return best;
}

}  // namespace orris
