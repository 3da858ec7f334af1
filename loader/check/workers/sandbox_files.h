// Files that a worker has no use for, refused by the kernel: Landlock.
#pragma once

#include <string>
#include <vector>

namespace orris {

/// What a process may become.
enum class Programs { Refused, Installed };

/// Of Landlock's interface in this kernel, 0: it has none.
int landlockVersion();

/// From now on this thread, and those it starts, can read what is installed on the system and `readable`,
/// and write in `cache` ("": none) and /dev/null. Nothing happens without Landlock.
void restrictFiles(const std::vector<std::string>& readable, const std::string& cache, Programs programs);

}  // namespace orris
