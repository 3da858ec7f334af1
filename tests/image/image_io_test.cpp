#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include <orris/image/image.h>
#include <orris/image/png_file.h>
#include "support/folder_test.h"

namespace orris {
namespace {

namespace fs = std::filesystem;

class ImageIo : public test::FolderTest {
 protected:
  size_t fileCount() const {
    return size_t(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  Diagnostics diagnostics_;
};

std::string bytesOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  return bytes.str();
}

Image8 sample(int channels) {
  Image8 image(5, 3, channels);
  for (size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = std::uint8_t(i * 37 + 11);
  return image;
}

TEST_F(ImageIo, png_keeps_every_byte_whatever_its_alpha) {
  const Image8 image = sample(4);
  ASSERT_TRUE(writeImage(path("a.png"), image, diagnostics_));
  const auto read = decodeImage(bytesOf(path("a.png")), "a.png", diagnostics_);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->pixels, image.pixels);
  EXPECT_TRUE(diagnostics_.empty());
}

TEST_F(ImageIo, decoding_fills_missing_channels) {
  const int channels[] = {1, 2, 3};
  for (const int count : channels) {
    const Image8 image = sample(count);
    ASSERT_TRUE(writeImage(path("a.png"), image, diagnostics_));
    const auto read = decodeImage(bytesOf(path("a.png")), "a.png", diagnostics_);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->channels, 4);
    const std::uint8_t* from = image.at(2, 1);
    const std::uint8_t* to = read->at(2, 1);
    EXPECT_EQ(to[0], from[0]);
    EXPECT_EQ(to[1], from[count < 3 ? 0 : 1]);
    EXPECT_EQ(to[2], from[count < 3 ? 0 : 2]);
    EXPECT_EQ(to[3], count == 2 ? from[1] : 255);
  }
}

TEST_F(ImageIo, exr_keeps_floats_beyond_one_and_below_zero) {
  ImageF image(2, 2, 3);
  image.pixels = {0, -1.5f, 1e-6f, 70000, 0.1f, 3, 1, 2, 3, 4, 5, 6};
  ASSERT_TRUE(writeImage(path("a.exr"), image, diagnostics_));
  const auto read = readImage(path("a.exr"), diagnostics_);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->channels, 3);
  EXPECT_EQ(read->pixels, image.pixels);
}

TEST_F(ImageIo, integer_images_become_fractions) {
  Image8 image(1, 1, 4);
  image.pixels = {255, 51, 0, 102};
  ASSERT_TRUE(writeImage(path("a.png"), image, diagnostics_));
  ASSERT_TRUE(writeImage(path("a.exr"), image, diagnostics_));
  for (const char* name : {"a.png", "a.exr"}) {
    const auto read = readImage(path(name), diagnostics_);
    ASSERT_TRUE(read) << name;
    EXPECT_FLOAT_EQ(read->pixels[0], 1);
    EXPECT_FLOAT_EQ(read->pixels[1], 0.2f);
    EXPECT_FLOAT_EQ(read->pixels[3], 0.4f);
  }
}

TEST_F(ImageIo, png_of_16_bits_keeps_them) {
  BasicImage<std::uint16_t> image(2, 1, 1);
  image.pixels = {257 * 100, 257 * 100 + 64};  // one value of 8 bits
  std::string reason;
  const auto bytes = pngOf(image, reason);
  ASSERT_TRUE(bytes) << reason;
  std::ofstream(path("a.png"), std::ios::binary) << *bytes;
  const auto read = readImage(path("a.png"), diagnostics_);
  ASSERT_TRUE(read);
  EXPECT_FLOAT_EQ(read->pixels[0], 100.0f / 255);
  EXPECT_FLOAT_EQ(read->pixels[1], (257 * 100 + 64) / 65535.0f);
}

TEST_F(ImageIo, floats_are_rounded_and_clamped_in_png) {
  ImageF image(1, 1, 3);
  image.pixels = {0.5f, 7, -1};
  ASSERT_TRUE(writeImage(path("a.png"), image, diagnostics_));
  const auto read = decodeImage(bytesOf(path("a.png")), "a.png", diagnostics_);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->pixels, (std::vector<std::uint8_t>{128, 255, 0, 255}));
}

TEST_F(ImageIo, same_pixels_give_the_same_bytes_a_second_later) {
  const Image8 image = sample(4);
  const std::vector<std::string> names{"a.png", "a.exr", "a.tif", "a.hdr"};
  const Image8 opaque = sample(3);
  std::vector<std::string> before;
  for (const std::string& name : names) {
    ASSERT_TRUE(writeImage(path(name), name == "a.hdr" ? opaque : image, diagnostics_)) << name;
    before.push_back(bytesOf(path(name)));
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));
  for (size_t i = 0; i < names.size(); ++i) {
    ASSERT_TRUE(writeImage(path(names[i]), names[i] == "a.hdr" ? opaque : image, diagnostics_));
    EXPECT_EQ(bytesOf(path(names[i])), before[i]) << names[i];
  }
  EXPECT_EQ(fileCount(), names.size());
}

