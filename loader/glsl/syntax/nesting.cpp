#include <orris/glsl/syntax/nesting.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace orris {
namespace {

using Kind = NestingMark::Kind;

// Packs are untrusted: each place is tried with all marks, and each mark with those it stands in.
constexpr std::size_t kMostSteps = 20'000'000;
constexpr std::size_t kMostMarks = 10'000;
constexpr std::ptrdiff_t kMostAround = 64;
constexpr int kAlone = 40, kOtherIndent = 4, kOtherDepth = 2, kOtherGroup = 8, kPartOfGuard = 20;
constexpr int kOutside = 4, kElseOfNothing = 20, kMainAstray = 20;
constexpr int kElseTwice = 20, kWithinItself = 3;
// Layout that is often uneven weighs as much as a block twice as long.
constexpr double kOtherSpacing = 0.7;
// With lengths that differ by less than this, a factor of e, another partner is as good.
constexpr double kSure = 1;
constexpr std::size_t kMostOthers = 2;

int misfit(const NestingMark& open, const NestingMark& close, bool hasElse) {
  if (open.group != close.group) return kOtherGroup;
  const bool known = open.indent >= 0 && close.indent >= 0;
  const bool same = open.indent == close.indent || open.around == close.indent;
  return (known && !same ? kOtherIndent : 0) + (open.depth != close.depth ? kOtherDepth : 0) +
         (hasElse && !open.mayElse ? kElseOfNothing : 0);
}

/// Pairs the marks with one more among them.
class Trial {
 public:
  Trial(std::span<const NestingMark> marks, const NestingPlace& place, Kind kind)
      : marks_(marks),
        place_(place),
        added_{.kind = kind,
               .indent = place.indent,
               .depth = -1,
               .group = place.group,
               .line = place.line,
               .ofStages = true} {}

  /// Cost and lengths of all pairs; the partner of the added mark is marks.size() when it has none.
  void run() {
    cost_ = place_.cost;
    for (std::size_t i = 0; i <= marks_.size(); ++i) {
      if (i == place_.before) {
        judgeLines(place_.above, place_.group);
        take(kAdded);
      }
      if (i == marks_.size()) break;
      judgeLines(i == place_.before ? place_.below : marks_[i].lowest, marks_[i].group);
      if (!open_.empty() && marks_[i].shallowest < at(open_.back().mark).depth) cost_ += kOutside;
      take(int(i));
    }
    cost_ += kAlone * int(open_.size());
  }

  std::pair<int, double> cost() const { return {cost_, length_}; }
  std::optional<std::size_t> partner() const { return partner_; }

 private:
  static constexpr int kAdded = -1;
  const NestingMark& at(int i) const { return i == kAdded ? added_ : marks_[std::size_t(i)]; }

  /// An open mark, and in which of its branches the text is.
  struct Branch {
    int mark = 0, number = 0;
    bool last = false;
    bool operator==(const Branch&) const = default;
  };

  void take(int i) {
    const NestingMark& mark = at(i);
    if (mark.kind == Kind::Main) return takeMain();
    if (mark.kind == Kind::Open) {
      if (mark.inner && open_.empty()) cost_ += kAlone;
      if (isWithinItself(mark)) cost_ += kWithinItself;
      return open_.push_back({i, 0});
    }
    if (open_.empty()) {
      cost_ += kAlone;
      return;
    }
    const int other = open_.back().mark;
    const NestingMark& open = at(other);
    cost_ += i == kAdded       ? misfitOfClose(open)
             : other == kAdded ? misfitOfOpen(mark)
                               : misfit(open, mark, mark.hasElse && !losesElse(i));
    if (mark.kind == Kind::Middle) {
      if (open.whole) cost_ += kPartOfGuard;
      if (open_.back().last) cost_ += kElseTwice;
      open_.back().last = mark.last;
      ++open_.back().number;
      return;
    }
    const bool addedLast = place_.before == marks_.size();
    const bool last = addedLast ? i == kAdded : i == int(marks_.size()) - 1;
    if (open.whole && !last) cost_ += kPartOfGuard;
    // As short blocks are common and long ones rare, a short one in a long one is likelier than two
    // of middle length.
    length_ += std::log(std::max(1, mark.line - open.line));
    if (open.airy && mark.airy && *open.airy != *mark.airy) {
      length_ += kOtherSpacing;
      cost_ += open.whole ? 1 : 0;  // guards are even
    }
    if (i == kAdded) partner_ = std::size_t(other);
    if (other == kAdded) partner_ = std::size_t(i);
    open_.pop_back();
  }

  bool losesElse(int i) const { return place_.takesElse && place_.before == std::size_t(i) + 1; }

