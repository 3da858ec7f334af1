#include <orris/image/image_size.h>

#include <charconv>

namespace orris {
namespace {

bool parseSide(std::string_view text, int& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() && value >= 1 &&
         value <= kMaxSide;
}

}  // namespace

std::optional<ImageSize> parseImageSize(std::string_view text) {
  const std::size_t cross = text.find('x');
  ImageSize size;
  if (cross == std::string_view::npos || !parseSide(text.substr(0, cross), size.width) ||
      !parseSide(text.substr(cross + 1), size.height) || long(size.width) * size.height > kMaxPixels)
    return std::nullopt;
  return size;
}

}  // namespace orris
