#include <orris/core/process_limits.h>

#include <algorithm>

namespace orris {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitizerReserves = true;
#elif defined(__has_feature)
constexpr bool kSanitizerReserves = __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
constexpr bool kSanitizerReserves = false;
#endif

}  // namespace

void limitTo(__rlimit_resource resource, rlim_t most) {
  rlimit limit{};
  getrlimit(resource, &limit);
  most = std::min(most, limit.rlim_max);
  limit = {most, most};
  setrlimit(resource, &limit);
}

void limitAddresses(rlim_t most) {
  if (!kSanitizerReserves && most != 0) limitTo(RLIMIT_AS, most);
}

}  // namespace orris