  /// Nobody asks again for what holds already.
  bool isWithinItself(const NestingMark& mark) const {
    if (mark.condition == 0) return false;
    const auto last = open_.rbegin() + std::min(std::ssize(open_), kMostAround);
    return std::any_of(open_.rbegin(), last, [&](const Branch& branch) {
      return branch.number == 0 && at(branch.mark).condition == mark.condition;
    });
  }

  // Each stage has one.
  void takeMain() {
    const auto found = std::find_if(open_.rbegin(), open_.rend(),
                                    [this](const Branch& b) { return at(b.mark).ofStages; });
    if (found == open_.rend() || std::ranges::find(mains_, *found) != mains_.end())
      cost_ += kMainAstray;
    else
      mains_.push_back(*found);
  }

  // Of the added mark only what its place says is known: the indent of the head that it would open,
  // or of the line behind it, which may lie further out.
  int misfitOfOpen(const NestingMark& close) const {
    const bool known = added_.indent >= 0 && close.indent >= 0 && added_.group == close.group;
    return known && added_.indent != close.indent ? kOtherIndent : 0;
  }
  int misfitOfClose(const NestingMark& open) const {
    return (added_.group == open.group && added_.indent > open.indent ? kOtherIndent : 0) +
           (place_.takesElse && !open.mayElse ? kElseOfNothing : 0);
  }

  /// Lines do not stand further out than the block that they are in.
  void judgeLines(int lowest, int group) {
    if (open_.empty()) return;
    const NestingMark& open = at(open_.back().mark);
    if (open.group == group && lowest < open.indent) cost_ += kOutside;
  }

  std::span<const NestingMark> marks_;
  const NestingPlace& place_;
  NestingMark added_;
  std::vector<Branch> open_;
  std::vector<Branch> mains_;  ///< the branches of stages with a main()
  int cost_ = 0;
  double length_ = 0;
  std::optional<std::size_t> partner_;
};

using Cost = std::pair<int, double>;

// Of places beside each other, as in a row of closing braces, the last.
bool isLess(const Cost& a, const Cost& b) {
  constexpr double kSame = 0.05;
  return a.first != b.first ? a.first < b.first : a.second < b.second + kSame;
}

struct Judged {
  MissingMark mark;
  Cost cost;
};

/// The places, in their order, where the mark has a partner.
std::vector<Judged> judgeAll(std::span<const NestingMark> marks,
                             std::span<const NestingPlace> places, Kind kind) {
  if (marks.size() > kMostMarks) return {};
  const std::size_t most = std::min(places.size(), kMostSteps / (marks.size() + 1));
  std::vector<Judged> all;
  for (std::size_t i = 0; i < most; ++i) {
    Trial trial(marks, places[i], kind);
    trial.run();
    if (trial.partner()) all.push_back({{i, *trial.partner()}, trial.cost()});
  }
  return all;
}

}  // namespace

std::vector<MissingMark> rankMissingMarks(std::span<const NestingMark> marks,
                                          std::span<const NestingPlace> places, Kind kind,
                                          std::size_t most) {
  std::vector<Judged> all = judgeAll(marks, places, kind);
  std::ranges::stable_sort(all, {}, &Judged::cost);
  std::vector<MissingMark> ranked;
  for (std::size_t i = 0; i < std::min(most, all.size()); ++i) ranked.push_back(all[i].mark);
  return ranked;
}

std::vector<MissingMark> findMissingMarks(std::span<const NestingMark> marks,
                                          std::span<const NestingPlace> places, Kind kind) {
  std::vector<Judged> ofPartners;
  for (const Judged& here : judgeAll(marks, places, kind)) {
    const auto same = std::ranges::find_if(
        ofPartners, [&](const Judged& b) { return b.mark.partner == here.mark.partner; });
    if (same == ofPartners.end()) {
      ofPartners.push_back(here);
    } else if (isLess(here.cost, same->cost)) {
      *same = here;
    }
  }
  if (ofPartners.empty()) return {};
  // In the order of their places, as isLess() is no order of its own.
  std::ranges::sort(ofPartners, {}, [](const Judged& b) { return b.mark.place; });
  std::size_t best = 0;
  for (std::size_t i = 1; i < ofPartners.size(); ++i) {
    if (isLess(ofPartners[i].cost, ofPartners[best].cost)) best = i;
  }
  std::vector<MissingMark> found{ofPartners[best].mark};
  const Cost least = ofPartners[best].cost;
  ofPartners.erase(ofPartners.begin() + std::ptrdiff_t(best));
  std::ranges::stable_sort(ofPartners, {}, &Judged::cost);
  for (std::size_t i = 0; i < std::min(kMostOthers, ofPartners.size()); ++i) {
    const Judged& other = ofPartners[i];
    if (other.cost.first == least.first && other.cost.second - least.second < kSure)
      found.push_back(other.mark);
  }
  return found;
}

}  // namespace orris
