// Names that matter to a caller, and which of them a text was asked about. With the options of a
// pack as names it says which options can change a text: two values of an option give the same
// text unless a condition or an expansion looks its name up.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace orris {

struct NameWatch {
  static constexpr unsigned char kText = 1;       ///< looked up in text that is kept
  static constexpr unsigned char kCondition = 2;  ///< asked for by #if, #ifdef, #elif or defined

  /// `watched` must outlive this.
  explicit NameWatch(const std::vector<std::string>& watched)
      : names(watched), uses(watched.size(), 0) {}

  /// The names with any of the uses in `mask`, in the order of `names`.
  std::vector<std::string> used(unsigned char mask = kText | kCondition) const {
    std::vector<std::string> result;
    for (std::size_t i = 0; i < uses.size(); ++i) {
      if (uses[i] & mask) result.push_back(names[i]);
    }
    return result;
  }

  const std::vector<std::string>& names;
  std::vector<unsigned char> uses;  ///< by index into `names`
};

}  // namespace orris
