#include <orris/check/workers/shared_hashes.h>

#include <sys/mman.h>

#include <bit>

namespace orris {
namespace {

constexpr std::size_t kLongestSearch = 1024;

}  // namespace

static_assert(std::atomic<std::uint64_t>::is_always_lock_free);

SharedHashes::SharedHashes(std::size_t capacity) : size_(std::bit_ceil(capacity + 1)) {
  // Anonymous memory is zero, which is an empty slot.
  void* memory = mmap(nullptr, size_ * sizeof *slots_, PROT_READ | PROT_WRITE,
                      MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  slots_ = memory == MAP_FAILED ? nullptr : static_cast<std::atomic<std::uint64_t>*>(memory);
}

SharedHashes::~SharedHashes() {
  if (slots_) munmap(static_cast<void*>(slots_), size_ * sizeof *slots_);
}

bool SharedHashes::insert(std::uint64_t hash) {
  if (!slots_) return true;
  if (hash == 0) hash = 1;
  for (std::size_t i = 0; i < kLongestSearch; ++i) {
    std::uint64_t empty = 0;
    auto& slot = slots_[(hash + i) & (size_ - 1)];
    if (slot.compare_exchange_strong(empty, hash)) return true;
    if (empty == hash) return false;
  }
  return true;
}

bool SharedHashes::contains(std::uint64_t hash) const {
  if (!slots_) return false;
  if (hash == 0) hash = 1;
  for (std::size_t i = 0; i < kLongestSearch; ++i) {
    const std::uint64_t slot = slots_[(hash + i) & (size_ - 1)];
    if (slot == hash) return true;
    if (slot == 0) return false;
  }
  return false;
}

}  // namespace orris
