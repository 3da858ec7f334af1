// PNG files in memory. What else reads and writes them: image_io_test.cpp.
#include <gtest/gtest.h>
#include <zlib.h>

#include <orris/image/png_file.h>

namespace orris {
namespace {

void add32(std::string& bytes, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(char(value >> shift & 255));
}

void addChunk(std::string& png, const std::string& type, const std::string& data) {
  add32(png, std::uint32_t(data.size()));
  png += type + data;
  const std::string checked = type + data;
  add32(png, std::uint32_t(crc32(0, reinterpret_cast<const Bytef*>(checked.data()), uInt(checked.size()))));
}

/// One row of one pixel or more; `before` are chunks before the pixels.
std::string pngOfRow(int width, int bits, int colours, const std::string& row,
                     const std::vector<std::pair<std::string, std::string>>& before = {}) {
  std::string png = "\x89PNG\r\n\x1a\n", header;
  add32(header, std::uint32_t(width));
  add32(header, 1);
  header += {char(bits), char(colours), 0, 0, 0};
  addChunk(png, "IHDR", header);
  for (const auto& [type, data] : before) addChunk(png, type, data);
  const std::string raw = std::string(1, '\0') + row;
  std::string packed(compressBound(raw.size()), '\0');
  uLongf size = packed.size();
  compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(raw.data()), raw.size());
  addChunk(png, "IDAT", packed.substr(0, size));
  addChunk(png, "IEND", "");
  return png;
}

std::vector<std::uint8_t> pixelsOf(const std::string& png, int channels) {
  std::string reason;
  const auto header = readPngHeader(png, reason);
  const auto image = decodePng(png, reason);
  if (!header || !image) return ADD_FAILURE() << reason, std::vector<std::uint8_t>();
  EXPECT_EQ(header->channels, channels);
  EXPECT_EQ(image->channels, channels);
  return image->pixels;
}

using Pixels = std::vector<std::uint8_t>;

TEST(PngFile, sixteen_bits_are_rounded_to_eight) {
  EXPECT_EQ(pixelsOf(pngOfRow(3, 16, 0, std::string("\x80\x00\x7f\x7f\xff\xff", 6)), 1), (Pixels{128, 127, 255}));
}

TEST(PngFile, fewer_bits_are_spread_over_all_values) {
  EXPECT_EQ(pixelsOf(pngOfRow(4, 1, 0, "\xa0"), 1), (Pixels{255, 0, 255, 0}));
  EXPECT_EQ(pixelsOf(pngOfRow(2, 4, 0, "\x5f"), 1), (Pixels{85, 255}));
}

TEST(PngFile, a_palette_becomes_its_colours_and_their_transparency) {
  const std::string colours("\x0a\x14\x1e\x28\x32\x3c", 6);
  EXPECT_EQ(pixelsOf(pngOfRow(2, 8, 3, std::string("\1\0", 2), {{"PLTE", colours}}), 3),
            (Pixels{40, 50, 60, 10, 20, 30}));
  EXPECT_EQ(pixelsOf(pngOfRow(2, 8, 3, std::string("\1\0", 2), {{"PLTE", colours}, {"tRNS", "\x07"}}), 4),
            (Pixels{40, 50, 60, 255, 10, 20, 30, 7}));
}

TEST(PngFile, a_transparent_colour_becomes_alpha) {
  EXPECT_EQ(pixelsOf(pngOfRow(2, 8, 2, "abcdef", {{"tRNS", std::string("\0a\0b\0c", 6)}}), 4),
            (Pixels{'a', 'b', 'c', 0, 'd', 'e', 'f', 255}));
}

TEST(PngFile, gamma_and_profiles_of_colour_do_not_change_what_is_stored) {
  EXPECT_EQ(pixelsOf(pngOfRow(1, 8, 2, "abc", {{"gAMA", std::string("\0\0\xb1\x8f", 4)}}), 3), (Pixels{'a', 'b', 'c'}));
  EXPECT_EQ(pixelsOf(pngOfRow(1, 8, 2, "abc", {{"iCCP", std::string("x\0\0no profile", 13)}}), 3),
            (Pixels{'a', 'b', 'c'}));
}

TEST(PngFile, sixteen_bits_are_written_and_read) {
  BasicImage<std::uint16_t> image(2, 1, 4);
  image.pixels = {0, 257, 514, 65535, 32896, 771, 1028, 1285};
  std::string reason;
  const auto bytes = pngOf(image, reason);
  ASSERT_TRUE(bytes) << reason;
  EXPECT_EQ(pixelsOf(*bytes, 4), (Pixels{0, 1, 2, 255, 128, 3, 4, 5}));
}

TEST(PngFile, damage_is_refused_with_a_reason) {
  const std::string good = pngOfRow(2, 8, 2, "abcdef");
  for (std::size_t at = 8; at < good.size() - 12; ++at) {
    std::string bad = good, reason;
    bad[at] = char(bad[at] ^ 0x55);
    const bool read = decodePng(bad, reason).has_value();
    EXPECT_EQ(read, reason.empty()) << at;
  }
  std::string reason;
  EXPECT_FALSE(decodePng(pngOfRow(5, 8, 2, "abcdef"), reason));
  EXPECT_FALSE(decodePng(pngOfRow(2, 7, 2, "abcdef"), reason));
  EXPECT_FALSE(decodePng("", reason));
  EXPECT_EQ(reason, "the file is cut short");
}

TEST(PngFile, no_pixels_and_five_channels_are_no_png) {
  std::string reason;
  EXPECT_FALSE(pngOf(Image8(0, 3, 4), reason));
  EXPECT_FALSE(pngOf(Image8(2, 2, 5), reason));
  EXPECT_EQ(reason, "a PNG has 1 to 4 channels and at least one pixel");
}

}  // namespace
}  // namespace orris
