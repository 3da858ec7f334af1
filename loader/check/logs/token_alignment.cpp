#include <orris/check/logs/token_alignment.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <unordered_map>

namespace orris {
namespace {

struct Pair {
  int from, to;
};

/// A range of both texts that is still to be matched; `to` ends exclude.
struct OpenRange {
  int from, fromEnd, to, toEnd;
};

using Words = std::vector<std::string_view>;

std::uint64_t hashOfRun(const Words& words, int at, int length) {
  std::uint64_t hash = 0;
  for (int i = at; i < at + length; ++i) {
    hash = hash * 0x9E3779B97F4A7C15u + std::hash<std::string_view>()(words[i]);
  }
  return hash;
}

/// Start of each run that occurs once in the range; -1 for those that occur more often.
std::unordered_map<std::uint64_t, int> uniqueRuns(const Words& words, int begin, int end,
                                                  int length) {
  std::unordered_map<std::uint64_t, int> runs;
  for (int i = begin; i + length <= end; ++i) {
    const auto [place, isNew] = runs.emplace(hashOfRun(words, i, length), i);
    if (!isNew) place->second = -1;
  }
  return runs;
}

/// The longest part of `pairs` (sorted by `from`) that rises in `to`, too.
std::vector<Pair> rising(const std::vector<Pair>& pairs) {
  std::vector<int> last;  // index of the pair that ends the best chain of each length
  std::vector<int> before(pairs.size(), -1);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto longer =
        std::ranges::lower_bound(last, pairs[i].to, {}, [&](int index) { return pairs[index].to; });
    if (longer != last.begin()) before[i] = *std::prev(longer);
    if (longer == last.end())
      last.push_back(static_cast<int>(i));
    else
      *longer = static_cast<int>(i);
  }
  std::vector<Pair> chain;
  for (int i = last.empty() ? -1 : last.back(); i >= 0; i = before[i]) chain.push_back(pairs[i]);
  std::ranges::reverse(chain);
  return chain;
}

class Aligner {
 public:
  Aligner(const Words& from, const Words& to) : from_(from), to_(to), matched_(from.size(), -1) {}

  std::vector<int> align() {
    std::vector<OpenRange> gaps{
        {0, static_cast<int>(from_.size()), 0, static_cast<int>(to_.size())}};
    for (const int length : {8, 4, 2, 1}) {
      for (const OpenRange& gap : gaps) matchRuns(gap, length);
      gaps = openGaps();
    }
    return matched_;
  }

 private:
  void matchRuns(const OpenRange& gap, int length) {
    const auto fromRuns = uniqueRuns(from_, gap.from, gap.fromEnd, length);
    const auto toRuns = uniqueRuns(to_, gap.to, gap.toEnd, length);
    std::vector<Pair> pairs;
    for (const auto& [hash, at] : fromRuns) {
      const auto other = toRuns.find(hash);
      if (at >= 0 && other != toRuns.end() && other->second >= 0) {
        pairs.push_back({at, other->second});
      }
    }
    std::ranges::sort(pairs, {}, &Pair::from);
    int fromFloor = gap.from, toFloor = gap.to;
    for (const Pair& pair : rising(pairs)) {
      if (pair.from < fromFloor || pair.to < toFloor) continue;
      extend(gap, pair, fromFloor, toFloor);
    }
  }

  /// Matches equal tokens around `pair`, as far as both texts go on alike.
  void extend(const OpenRange& gap, const Pair& pair, int& fromFloor, int& toFloor) {
    int a = pair.from, b = pair.to;
    while (a > fromFloor && b > toFloor && from_[a - 1] == to_[b - 1]) --a, --b;
    for (; a < gap.fromEnd && b < gap.toEnd && from_[a] == to_[b]; ++a, ++b) matched_[a] = b;
    fromFloor = std::max(fromFloor, a);
    toFloor = std::max(toFloor, b);
  }

  std::vector<OpenRange> openGaps() const {
    std::vector<OpenRange> gaps;
    int from = 0, to = 0;
    const int end = static_cast<int>(matched_.size());
    for (int i = 0; i <= end; ++i) {
      const int other = i == end ? static_cast<int>(to_.size()) : matched_[i];
      if (other < 0) continue;
      if (i > from && other > to) gaps.push_back({from, i, to, other});
      from = i + 1;
      to = other + 1;
    }
    return gaps;
  }

  const Words& from_;
  const Words& to_;
  std::vector<int> matched_;
};

}  // namespace

std::vector<int> alignTokens(const Words& from, const Words& to) {
  return Aligner(from, to).align();
}

}  // namespace orris
