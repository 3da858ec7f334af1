// LZ4 as the game's library for Java writes it: blocks, each with a header that starts with "LZ4Block".
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <orris/world/files/gunzip.h>

namespace orris {

/// Appends at most `limit` bytes to `output`. Checksums are not compared: what is damaged shows in the tags.
GunzipResult unpackLz4Blocks(std::string_view input, std::size_t limit, std::string& output);

}  // namespace orris
