// What trials of lines that seem to be missing came to: a pack that is checked again with an edit asks
// for most of them again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <orris/core/diagnostic.h>

namespace orris {

/// Outcomes by a hash of all that decides them. Trials are made in workers, which hand over what they
/// learnt with the diagnostics of their job.
class TrialMemo {
 public:
  std::optional<int> find(std::uint64_t trial) const;
  void add(std::uint64_t trial, int outcome);

  /// The diagnostics, and what was added since the last call.
  std::string encode(const Diagnostics& diagnostics);
  /// Both of a worker; the diagnostics are returned.
  Diagnostics decode(std::string_view bytes);

  /// So many trials the workers made.
  std::size_t made() const { return made_; }

 private:
  std::map<std::uint64_t, int> known_;
  std::vector<std::pair<std::uint64_t, int>> added_;
  std::size_t made_ = 0;
};

}  // namespace orris
