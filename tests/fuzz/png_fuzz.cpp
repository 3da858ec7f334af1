// Any bytes as a PNG: a picture of the size that its header states, or a reason. What was read is written and read again.
#include <cstdint>
#include <cstdlib>
#include <string>

#include <orris/image/png_file.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  std::string reason;
  const auto header = orris::readPngHeader(bytes, reason);
  if (!header && reason.empty()) std::abort();
  // Callers bound the size; here it is bounded so that an input takes no time.
  if (!header || header->width > 256 || header->height > 256) return 0;
  const auto image = orris::decodePng(bytes, reason);
  if (!image) return reason.empty() ? std::abort(), 0 : 0;
  if (image->width != header->width || image->height != header->height || image->channels != header->channels)
    std::abort();
  const auto written = orris::pngOf(*image, reason);
  if (!written) std::abort();
  const auto again = orris::decodePng(*written, reason);
  if (!again || again->pixels != image->pixels) std::abort();
  return 0;
}
