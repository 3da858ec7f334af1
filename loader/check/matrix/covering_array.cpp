#include <orris/check/matrix/covering_array.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>

namespace orris {
namespace {

/// Which pairs of values are still to be covered, one bit-like byte each.
class Pairs {
 public:
  explicit Pairs(const std::vector<int>& levels) : levels_(levels), offsets_(levels.size() + 1, 0) {
    for (std::size_t i = 0; i < levels.size(); ++i) {
      offsets_[i + 1] = offsets_[i] + static_cast<std::size_t>(levels[i]);
    }
    width_ = offsets_.back();
    open_.assign(width_ * width_, 0);
    perValue_.assign(width_, 0);
    for (std::size_t a = 0; a < levels.size(); ++a) {
      for (std::size_t b = a + 1; b < levels.size(); ++b) openAll(a, b);
    }
  }

  std::size_t left() const { return left_; }
  /// Open pairs that the value is part of.
  std::size_t openWith(std::size_t factor, int value) const { return perValue_[at(factor, value)]; }
  bool isOpen(std::size_t a, int x, std::size_t b, int y) const {
    return open_[at(a, x) * width_ + at(b, y)] != 0;
  }
  void cover(std::size_t a, int x, std::size_t b, int y) {
    if (!isOpen(a, x, b, y)) return;
    open_[at(a, x) * width_ + at(b, y)] = open_[at(b, y) * width_ + at(a, x)] = 0;
    --perValue_[at(a, x)];
    --perValue_[at(b, y)];
    --left_;
  }

 private:
  std::size_t at(std::size_t factor, int value) const {
    return offsets_[factor] + static_cast<std::size_t>(value);
  }
  void openAll(std::size_t a, std::size_t b) {
    for (int x = 0; x < levels_[a]; ++x) {
      for (int y = 0; y < levels_[b]; ++y) {
        open_[at(a, x) * width_ + at(b, y)] = open_[at(b, y) * width_ + at(a, x)] = 1;
        ++perValue_[at(a, x)];
        ++perValue_[at(b, y)];
        ++left_;
      }
    }
  }

  const std::vector<int>& levels_;
  std::vector<std::size_t> offsets_;
  std::size_t width_ = 0, left_ = 0;
  std::vector<std::uint8_t> open_;
  std::vector<std::size_t> perValue_;
};

/// Builds rows greedily: the value with the most open pairs first, then each factor, in a fixed
/// shuffled order, takes the value that covers most with those already placed.
class RowBuilder {
 public:
  RowBuilder(const std::vector<int>& levels, Pairs& pairs) : levels_(levels), pairs_(pairs) {}

  std::vector<int> next() {
    row_.assign(levels_.size(), -1);
    placed_.clear();
    place(fullest());
    for (const std::size_t factor : shuffled()) {
      if (row_[factor] < 0) place({factor, best(factor)});
    }
    for (std::size_t a = 0; a < row_.size(); ++a) {
      for (std::size_t b = a + 1; b < row_.size(); ++b) pairs_.cover(a, row_[a], b, row_[b]);
    }
    return row_;
  }

 private:
  struct Choice {
    std::size_t factor;
    int value;
  };

  Choice fullest() const {
    Choice choice{0, 0};
    std::size_t most = 0;
    for (std::size_t factor = 0; factor < levels_.size(); ++factor) {
      for (int value = 0; value < levels_[factor]; ++value) {
        const std::size_t open = pairs_.openWith(factor, value);
        if (open > most) {
          most = open;
          choice = {factor, value};
        }
      }
    }
    return choice;
  }

  int best(std::size_t factor) const {
    int chosen = 0;
    std::size_t most = 0, mostOpen = 0;
    for (int value = 0; value < levels_[factor]; ++value) {
      std::size_t covered = 0;
      for (const std::size_t other : placed_) {
        covered += pairs_.isOpen(factor, value, other, row_[other]);
      }
      const std::size_t open = pairs_.openWith(factor, value);
      if (covered > most || (covered == most && open > mostOpen)) {
        most = covered;
        mostOpen = open;
        chosen = value;
      }
    }
    return chosen;
  }

  void place(const Choice& choice) {
    row_[choice.factor] = choice.value;
    placed_.push_back(choice.factor);
  }

  // A fixed linear congruence: the same rows on every machine.
  std::vector<std::size_t> shuffled() {
    std::vector<std::size_t> order(levels_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t i = order.size(); i > 1; --i) {
      state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
      std::swap(order[i - 1], order[(state_ >> 33) % i]);
    }
    return order;
  }

  const std::vector<int>& levels_;
  Pairs& pairs_;
  std::vector<int> row_;
  std::vector<std::size_t> placed_;
  std::uint64_t state_ = 1;
};

}  // namespace

std::vector<std::vector<int>> pairwiseRows(const std::vector<int>& levels,
                                           const std::function<bool()>& stop) {
  std::vector<std::vector<int>> rows;
  if (levels.size() == 1) {
    for (int value = 0; value < levels[0]; ++value) rows.push_back({value});
    return rows;
  }
  Pairs pairs(levels);
  RowBuilder builder(levels, pairs);
  while (pairs.left() > 0 && !stop()) rows.push_back(builder.next());
  return rows;
}

}  // namespace orris
