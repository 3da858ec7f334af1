// What this process may use of the machine.
#pragma once

#include <sys/resource.h>

namespace orris {

/// Lowers both limits of a resource (RLIMIT_...) for good, to `most` or what the hard limit leaves.
void limitTo(__rlimit_resource resource, rlim_t most);

/// The same for addresses; 0: as many as before. Nothing is limited where a sanitizer reserves terabytes of them.
void limitAddresses(rlim_t most);

}  // namespace orris
