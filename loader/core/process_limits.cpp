#include <orris/core/process_limits.h>

#include <algorithm>

namespace orris {

void limitTo(__rlimit_resource resource, rlim_t most) {
  rlimit limit{};
  getrlimit(resource, &limit);
  most = std::min(most, limit.rlim_max);
  limit = {most, most};
  setrlimit(resource, &limit);
}

}  // namespace orris
