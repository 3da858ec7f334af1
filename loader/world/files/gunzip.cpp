#include <orris/world/files/gunzip.h>

#include <zlib.h>

#include <algorithm>
#include <limits>

namespace orris {
namespace {

constexpr std::size_t kChunk = 1 << 16;
constexpr int kAnyHeader = 15 + 32;  // largest window, gzip or zlib by its header

GunzipResult inflateAll(z_stream& stream, std::size_t limit, std::string& output) {
  std::string chunk(kChunk, '\0');
  while (true) {
    stream.next_out = reinterpret_cast<Bytef*>(chunk.data());
    stream.avail_out = kChunk;
    const int status = inflate(&stream, Z_NO_FLUSH);
    const std::size_t produced = kChunk - stream.avail_out;
    if (output.size() + produced > limit) return GunzipResult::TooLarge;
    output.append(chunk, 0, produced);
    if (status == Z_STREAM_END) return GunzipResult::Ok;
    if (status == Z_BUF_ERROR || (status == Z_OK && stream.avail_in == 0 && produced == 0)) {
      return GunzipResult::Truncated;
    }
    if (status != Z_OK) return GunzipResult::Corrupt;
  }
}

}  // namespace

GunzipResult gunzip(std::string_view input, std::size_t limit, std::string& output, std::size_t* used) {
  if (input.size() > std::numeric_limits<uInt>::max()) return GunzipResult::TooLarge;
  z_stream stream{};
  // zlib takes its input as non-const but does not write to it.
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(input.data()));
  stream.avail_in = uInt(input.size());
  if (inflateInit2(&stream, kAnyHeader) != Z_OK) return GunzipResult::Corrupt;
  const GunzipResult result = inflateAll(stream, limit, output);
  if (used) *used = input.size() - stream.avail_in;
  inflateEnd(&stream);
  return result;
}

}  // namespace orris
