#include <orris/check/hints/trial_memo.h>

#include <algorithm>
#include <cstring>

#include <orris/check/workers/diagnostic_codec.h>

namespace orris {
namespace {

template <typename T>
void append(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// Takes it off the front; 0 when nothing is left.
template <typename T>
T takeValue(std::string_view& bytes) {
  T value{};
  const std::size_t size = std::min(sizeof value, bytes.size());
  std::memcpy(&value, bytes.data(), size);
  bytes.remove_prefix(size);
  return value;
}

}  // namespace

std::optional<int> TrialMemo::find(std::uint64_t trial) const {
  const auto known = known_.find(trial);
  return known == known_.end() ? std::nullopt : std::optional(known->second);
}

void TrialMemo::add(std::uint64_t trial, int outcome) {
  known_[trial] = outcome;
  added_.emplace_back(trial, outcome);
}

std::string TrialMemo::encode(const Diagnostics& diagnostics) {
  std::string bytes;
  append(bytes, std::uint64_t(added_.size()));
  for (const auto& [trial, outcome] : added_) {
    append(bytes, trial);
    append(bytes, outcome);
  }
  added_.clear();
  return bytes + encodeDiagnostics(diagnostics);
}

Diagnostics TrialMemo::decode(std::string_view bytes) {
  const auto count = takeValue<std::uint64_t>(bytes);
  for (std::uint64_t i = 0; i < count && !bytes.empty(); ++i) {
    const auto trial = takeValue<std::uint64_t>(bytes);
    known_[trial] = takeValue<int>(bytes);
    ++made_;
  }
  return decodeDiagnostics(bytes);
}

}  // namespace orris
