// Bounded decompression of gzip and zlib streams.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace orris {

enum class GunzipResult { Ok, Truncated, Corrupt, TooLarge };

/// Appends at most `limit` bytes to `output`. Bytes after the stream are ignored; `used`: how many bytes the stream has.
GunzipResult gunzip(std::string_view input, std::size_t limit, std::string& output, std::size_t* used = nullptr);

}  // namespace orris
