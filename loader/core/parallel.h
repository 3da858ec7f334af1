// Work on many independent parts by all cores.
#pragma once

#include <cstddef>
#include <functional>

namespace orris {

/// Calls `work(i)` once for every i below `count`, on as many threads as there are cores, in no
/// particular order; returns when all are done. An exception of one call is thrown again here, after
/// the calls under way have ended; what had not begun is then left out.
void forEachInParallel(std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace orris
