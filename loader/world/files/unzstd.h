// Bounded decompression of Zstandard frames.
#pragma once

#include <orris/world/files/gunzip.h>

namespace orris {

/// Appends at most `limit` bytes of the first frame to `output`. Frames that need a window of more than 16 MiB are Corrupt.
GunzipResult unzstd(std::string_view input, std::size_t limit, std::string& output);

}  // namespace orris