TEST_F(ImageIo, truncated_png_is_refused) {
  ASSERT_TRUE(writeImage(path("a.png"), Image8(64, 64, 4), diagnostics_));
  const std::string bytes = bytesOf(path("a.png"));
  const size_t lengths[] = {8, 20, bytes.size() / 2};
  for (const size_t length : lengths) {
    Diagnostics diagnostics;
    EXPECT_FALSE(decodeImage(bytes.substr(0, length), "/textures/a.png", diagnostics)) << length;
    ASSERT_EQ(diagnostics.size(), 1u);
    EXPECT_EQ(diagnostics[0].id, "image-decode");
    EXPECT_EQ(diagnostics[0].at.file, "/textures/a.png");
    EXPECT_EQ(diagnostics[0].message, "cannot read the image: the file is cut short");
  }
}

TEST_F(ImageIo, damaged_pixels_are_refused) {
  ASSERT_TRUE(writeImage(path("a.jpg"), Image8(64, 64, 3), diagnostics_));
  const std::string bytes = bytesOf(path("a.jpg"));
  EXPECT_FALSE(decodeImage(bytes.substr(0, 100), "a.jpg", diagnostics_));
  ASSERT_EQ(diagnostics_.size(), 1u);
  EXPECT_EQ(diagnostics_[0].message.rfind("cannot read the image: ", 0), 0u);
}

TEST_F(ImageIo, text_is_no_image_even_when_named_png) {
  EXPECT_FALSE(decodeImage("hello", "a.png", diagnostics_));
  ASSERT_EQ(diagnostics_.size(), 1u);
  EXPECT_EQ(diagnostics_[0].message, "not an image in a known format");
}

TEST_F(ImageIo, huge_header_is_refused_before_memory_is_taken) {
  ASSERT_TRUE(writeImage(path("a.png"), Image8(1, 1, 4), diagnostics_));
  std::string bytes = bytesOf(path("a.png"));
  // Width and height of a 16000x16000 image, with the checksum of that header.
  bytes.replace(16, 8, std::string("\0\0\x3e\x80\0\0\x3e\x80", 8));
  std::uint32_t crc = 0xffffffffu;
  for (size_t i = 12; i < 29; ++i) {
    crc ^= std::uint8_t(bytes[i]);
    for (int bit = 0; bit < 8; ++bit) crc = crc & 1 ? 0xedb88320u ^ (crc >> 1) : crc >> 1;
  }
  crc = ~crc;
  for (int i = 0; i < 4; ++i) bytes[29 + i] = char(crc >> (24 - 8 * i));
  EXPECT_FALSE(decodeImage(bytes, "a.png", diagnostics_));
  ASSERT_EQ(diagnostics_.size(), 1u);
  EXPECT_EQ(diagnostics_[0].message, "image of 16000x16000 with 4 channels is outside the limits");
}

TEST_F(ImageIo, missing_folder_leaves_nothing_behind) {
  EXPECT_FALSE(writeImage(path("none/a.png"), sample(4), diagnostics_));
  ASSERT_EQ(diagnostics_.size(), 1u);
  EXPECT_EQ(diagnostics_[0].id, "image-write");
  EXPECT_EQ(diagnostics_[0].at.file, path("none/a.png"));
  EXPECT_EQ(fileCount(), 0u);
}

TEST_F(ImageIo, target_that_is_a_folder_leaves_nothing_behind) {
  fs::create_directory(path("a.png"));
  EXPECT_FALSE(writeImage(path("a.png"), sample(4), diagnostics_));
  EXPECT_EQ(diagnostics_.size(), 1u);
  EXPECT_EQ(fileCount(), 1u);
}

TEST_F(ImageIo, failed_write_keeps_the_old_file) {
  ASSERT_TRUE(writeImage(path("a.hdr"), sample(3), diagnostics_));
  const std::string before = bytesOf(path("a.hdr"));
  // HDR files hold no alpha.
  Image8 empty(0, 0, 4);
  EXPECT_FALSE(writeImage(path("a.hdr"), empty, diagnostics_));
  EXPECT_EQ(bytesOf(path("a.hdr")), before);
  EXPECT_EQ(fileCount(), 1u);
}

TEST_F(ImageIo, unknown_extension_is_named) {
  EXPECT_FALSE(writeImage(path("a.nothing"), sample(4), diagnostics_));
  ASSERT_EQ(diagnostics_.size(), 1u);
  EXPECT_EQ(diagnostics_[0].message, "no image format has the extension \".nothing\"");
  EXPECT_FALSE(writeImage(path("a"), sample(4), diagnostics_));
  EXPECT_EQ(diagnostics_[1].message, "no image format has the extension \"\"");
  EXPECT_EQ(fileCount(), 0u);
}

TEST_F(ImageIo, missing_file_is_reported_with_its_name) {
  EXPECT_FALSE(readImage(path("none.png"), diagnostics_));
  ASSERT_EQ(diagnostics_.size(), 1u);
  EXPECT_EQ(diagnostics_[0].id, "image-read");
  EXPECT_EQ(diagnostics_[0].at.file, path("none.png"));
}

}  // namespace
}  // namespace orris
