// A set of hashes that forked processes share, so that no two of them do the same work.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>

namespace orris {

class SharedHashes {
 public:
  /// `capacity` is rounded up to a power of two; workers forked later see the same set.
  explicit SharedHashes(std::size_t capacity);
  ~SharedHashes();
  SharedHashes(const SharedHashes&) = delete;
  SharedHashes& operator=(const SharedHashes&) = delete;

  /// False when it is there already. A set that is full takes everything for new.
  bool insert(std::uint64_t hash);
  bool contains(std::uint64_t hash) const;

 private:
  std::size_t size_;
  std::atomic<std::uint64_t>* slots_;
};

}  // namespace orris
