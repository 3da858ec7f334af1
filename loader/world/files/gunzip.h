// Bounded decompression of gzip and zlib streams.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace orris {

enum class GunzipResult { Ok, Truncated, Corrupt, TooLarge };

/// Appends at most `limit` bytes to `output`. Trailing bytes after the stream are ignored.
GunzipResult gunzip(std::string_view input, std::size_t limit, std::string& output);

}  // namespace orris
