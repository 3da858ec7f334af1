#include <orris/image/png_file.h>

#include <png.h>

#include <algorithm>
#include <bit>
#include <csetjmp>
#include <cstring>

#include <orris/image/image_size.h>

namespace orris {
namespace {

/// What libpng is given with each of its calls.
struct PngState {
  std::string reason = "out of memory";
  const std::string* bytes = nullptr;  ///< read from
  std::size_t at = 0;
  std::string* written = nullptr;
};

void keepReason(png_structp png, const char* message) {
  static_cast<PngState*>(png_get_error_ptr(png))->reason = message;
  png_longjmp(png, 1);
}

void ignoreWarning(png_structp, const char*) {}

void giveBytes(png_structp png, png_bytep to, std::size_t count) {
  PngState& state = *static_cast<PngState*>(png_get_io_ptr(png));
  if (count > state.bytes->size() - state.at) png_error(png, "the file is cut short");
  std::memcpy(to, state.bytes->data() + state.at, count);
  state.at += count;
}

void takeBytes(png_structp png, png_bytep from, std::size_t count) {
  static_cast<PngState*>(png_get_io_ptr(png))->written->append(reinterpret_cast<char*>(from), count);
}

void flushNothing(png_structp) {}

/// Frees what libpng allocated, also where it left a function by longjmp.
class PngReading {
 public:
  explicit PngReading(PngState& state)
      : png(png_create_read_struct(PNG_LIBPNG_VER_STRING, &state, keepReason, ignoreWarning)),
        info(png_create_info_struct(png)) {
    png_set_read_fn(png, &state, giveBytes);
    // Text and profiles of colour are not looked at.
    png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
    png_set_user_limits(png, 0x7fffffff, 0x7fffffff);  // the caller's are lower, and say more
  }
  ~PngReading() { png_destroy_read_struct(&png, &info, nullptr); }
  PngReading(const PngReading&) = delete;
  PngReading& operator=(const PngReading&) = delete;

  png_structp png;
  png_infop info;
};

class PngWriting {
 public:
  explicit PngWriting(PngState& state)
      : png(png_create_write_struct(PNG_LIBPNG_VER_STRING, &state, keepReason, ignoreWarning)),
        info(png_create_info_struct(png)) {
    png_set_write_fn(png, &state, takeBytes, flushNothing);
  }
  ~PngWriting() { png_destroy_write_struct(&png, &info); }
  PngWriting(const PngWriting&) = delete;
  PngWriting& operator=(const PngWriting&) = delete;

  png_structp png;
  png_infop info;
};

// The three functions below are left by longjmp: none holds an object with a destructor.

bool readHeader(png_structp png, png_infop info, PngHeader& header) {
  if (png == nullptr || info == nullptr || setjmp(png_jmpbuf(png)) != 0) return false;
  png_read_info(png, info);
  header.bits = int(png_get_bit_depth(png, info));
  png_set_expand(png);
  png_set_scale_16(png);
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
  header.width = int(png_get_image_width(png, info));
  header.height = int(png_get_image_height(png, info));
  header.channels = int(png_get_channels(png, info));
  return true;
}

bool readRows(png_structp png, png_infop info, png_bytepp rows) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_read_image(png, rows);
  png_read_end(png, info);
  return true;
}

bool writeRows(png_structp png, png_infop info, const PngHeader& header, int bits, png_bytepp rows) {
  constexpr int kColours[] = {PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB,
                              PNG_COLOR_TYPE_RGB_ALPHA};
  if (png == nullptr || info == nullptr || setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_IHDR(png, info, png_uint_32(header.width), png_uint_32(header.height), bits,
               kColours[header.channels - 1], PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  if (bits == 16 && std::endian::native == std::endian::little) png_set_swap(png);
  png_write_image(png, rows);
  png_write_end(png, nullptr);
  return true;
}

template <class T>
std::vector<png_bytep> rowsOf(const BasicImage<T>& image) {
  std::vector<png_bytep> rows;
  // libpng takes no const rows, but writes none of those that it is given to write.
  for (int y = 0; y < image.height; ++y)
    rows.push_back(reinterpret_cast<png_bytep>(const_cast<T*>(image.at(0, y))));
  return rows;
}

template <class T>
std::optional<std::string> encode(const BasicImage<T>& image, std::string& reason) {
  const PngHeader header{image.width, image.height, image.channels};
  if (image.width < 1 || image.height < 1 || image.channels < 1 || image.channels > 4) {
    reason = "a PNG has 1 to 4 channels and at least one pixel";
    return std::nullopt;
  }
  std::string bytes;
  PngState state;
  state.written = &bytes;
  PngWriting writing(state);
  std::vector<png_bytep> rows = rowsOf(image);
  if (writeRows(writing.png, writing.info, header, int(sizeof(T)) * 8, rows.data())) return bytes;
  reason = state.reason;
  return std::nullopt;
}

}  // namespace

std::optional<PngHeader> readPngHeader(const std::string& bytes, std::string& reason) {
  PngState state;
  state.bytes = &bytes;
  PngReading reading(state);
  PngHeader header;
  if (readHeader(reading.png, reading.info, header)) return header;
  reason = state.reason;
  return std::nullopt;
}

std::optional<Image8> decodePng(const std::string& bytes, std::string& reason) {
  PngState state;
  state.bytes = &bytes;
  PngReading reading(state);
  PngHeader header;
  std::optional<Image8> image;
  if (readHeader(reading.png, reading.info, header)) {
    image.emplace(header.width, header.height, header.channels);
    std::vector<png_bytep> rows = rowsOf(*image);
    if (readRows(reading.png, reading.info, rows.data())) return image;
  }
  reason = state.reason;
  return std::nullopt;
}

std::optional<std::string> pngOf(const Image8& image, std::string& reason) {
  return encode(image, reason);
}

std::optional<std::string> pngOf(const BasicImage<std::uint16_t>& image, std::string& reason) {
  return encode(image, reason);
}

}  // namespace orris
